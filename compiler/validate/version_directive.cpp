// Both directives stand first in their line, perhaps behind spaces; `#version` may have comments before it. Nothing more of
// GLSL is needed here: whether the directive is well-formed is glslang's to say.

#include "validate/version_directive.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace plugc {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r";

void skip(std::string_view& text, std::string_view characters) {
  text.remove_prefix(std::min(text.find_first_not_of(characters), text.size()));
}

/// Behind a comment at the start of `text`; false when there is none.
bool skip_comment(std::string_view& text) {
  const bool line = text.starts_with("//");
  if (!line && !text.starts_with("/*")) return false;
  const std::size_t end = line ? text.find('\n', 2) : text.find("*/", 2);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + (line ? 1 : 2));
  return true;
}

/// `# name` at the start of `text`, behind blanks.
bool take_directive(std::string_view& text, std::string_view name) {
  std::string_view rest = text;
  skip(rest, kBlanks);
  if (!rest.starts_with('#')) return false;
  rest.remove_prefix(1);
  skip(rest, kBlanks);
  if (!rest.starts_with(name)) return false;
  text = rest.substr(name.size());
  return true;
}

std::string shown(const WrittenVersion& version) {
  return version.profile.empty() ? fmt::format("#version {}", version.number)
                                 : fmt::format("#version {} {}", version.number, version.profile);
}

}  // namespace

WrittenVersion read_version_directive(std::string_view text) {
  std::string_view rest = text;
  do {
    skip(rest, " \t\v\f\r\n");
  } while (skip_comment(rest));
  WrittenVersion version;
  const auto before = static_cast<std::ptrdiff_t>(text.size() - rest.size());
  if (!take_directive(rest, "version")) return version;
  version.line = 1 + static_cast<std::uint32_t>(std::count(text.begin(), text.begin() + before, '\n'));
  rest = rest.substr(0, rest.find('\n'));
  skip(rest, kBlanks);
  const auto number = std::from_chars(rest.data(), rest.data() + rest.size(), version.number);
  rest.remove_prefix(static_cast<std::size_t>(number.ptr - rest.data()));
  skip(rest, kBlanks);
  version.profile = rest.substr(0, rest.find_first_of(" \t\v\f\r/"));
  return version;
}

bool fits(const WrittenVersion& version, Target target) {
  const bool embedded = version.profile == "es" || version.number == 100;
  switch (target) {
    case Target::glsl330:  // a core context knows nothing below 140
      return !embedded && version.profile != "compatibility" && version.number >= 140 && version.number <= 330;
    case Target::essl300: return version.number == 300 && version.profile == "es";
    case Target::spirv: return !embedded && version.profile != "compatibility" && version.number >= 330;
  }
  return false;
}

std::string mismatch_text(const WrittenVersion& version, Target target) {
  constexpr std::string_view kNeeds[] = {"`#version 140` to `#version 330 core`", "`#version 300 es`",
                                         "at least `#version 330 core`"};
  const std::string_view needs = kNeeds[static_cast<std::size_t>(target)];
  if (version.number == 0) return fmt::format("there is no `#version`; target {} needs {}", to_text(target), needs);
  return fmt::format("`{}` does not fit target {}, which needs {}", shown(version), to_text(target), needs);
}

std::optional<std::string> without_line_directives(std::string_view text) {
  std::optional<std::string> blanked;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (take_directive(line, "line")) {
      if (!blanked) blanked = std::string(text);
      blanked->replace(begin, end - begin, end - begin, ' ');
    }
    begin = end + 1;
  }
  return blanked;
}

}  // namespace plugc

// Cutting goes line by line with a stack of "is this branch taken"; numbering goes token by token.

#include "compose/templates.h"

#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "base/check.h"
#include "glsl/edit.h"
#include "stdlib_plugs/stdlib_plugs.h"

namespace plugc {
namespace {

/// `#ifdef NAME` -> NAME.
std::string_view directive_name(std::string_view line, std::string_view directive) {
  std::string_view name = line.substr(directive.size());
  name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
  return name.substr(0, name.find_first_of(" \r\n"));
}

struct Branches {
  std::vector<bool> taken;
  bool all_taken() const {
    for (const bool branch : taken) {
      if (!branch) return false;
    }
    return true;
  }
};

/// True when the line is a feature directive, which is then obeyed.
bool obey_directive(std::string_view line, const Features& features, Branches& branches) {
  if (line.starts_with("#ifdef")) {
    branches.taken.push_back(features.contains(directive_name(line, "#ifdef")));
  } else if (line.starts_with("#ifndef")) {
    branches.taken.push_back(!features.contains(directive_name(line, "#ifndef")));
  } else if (line.starts_with("#else")) {
    PLUGC_CHECK(!branches.taken.empty(), "#else has its #ifdef");
    branches.taken.back() = !branches.taken.back();
  } else if (line.starts_with("#endif")) {
    PLUGC_CHECK(!branches.taken.empty(), "#endif has its #ifdef");
    branches.taken.pop_back();
  } else {
    return false;
  }
  return true;
}

/// Where the number goes in a name like `castle_LightSourceNColor`: a capital N behind `Source`, `Coord`, `Matrix` or `_`,
/// at the end or before another capital; npos when there is none.
std::size_t number_place(std::string_view name) {
  for (std::size_t at = name.find('N'); at != std::string_view::npos; at = name.find('N', at + 1)) {
    const std::string_view before = name.substr(0, at);
    const bool behind = before.ends_with("Source") || before.ends_with("Coord") || before.ends_with("Matrix") || before.ends_with('_');
    const bool ends = at + 1 == name.size() || std::isupper(static_cast<unsigned char>(name[at + 1])) != 0;
    if (behind && ends && before.size() > 1) return at;
  }
  return std::string_view::npos;
}

}  // namespace

MappedText cut_template(const SourceSet& sources, SourceId source, const Features& features) {
  const std::string_view text = sources.text(source);
  MappedText cut;
  Branches branches;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string_view line = text.substr(begin, end - begin);
    if (!obey_directive(line, features, branches) && branches.all_taken()) {
      cut.append(line, source, static_cast<std::uint32_t>(begin));
    }
    begin = end;
  }
  PLUGC_CHECK(branches.taken.empty(), "every #ifdef of a template is closed");
  return cut;
}

MappedText number_names(const MappedText& text, int number) {
  std::vector<Edit> edits;
  const TokenList list = tokenize(text.text(), {});
  for (const Token& token : list.tokens) {
    if (token.kind != TokenKind::identifier && token.kind != TokenKind::marker) continue;
    std::string_view rest = token_text(text.text(), token);
    std::uint32_t at = token.begin;
    while (!rest.empty()) {  // a marker holds several names
      const std::size_t begin = rest.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_");
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(
          rest.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789", begin), rest.size());
      const std::size_t place = number_place(rest.substr(begin, end - begin));
      if (place != std::string_view::npos) {
        const auto from = static_cast<std::uint32_t>(at + begin + place);
        edits.push_back({from, from + 1, std::to_string(number), {}});
      }
      at += static_cast<std::uint32_t>(end);
      rest.remove_prefix(end);
    }
  }
  return apply_edits(text, std::move(edits));
}

SourceId TemplateLibrary::source(std::string_view name) {
  if (const auto found = loaded_.find(name); found != loaded_.end()) return found->second;
  const SourceId id = sources_->add(fmt::format("plugc:/templates/{}", name),
                                    std::string(stdlib_text(fmt::format("templates/{}", name))));
  loaded_.emplace(name, id);
  return id;
}

std::shared_ptr<const CodeUnit> TemplateLibrary::get(std::string_view name, ShaderStage stage, const Features& features, int number) {
  const auto [found, added] = made_.try_emplace(Key{std::string(name), stage, features, number});
  if (added) {
    MappedText text = cut_template(*sources_, source(name), features);
    if (number >= 0) text = number_names(text, number);
    found->second = make_code_unit(text, stage);
  }
  return found->second;
}

}  // namespace plugc

// Cutting goes from directive to directive with a stack of "is this branch taken"; numbering goes from one capital N to the
// next. Templates are in GLSL 3.30 with castle_ names already (a test holds them to it), so they are not upgraded as authors'
// texts are: that took a quarter of all composing.

#include "compose/templates.h"

#include <algorithm>
#include <cctype>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "base/check.h"
#include "glsl/edit.h"
#include "glsl/scan.h"
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

bool is_feature_directive(std::string_view line) {
  return line.starts_with("#if") || line.starts_with("#else") || line.starts_with("#endif");
}

void obey_directive(std::string_view line, const Features& features, Branches& branches) {
  if (line.starts_with("#ifdef")) {
    branches.taken.push_back(features.contains(directive_name(line, "#ifdef")));
  } else if (line.starts_with("#ifndef")) {
    branches.taken.push_back(!features.contains(directive_name(line, "#ifndef")));
  } else {
    PLUGC_CHECK(!branches.taken.empty(), "#else and #endif have their #ifdef");
    if (line.starts_with("#endif"))
      branches.taken.pop_back();
    else
      branches.taken.back() = !branches.taken.back();
  }
}

constexpr std::string_view kWordCharacters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";

/// Where the number goes in a name like `castle_LightSourceNColor`: a capital N behind `Source`, `Coord`, `Matrix` or `_`,
/// at the end or before another capital; npos when there is none.
std::size_t number_place(std::string_view name) {
  for (std::size_t at = name.find('N'); at != std::string_view::npos; at = name.find('N', at + 1)) {
    const std::string_view before = name.substr(0, at);
    const bool behind =
        before.ends_with("Source") || before.ends_with("Coord") || before.ends_with("Matrix") || before.ends_with('_');
    const bool ends = at + 1 == name.size() || std::isupper(static_cast<unsigned char>(name[at + 1])) != 0;
    if (behind && ends && before.size() > 1) return at;
  }
  return std::string_view::npos;
}

/// Adds the castle_ names among the tokens, each once.
void note_castle_names(CodeUnit& unit, std::span<const Token> tokens) {
  for (const Token& token : tokens) {
    const std::string_view name = unit.at(token);
    const bool is_castle = token.kind == TokenKind::identifier && name.starts_with("castle_");
    if (is_castle && std::ranges::find(unit.castle_names, name) == unit.castle_names.end())
      unit.castle_names.emplace_back(name);
  }
}

std::shared_ptr<const CodeUnit> make_template_unit(MappedText text) {
  auto unit = std::make_shared<CodeUnit>();
  unit->text = std::move(text);
  const std::string_view bytes = unit->text.text();
  unit->tokens = tokenize(bytes, {});
  unit->outline = outline(bytes, unit->tokens, Storage::none);
  note_plugs(*unit);
  note_castle_names(*unit, unit->tokens.tokens);
  for (const MarkerOutline& marker : unit->outline.markers) {
    const auto begin = static_cast<std::uint32_t>(marker.arguments.empty() ? 0 : marker.arguments.data() - bytes.data());
    note_castle_names(*unit, scan_range(bytes, begin, begin + static_cast<std::uint32_t>(marker.arguments.size())));
  }
  return unit;
}

}  // namespace

MappedText cut_template(const SourceSet& sources, SourceId source, const Features& features) {
  const std::string_view text = sources.text(source);
  MappedText cut;
  Branches branches;
  std::size_t kept = 0;  // what follows is kept where all branches are taken, and not yet appended
  const auto append_up_to = [&](std::size_t end) {
    if (branches.all_taken()) cut.append(text.substr(kept, end - kept), source, static_cast<std::uint32_t>(kept));
  };
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = text.substr(at, end - at);
    if (!is_feature_directive(line) || (at > 0 && text[at - 1] != '\n')) continue;
    append_up_to(at);
    obey_directive(line, features, branches);
    kept = end;
  }
  PLUGC_CHECK(branches.taken.empty(), "every #ifdef of a template is closed");
  append_up_to(text.size());
  return cut;
}

MappedText number_names(const MappedText& text, int number) {
  std::vector<Edit> edits;
  const std::string_view bytes = text.text();
  for (std::size_t at = bytes.find('N'); at != std::string_view::npos; at = bytes.find('N', at)) {
    const std::size_t begin = bytes.find_last_not_of(kWordCharacters, at) + 1;
    const std::size_t end = std::min(bytes.find_first_not_of(kWordCharacters, at), bytes.size());
    const std::size_t place = number_place(bytes.substr(begin, end - begin));
    if (place != std::string_view::npos) {
      const auto from = static_cast<std::uint32_t>(begin + place);
      edits.push_back({from, from + 1, std::to_string(number), {}});
    }
    at = end;
  }
  return apply_edits(text, std::move(edits));
}

namespace {

/// More forms than scenes have: those of one shape are some twenty.
constexpr std::size_t kMaxForms = 4096;

/// The forms made so far, by what decides them. Any thread may ask.
class FormCache {
 public:
  template <typename Make>
  std::shared_ptr<const CodeUnit> get(std::string key, Make make) {
    const std::scoped_lock lock(mutex_);
    const auto [found, added] = forms_.try_emplace(std::move(key));
    if (!added) return found->second;
    auto form = found->second = make();
    if (forms_.size() > kMaxForms) forms_.clear();
    return form;
  }

 private:
  std::mutex mutex_;
  std::unordered_map<std::string, std::shared_ptr<const CodeUnit>> forms_;
};

FormCache& form_cache() {
  static FormCache cache;
  return cache;
}

std::string form_key(std::string_view name, const Features& features, int number) {
  std::string key(name);
  for (const std::string_view feature : features.names()) key.append(1, ' ').append(feature);
  if (number >= 0) key.append(1, ' ').append(std::to_string(number));
  return key;
}

/// A template among the files that plugc carries.
struct TemplateFile {
  std::uint32_t number = 0;  // its place there: its number in every source set
  std::string name;          // as messages show it
  std::string_view text;
};

const TemplateFile& find_template(std::string_view name) {
  static const std::unordered_map<std::string_view, TemplateFile> templates = [] {
    constexpr std::string_view kFolder = "templates/";
    std::unordered_map<std::string_view, TemplateFile> all;
    const auto files = stdlib_files();
    for (std::uint32_t i = 0; i < files.size(); ++i) {
      const std::string_view file = files[i].name;
      const std::string_view key = file.starts_with(kFolder) ? file.substr(kFolder.size()) : file;
      all.emplace(key, TemplateFile{i, fmt::format("plugc:/{}", file), files[i].text});
    }
    return all;
  }();
  const auto found = templates.find(name);
  PLUGC_CHECK(found != templates.end(), "templates are asked for by names that there are");
  return found->second;
}

}  // namespace

SourceId TemplateLibrary::source(std::string_view name) {
  if (const auto found = loaded_.find(name); found != loaded_.end()) return found->second;
  const TemplateFile& file = find_template(name);
  const SourceId id = sources_->add_fixed(file.number, file.name, file.text);
  loaded_.emplace(name, id);
  return id;
}

std::shared_ptr<const CodeUnit> TemplateLibrary::get(std::string_view name, const Features& features, int number) {
  const SourceId id = source(name);
  return form_cache().get(form_key(name, features, number), [&] {
    MappedText text = cut_template(*sources_, id, features);
    if (number >= 0) text = number_names(text, number);
    return make_template_unit(std::move(text));
  });
}

}  // namespace plugc

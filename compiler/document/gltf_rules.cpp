// One table of members, walked from the root down. A member that breaks its rule is reported and becomes `null` for the
// library. Where a member must be there, or would change the meaning of its object by being absent, the object is refused:
// it becomes the emptiest object that the library takes, so that the numbers of the others stay what they are.

#include "document/gltf_rules.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "document/gltf_rule_table.h"

namespace plugc {
namespace {

using Rule = GltfRule;
using Type = GltfType;

std::span<const Rule> rules_of(std::string_view owner) {
  const auto first = std::ranges::find(kGltfRules, owner, &Rule::owner);
  const auto end = std::find_if(first, std::end(kGltfRules), [&](const Rule& rule) { return rule.owner != owner; });
  return {first, end};
}

std::string_view article(std::string_view word) {
  return std::string_view("aeiou").find(word[0]) == std::string_view::npos ? "a" : "an";
}

/// The words of a list as `a`, `b` or `c`.
std::string alternatives(std::string_view words) {
  std::string text = "`";
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (words[at] != ' ') {
      text += words[at];
      continue;
    }
    text += words.find(' ', at + 1) == std::string_view::npos ? "` or `" : "`, `";
  }
  return text + '`';
}

bool has_word(std::string_view words, std::string_view word) {
  const bool is_word = !word.empty() && word.find(' ') == std::string_view::npos;
  return is_word && fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

class Checker {
 public:
  explicit Checker(GltfText& text) : text_(text) {}

  /// Whether the object may be used.
  bool object(GltfAt at, std::string_view owner);
  /// The library gives the file up where indices have no buffer view.
  void refuse_empty_indices();

  GltfCheck check;

 private:
  bool member(GltfAt object, const Rule& rule);
  bool value(GltfAt at, const Rule& rule);
  bool list(GltfAt at, const Rule& rule);
  bool index(GltfAt at, std::string_view target);
  bool indices(GltfAt at, const Rule& rule);
  bool numbers(GltfAt at, std::size_t length);
  std::optional<std::uint32_t> whole_number(GltfAt at) const;
  bool choice_has_its_object(GltfAt at, std::string_view owner);
  bool mistake(GltfAt at, std::string_view message);
  bool expect(bool fits, GltfAt at, std::string_view what);
  GltfAt section(std::string_view name) const;
  void refuse(GltfAt at, std::string_view emptiest);

  GltfText& text_;
};

bool Checker::mistake(GltfAt at, std::string_view message) {
  text_.mistake(at, message);
  return false;
}

bool Checker::expect(bool fits, GltfAt at, std::string_view what) {
  return fits || mistake(at, fmt::format("expected {}", what));
}

GltfAt Checker::section(std::string_view name) const {
  if (name != "lights") return text_.member(text_.root(), name);
  const GltfAt extensions = text_.member(text_.root(), "extensions");
  return text_.member(text_.member(extensions, "KHR_lights_punctual"), "lights");
}

void Checker::refuse(GltfAt at, std::string_view emptiest) {
  check.refused.insert(at.index);
  check.replacements.push_back({text_[at].span, emptiest});
}

bool Checker::object(GltfAt at, std::string_view owner) {
  if (!expect(text_[at].kind == GltfKind::object, at, fmt::format("an object, {} {}", article(owner), owner))) return false;
  bool sound = true;
  for (const Rule& rule : rules_of(owner)) sound = member(at, rule) && sound;
  if (owner == "normalTexture" || owner == "occlusionTexture") sound = object(at, "textureInfo") && sound;
  return sound && choice_has_its_object(at, owner);
}

/// Whether the object may be used as far as this member goes.
bool Checker::member(GltfAt object, const Rule& rule) {
  const GltfAt at = text_.member(object, rule.member);
  if (!at.valid()) return rule.need != GltfNeed::required || mistake(object, fmt::format("`{}` is missing", rule.member));
  if (value(at, rule)) return true;
  check.replacements.push_back({text_[at].span, "null"});
  if (rule.type == Type::object || rule.type == Type::list) check.refused.insert(at.index);
  return rule.need == GltfNeed::optional;
}

bool Checker::value(GltfAt at, const Rule& rule) {
  const GltfValue& value = text_[at];
  switch (rule.type) {
    case Type::index: return index(at, rule.target);
    case Type::indices: return expect(value.kind == GltfKind::list, at, "a list of indices") && indices(at, rule);
    case Type::index_map: return expect(value.kind == GltfKind::object, at, "an object of indices") && indices(at, rule);
    case Type::count: return expect(whole_number(at).has_value(), at, "a whole number from 0 on");
    case Type::stride: {
      const auto stride = whole_number(at).value_or(1);
      return expect(stride % 4 == 0 && stride >= 4 && stride <= 252, at, "a multiple of 4 from 4 to 252");
    }
    case Type::component: {
      const auto type = whole_number(at).value_or(0);
      return expect(type >= 5120 && type <= 5126 && type != 5124, at, "5120, 5121, 5122, 5123, 5125 or 5126");
    }
    case Type::one_of: {
      const bool known = value.kind == GltfKind::string && has_word(rule.target, value.text);
      return expect(known, at, alternatives(rule.target));
    }
    case Type::number: return expect(value.kind == GltfKind::number, at, "a number");
    case Type::numbers: return numbers(at, rule.length);
    case Type::string: return expect(value.kind == GltfKind::string, at, "a string");
    case Type::boolean: return expect(value.kind == GltfKind::boolean, at, "`true` or `false`");
    case Type::object: return object(at, rule.target);
    case Type::list: return expect(value.kind == GltfKind::list, at, "a list of objects") && list(at, rule);
  }
  return false;
}

bool Checker::list(GltfAt at, const Rule& rule) {
  const auto emptiest = std::ranges::find(kEmptiestGltf, rule.target, &GltfEmptiest::kind);
  for (std::size_t i = 0; i < text_.size(at); ++i) {
    const GltfAt item = text_.child(at, i);
    if (!object(item, rule.target)) refuse(item, emptiest->text);
  }
  return true;
}

std::optional<std::uint32_t> Checker::whole_number(GltfAt at) const {
  const GltfValue& value = text_[at];
  if (value.kind != GltfKind::number) return std::nullopt;
  std::int32_t number = 0;  // the library reads numbers of 32 bits
  const char* const end = value.text.data() + value.text.size();
  const auto [behind, error] = std::from_chars(value.text.data(), end, number);
  if (error != std::errc() || behind != end || number < 0) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

bool Checker::index(GltfAt at, std::string_view target) {
  const auto index = whole_number(at);
  if (!index) return mistake(at, fmt::format("expected the index of one of the `{}`", target));
  const GltfAt list = section(target);
  if (text_.item(list, *index).valid()) return true;
  const std::size_t size = list.valid() && text_[list].kind == GltfKind::list ? text_.size(list) : 0;
  return mistake(at, fmt::format("there is no {}; `{}` holds {}", *index, target, size));
}

bool Checker::indices(GltfAt at, const Rule& rule) {
  bool sound = true;
  for (std::size_t i = 0; i < text_.size(at); ++i) sound = index(text_.child(at, i), rule.target) && sound;
  return sound;
}

bool Checker::numbers(GltfAt at, std::size_t length) {
  if (text_[at].kind != GltfKind::list || text_.size(at) != length)
    return mistake(at, fmt::format("expected a list of {} numbers", length));
  for (std::size_t i = 0; i < length; ++i) {
    if (!expect(text_[text_.child(at, i)].kind == GltfKind::number, text_.child(at, i), "a number")) return false;
  }
  return true;
}

/// A camera has an object of its type's name; so has a spot light.
bool Checker::choice_has_its_object(GltfAt at, std::string_view owner) {
  if (owner != "camera" && owner != "light") return true;
  const std::string_view type = text_[text_.member(at, "type")].text;
  const bool needs_object = owner == "camera" || type == "spot";
  return !needs_object || text_.member(at, type).valid() || mistake(at, fmt::format("`{}` is missing", type));
}

void Checker::refuse_empty_indices() {
  const GltfAt meshes = section("meshes");
  for (std::size_t i = 0; i < text_.size(meshes); ++i) {
    const GltfAt primitives = text_.member(text_.child(meshes, i), "primitives");
    for (std::size_t j = 0; j < text_.size(primitives); ++j) {
      const GltfAt primitive = text_.child(primitives, j);
      const GltfAt indices = text_.member(primitive, "indices");
      if (!indices.valid() || check.is_refused(primitive)) continue;
      const GltfAt accessor = text_.item(section("accessors"), whole_number(indices).value_or(0));
      if (!check.is_refused(accessor) && text_.member(accessor, "bufferView").valid()) continue;
      if (!check.is_refused(accessor)) mistake(indices, "this accessor has no `bufferView`, so there are no indices");
      refuse(primitive, R"({"attributes":{}})");
    }
  }
}

}  // namespace

GltfCheck check_gltf(GltfText& text) {
  Checker checker(text);
  checker.object(text.root(), "file");
  checker.refuse_empty_indices();
  return std::move(checker.check);
}

std::string text_for_library(const GltfText& text, GltfCheck& check, std::string_view json) {
  for (const std::string_view unread : {"buffers", "images", "animations", "skins", "extras"}) {
    if (const GltfAt at = text.member(text.root(), unread); at.valid()) check.replacements.push_back({text[at].span, "null"});
  }
  std::ranges::sort(check.replacements, [](const GltfReplacement& a, const GltfReplacement& b) {
    return a.span.begin != b.span.begin ? a.span.begin < b.span.begin : a.span.end > b.span.end;
  });
  std::string shown_text;
  std::uint32_t done = 0;
  for (const auto& [span, replacement] : check.replacements) {
    if (span.begin < done) continue;  // inside of what is replaced already
    shown_text += json.substr(done, span.begin - done);
    shown_text += replacement;
    done = span.end;
  }
  shown_text += json.substr(done);
  return shown_text;
}

}  // namespace plugc

#include "compose/screen_library.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "glsl/scan.h"

namespace plugc {
namespace {

/// A name of the library, what of the template it is, and the texture that it looks up.
struct LibraryName {
  std::string_view name, feature, texture;
};

constexpr std::string_view kColor = "COLOR", kDepth = "DEPTH";

constexpr LibraryName kNames[] = {
    {"screen", kColor, kColor},
    {"screen_depth", kDepth, kDepth},
    {"screen_width", "WIDTH", ""},
    {"screen_height", "HEIGHT", ""},
    {"screen_position", "POSITION", ""},
    {"screen_x", "X", ""},
    {"screen_y", "Y", ""},
    {"screen_get_color", "GET_COLOR", kColor},
    {"screen_get_depth", "GET_DEPTH", kDepth},
    {"screen_get_depth_fast", "GET_DEPTH_FAST", kDepth},
    {"screenf_position", "F_POSITION", ""},
    {"screenf_x", "F_X", ""},
    {"screenf_y", "F_Y", ""},
    {"screenf_get_color", "F_GET_COLOR", kColor},
    {"screenf_get_original_color", "F_GET_ORIGINAL_COLOR", kColor},
    {"screenf_get_depth", "F_GET_DEPTH", kDepth},
    {"screenf_get_depth_fast", "F_GET_DEPTH_FAST", kDepth},
    {"screenf_get_original_depth", "F_GET_ORIGINAL_DEPTH", kDepth},
    {"screenf_01_position", "POSITION_01", ""},
    {"screenf_01_get_color", "F_01_GET_COLOR", kColor},
    {"screenf_01_get_depth", "F_01_GET_DEPTH", kDepth},
};

constexpr std::pair<std::string_view, ScreenValue> kUniforms[] = {
    {"screen", ScreenValue::color},
    {"screen_depth", ScreenValue::depth},
    {"screen_width", ScreenValue::width},
    {"screen_height", ScreenValue::height},
};

/// Whether the word stands in the text as a whole.
bool names(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_identifier_part(text[at - 1]);
    if (begins && (end == text.size() || !is_identifier_part(text[end]))) return true;
  }
  return false;
}

/// Adds what a text names.
void note_features(std::string_view text, ScreenPass pass, Features& features) {
  const auto add = [&](std::string_view feature) {
    if (!feature.empty() && !features.contains(feature)) features.insert(feature);
  };
  for (const LibraryName& one : kNames) {
    const bool is_there = one.texture != kDepth || pass == ScreenPass::color_and_depth;
    if (!is_there || !names(text, one.name)) continue;
    add(one.feature);
    add(one.texture);
  }
}

}  // namespace

Features screen_features(const EffectCode& shader, ScreenPass pass, Target target) {
  Features features;
  for (const EffectCode::Part& part : shader.parts) {
    const EffectCode::Part& form = part.form(target);
    if (form.in_fragment != nullptr) note_features(form.in_fragment->text.text(), pass, features);
  }
  return features;
}

std::optional<ScreenValue> find_screen_value(std::string_view uniform) {
  const auto* found = std::ranges::find(kUniforms, uniform, &std::pair<std::string_view, ScreenValue>::first);
  return found == std::end(kUniforms) ? std::nullopt : std::optional(found->second);
}

}  // namespace plugc

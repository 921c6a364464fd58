#pragma once
// What the specification of glTF demands of the members of its objects: which must be there, of what type, and that an index
// names something that exists. The library passes a member of the wrong type over in silence and gives a whole file up where
// one is missing, so it is shown only what keeps these rules.

#include <string>
#include <unordered_set>
#include <vector>

#include "document/gltf_text.h"

namespace plugc {

/// A part of the JSON text that the library sees as something else.
struct GltfReplacement {
  Span span;
  std::string_view text;
};

struct GltfCheck {
  std::vector<GltfReplacement> replacements;
  std::unordered_set<std::uint32_t> refused;  ///< Indices of objects that break a rule: reported, and not to be used.
  bool is_refused(GltfAt at) const { return at.valid() && refused.contains(at.index); }
};

/// Reports every broken rule at its place (`gltf-invalid`). Source: glTF 2.0, chapter 5, with KHR_lights_punctual,
/// KHR_materials_unlit and KHR_texture_transform.
GltfCheck check_gltf(GltfText& text);

/// The text for the library: without buffers and images, which are read under plugc's own rules for files, without what is
/// not read at all, and with the replacements of a check.
std::string text_for_library(const GltfText& text, GltfCheck& check, std::string_view json);

}  // namespace plugc

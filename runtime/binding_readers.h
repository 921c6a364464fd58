#pragma once
// Who reads what the renderer draws for a scene: its shadow maps and the textures that it renders.

#include <cstdint>
#include <vector>

#include "package/package_file.h"

namespace plugc {

/// A shape in one of its variants.
struct MapReader {
  std::uint32_t shape = 0;
  std::uint8_t variant = 0;
  friend bool operator==(const MapReader&, const MapReader&) = default;
};

/// Each in the order of the shapes.
struct BindingReaders {
  std::vector<std::vector<MapReader>> of_map;          ///< By shadow map.
  std::vector<std::vector<std::uint32_t>> of_texture;  ///< By rendered texture: shapes, in whatever variant.
  std::vector<bool> on_screen;                         ///< By rendered texture: some screen effect reads it.
};

/// Whose programs look into a map, whose texture coordinates its light projects, and whose programs read a rendered texture:
/// found in one pass over the scene's bindings.
BindingReaders find_binding_readers(const PackedScene& scene);

/// Whether the binding looks into a shadow map, or asks how its light projects.
bool reads_map(const PackedBinding& binding);

}  // namespace plugc

#pragma once
// A shape with the programs of its states, and what fills their uniforms.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/mirror_window.h"
#include "package/assemble_package.h"

namespace plugc {

inline constexpr std::uint32_t kNothing =
    UINT32_MAX;  ///< In place of an index: a program that is not valid, a texture without pixels.

/// Of meshes that are mirrors, as they are asked for: many shapes may share one.
using MirrorWindows = std::map<const Mesh*, std::optional<MirrorWindow>>;

/// Where the programs, textures and fog planes of a scene lie in the package.
struct Packed {
  const std::vector<std::uint32_t>& programs;  // by recipe of the scene; kNothing: none is valid
  const std::vector<std::uint32_t>& textures;
  const std::vector<std::uint32_t>& fog_planes;  // by fog of the scene; UINT32_MAX: it is not in layers
  MirrorWindows& mirrors;
};

/// Sets of texture coordinates that the program reads.
std::uint32_t coordinate_units(const ValidRecipe& program);

/// What turns the depths of map `map` of the scene into blurred moments.
void pack_map_programs(const SceneParts& parts, std::size_t map, const Packed& where, PackedShadowMapT& packed);

/// Shape `index` of the scene, some of whose programs are valid; `mesh` as the package numbers it.
std::unique_ptr<PackedShapeT> pack_shape(const SceneParts& parts, std::size_t index, std::uint32_t mesh, const Packed& where);

}  // namespace plugc

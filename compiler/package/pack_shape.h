#pragma once
// A shape with the programs of its states, and what fills their uniforms.

#include <cstdint>
#include <memory>
#include <vector>

#include "package/assemble_package.h"

namespace plugc {

inline constexpr std::uint32_t kNothing =
    UINT32_MAX;  ///< In place of an index: a program that is not valid, a texture without pixels.

/// Where the programs and textures of a scene lie in the package.
struct Packed {
  const std::vector<std::uint32_t>& programs;  // by recipe of the scene; kNothing: none is valid
  const std::vector<std::uint32_t>& textures;
};

/// Sets of texture coordinates that the program reads.
std::uint32_t coordinate_units(const ValidRecipe& program);

/// What turns the depths of map `map` of the scene into blurred moments.
void pack_map_programs(const SceneParts& parts, std::size_t map, const Packed& where, PackedShadowMapT& packed);

/// Shape `index` of the scene, some of whose programs are valid; `mesh` as the package numbers it.
std::unique_ptr<PackedShapeT> pack_shape(const SceneParts& parts, std::size_t index, std::uint32_t mesh, const Packed& where);

}  // namespace plugc

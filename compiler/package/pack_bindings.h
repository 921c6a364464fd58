#pragma once
// What feeds the uniforms of a validated program, for one shape.

#include <vector>

#include "package/assemble_package.h"

namespace plugc {

/// What a shape's bindings refer to, by number in its recipe.
struct BindingContext {
  const Scene& scene;
  const SceneShape& shape;
  const std::vector<std::uint32_t>& package_textures;  ///< By texture of the scene; UINT32_MAX for none.
  const std::vector<std::uint32_t>& fog_planes;        ///< By fog of the scene; UINT32_MAX for one that is not in layers.
  int shadow_map = -1;                                 ///< Whose texels the program is drawn over; then `shape` has nothing.
};
/// PackedShape::projected_coords of a shape with a ComposedShader: for the units that some program's vertex stage reads.
std::vector<PackedBinding> pack_projected_coords(const BindingContext& context, std::uint32_t units_read);
std::vector<PackedBinding> pack_bindings(const ValidRecipe& recipe, const BindingContext& context);

}  // namespace plugc

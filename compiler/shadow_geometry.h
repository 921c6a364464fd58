#pragma once
// What of a shape counts where its shadow is thought of before programs are composed: whether it casts one, and whether its
// triangles lie where its mesh says.

#include <vector>

#include "compose/code_unit.h"
#include "package/assemble_package.h"
#include "scene/scene.h"

namespace plugc {

/// Whether shape `index` is drawn into shadow maps. `parts` has its meshes, and knows which shapes are blended.
bool casts_shadow(const SceneParts& parts, std::size_t index);

/// Whether a shader may put vertices of the shape elsewhere. `effects` holds the outlined effects of the scene, by index.
bool may_move_vertices(const Scene& scene, const SceneShape& shape, const std::vector<EffectCode>& effects);

/// Whether an effect may drop fragments of the shape, though its vertices are where they were.
bool may_cut_holes(const Scene& scene, const SceneShape& shape, const std::vector<EffectCode>& effects);

/// Whether a texture with alpha lies on the shape otherwise than by the first texture coordinates of its mesh as they are:
/// where alpha is tested, rays would see its holes elsewhere.
bool lays_alpha_elsewhere(const SceneParts& parts, const SceneShape& shape);

}  // namespace plugc

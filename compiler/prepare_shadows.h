#pragma once
// What is known of shadow maps before programs are composed.

#include <vector>

#include "base/diagnostics.h"
#include "compose/code_unit.h"
#include "image/image.h"
#include "package/assemble_package.h"
#include "scene/scene.h"

namespace plugc {

/// Marks the maps whose depths or projection an author can tell: as a texture, as texture coordinates that a light projects,
/// or by the names castle_shadow_map_N, castle_projector_matrix_N and castle_projected_tex_coord_N (which light they mean is
/// known program by program only, so one of these words marks every map).
void mark_author_visible_maps(const std::vector<EffectCode>& effects, const std::vector<EffectCode>& shaders, Scene& scene);

/// Marks the maps whose shadow may be seen though their light has no colour of its own: a ComposedShader, or an effect on a
/// plug of light, may add to the light that it scales.
void mark_maps_of_other_light(const std::vector<EffectCode>& effects, Scene& scene);

/// Gives maps that cannot be traced the default method, and says why: an effect or a whole shader may move vertices of a shape
/// that casts or shows the shadow, an effect may cut holes into any shape (through which another one's shadow would be seen),
/// or its texture does where rays do not look for them, or the author looks into the map. `alpha` is by shape. After
/// mark_author_visible_maps().
void replace_untraceable_maps(const NodeGraph& graph, const std::vector<EffectCode>& effects,
                              const std::vector<AlphaUse>& alpha, SceneParts& parts, Diagnostics& diagnostics);

}  // namespace plugc

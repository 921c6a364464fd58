#pragma once
// What is known of shadow maps before programs are composed.

#include <vector>

#include "compose/code_unit.h"
#include "scene/scene.h"

namespace plugc {

/// Marks the maps whose depths or projection an author can tell: as a texture, as texture coordinates that a light projects,
/// or by the names castle_shadow_map_N, castle_projector_matrix_N and castle_projected_tex_coord_N (which light they mean is
/// known program by program only, so one of these words marks every map).
void mark_author_visible_maps(const std::vector<EffectCode>& effects, const std::vector<EffectCode>& shaders, Scene& scene);

}  // namespace plugc

#pragma once
// What feeds a shape's uniforms beside its front material, lights and textures: the material of its back, clip planes, the
// style of its lines, points and faces; and what of it is OpenGL's state.

#include <optional>

#include "compose/castle_names.h"
#include "package/pack_bindings.h"

namespace plugc {

/// nullopt for names of other things, and where nothing feeds the uniform.
std::optional<PackedBinding> bind_style(std::uint32_t uniform, const CastleName& name, const BindingContext& context);

/// Line width, bounds of alpha, colour of blending; `sized_points`: the shape's program says how large points are.
void pack_style(const SceneShape& shape, bool sized_points, PackedShapeT& packed);

void pack_clip_planes(const Scene& scene, PackedSceneT& packed);

}  // namespace plugc

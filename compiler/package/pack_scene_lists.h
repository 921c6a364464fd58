#pragma once
// The lists of a scene that map one to one.

#include <memory>

#include "package/package_file.h"
#include "scene/scene.h"

namespace plugc {

void pack_slots(const Scene& scene, PackedSceneT& packed);
std::unique_ptr<PackedLightT> pack_light(const SceneLight& light);
/// Without its programs.
std::unique_ptr<PackedShadowMapT> pack_shadow_map(const SceneShadowMap& map);
std::unique_ptr<PackedViewpointT> pack_viewpoint(const SceneViewpoint& viewpoint);

}  // namespace plugc

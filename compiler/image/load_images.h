#pragma once
// The images of a scene's textures, each file decoded once.

#include <memory>
#include <vector>

#include "base/file_access.h"
#include "image/image.h"
#include "scene/node_graph.h"
#include "scene/scene.h"

namespace plugc {

/// By texture of the scene; null where it has no pixels (SceneTexture::has_pixels), or none of its urls can be used (reported).
std::vector<std::shared_ptr<const Image>> load_images(const NodeGraph& graph, const Scene& scene, FileAccess& files,
                                                      Diagnostics& diagnostics, ImageDetail detail = ImageDetail::pixels);

/// Shapes are drawn without the textures whose image failed.
void drop_missing_textures(Scene& scene, const std::vector<std::shared_ptr<const Image>>& images);

}  // namespace plugc

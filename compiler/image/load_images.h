#pragma once
// The images of a scene's textures, each file decoded once.

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/file_access.h"
#include "image/image.h"
#include "scene/node_graph.h"
#include "scene/scene.h"

namespace plugc {

/// Facts of images that were looked through, by a hash of their files (XXH3-128): for who loads those of many scenes that share
/// some. Not for two threads at a time.
struct KnownImages {
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::shared_ptr<const Image>> by_hash;
};

/// By texture of the scene; null where it has no pixels (SceneTexture::has_pixels), or none of its urls can be used (reported).
std::vector<std::shared_ptr<const Image>> load_images(const NodeGraph& graph, const Scene& scene, FileAccess& files,
                                                      Diagnostics& diagnostics, ImageDetail detail = ImageDetail::pixels,
                                                      KnownImages* known = nullptr);

/// Shapes are drawn without the textures whose image failed.
void drop_missing_textures(Scene& scene, const std::vector<std::shared_ptr<const Image>>& images);

}  // namespace plugc

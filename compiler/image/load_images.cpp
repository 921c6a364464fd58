// The first url that can be read and decoded counts (X3D 4.1, 9.2.1). A file that several textures name is read once.

#include "image/load_images.h"

#include <map>

namespace plugc {
namespace {

using ImagesByPath = std::map<std::filesystem::path, std::shared_ptr<const Image>>;

std::shared_ptr<const Image> load_url(const MappedText& url, const std::filesystem::path& base, ImagesByPath& loaded,
                                      FileAccess& files, Diagnostics& diagnostics) {
  const auto path = resolve_url(url.text(), base);
  if (path) {
    if (const auto found = loaded.find(*path); found != loaded.end()) return found->second;
  }
  const Span span = url.locate(0, url.size());
  const auto bytes = read_url(files, url.text(), base, span, diagnostics);
  if (!bytes || !path) return nullptr;
  auto image = decode_image(*bytes, url.text(), span, diagnostics);
  return loaded[*path] = image ? std::make_shared<const Image>(std::move(*image)) : nullptr;
}

std::shared_ptr<const Image> load_texture(const NodeGraph& graph, NodeId texture, ImagesByPath& loaded, FileAccess& files,
                                          Diagnostics& diagnostics) {
  Diagnostics failures(diagnostics.sources());
  for (const MappedText& url : graph.field(texture, "url").strings) {
    if (auto image = load_url(url, graph.base_path(texture), loaded, files, failures)) return image;
  }
  for (const Diagnostic& failure : failures.all()) diagnostics.report(failure.id, failure.span, failure.message);
  return nullptr;
}

}  // namespace

std::vector<std::shared_ptr<const Image>> load_images(const NodeGraph& graph, const Scene& scene, FileAccess& files,
                                                      Diagnostics& diagnostics) {
  ImagesByPath loaded;
  std::vector<std::shared_ptr<const Image>> images;
  for (const SceneTexture& texture : scene.textures) {
    images.push_back(load_texture(graph, texture.node, loaded, files, diagnostics));
  }
  return images;
}

void drop_missing_textures(Scene& scene, const std::vector<std::shared_ptr<const Image>>& images) {
  for (SceneShape& shape : scene.shapes) {
    std::erase_if(shape.textures,
                  [&](const TextureUse& use) { return images[static_cast<std::size_t>(use.texture)] == nullptr; });
  }
}

}  // namespace plugc

// The first url that can be read and decoded counts (X3D 4.1, 9.2.1). A file that several textures name is read once; a
// `data:` url holds the file itself.

#include "image/load_images.h"

#include <algorithm>
#include <map>

#include "base/data_url.h"

namespace plugc {
namespace {

using ImagesByPath = std::map<std::filesystem::path, std::shared_ptr<const Image>>;

std::shared_ptr<const Image> shared(std::optional<Image> image) {
  return image ? std::make_shared<const Image>(std::move(*image)) : nullptr;
}

std::shared_ptr<const Image> load_data_url(const MappedText& url, const Span& span, Diagnostics& diagnostics) {
  const std::string_view start = url.text().substr(0, std::min<std::size_t>(url.text().find(','), 64));
  if (const auto bytes = data_url_bytes(url.text())) return shared(decode_image(*bytes, start, span, diagnostics));
  diagnostics.report(DiagnosticId::image_invalid, span,
                     "this `data:` url holds no readable image; write `data:image/png;base64,` and the file in base64");
  return nullptr;
}

std::shared_ptr<const Image> load_url(const MappedText& url, const std::filesystem::path& base, ImagesByPath& loaded,
                                      FileAccess& files, Diagnostics& diagnostics) {
  const Span span = url.locate(0, url.size());
  if (is_data_url(url.text())) return load_data_url(url, span, diagnostics);
  const auto path = resolve_url(url.text(), base);
  if (path) {
    if (const auto found = loaded.find(*path); found != loaded.end()) return found->second;
  }
  const auto bytes = read_url(files, url.text(), base, span, diagnostics);
  if (!bytes || !path) return nullptr;
  return loaded[*path] = shared(decode_image(*bytes, url.text(), span, diagnostics));
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

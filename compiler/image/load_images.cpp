// The first url that can be read and decoded counts (X3D 4.1, 9.2.1). A file that several textures name is read once, and files
// of equal bytes are decoded once; a `data:` url holds the file itself. A volume or cube map made of textures has pixels when
// each of them has some.

#include "image/load_images.h"

#include <algorithm>
#include <map>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include "base/data_url.h"
#include "image/join_images.h"
#include "image/pixel_image.h"
#include "scene/movie_url.h"

namespace plugc {
namespace {

using ImagesByPath = std::map<std::filesystem::path, std::shared_ptr<const Image>>;
using ImagesByHash = std::map<std::pair<std::uint64_t, std::uint64_t>, std::shared_ptr<const Image>>;

/// What every loading function needs.
struct Loading {
  const NodeGraph& graph;
  ImagesByPath& loaded;
  ImagesByHash& decoded;  ///< By their files.
  FileAccess& files;
  Diagnostics& diagnostics;
  ImageDetail detail;
};

std::shared_ptr<const Image> shared(std::optional<Image> image) {
  return image ? std::make_shared<const Image>(std::move(*image)) : nullptr;
}

/// A broken file is decoded for each texture anew, so that each is told of it.
std::shared_ptr<const Image> decode(const Loading& l, std::string_view bytes, std::string_view name, const Span& span,
                                    Diagnostics& failures) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  std::shared_ptr<const Image>& image = l.decoded[{hash.high64, hash.low64}];
  if (image == nullptr) image = shared(decode_image(bytes, name, span, failures, l.detail));
  return image;
}

std::shared_ptr<const Image> load_data_url(const Loading& l, const MappedText& url, const Span& span, Diagnostics& failures) {
  const std::string_view start = url.text().substr(0, std::min<std::size_t>(url.text().find(','), 64));
  if (const auto bytes = data_url_bytes(url.text())) return decode(l, *bytes, start, span, failures);
  failures.report(DiagnosticId::image_invalid, span,
                  "this `data:` url holds no readable image; write `data:image/png;base64,` and the file in base64");
  return nullptr;
}

std::shared_ptr<const Image> load_file(const Loading& l, NodeId texture, std::string_view url, const Span& span,
                                       Diagnostics& failures) {
  const std::filesystem::path base = l.graph.base_path(texture);
  const auto path = resolve_url(url, base);
  if (path) {
    if (const auto found = l.loaded.find(*path); found != l.loaded.end()) return found->second;
  }
  const auto bytes = read_url(l.files, url, base, span, failures);
  if (!bytes || !path) return nullptr;
  return l.loaded[*path] = decode(l, *bytes, url, span, failures);
}

std::shared_ptr<const Image> load_url(const Loading& l, NodeId texture, const MappedText& url, Diagnostics& failures) {
  const Span span = url.locate(0, url.size());
  if (is_data_url(url.text())) return load_data_url(l, url, span, failures);
  if (!l.graph.is(texture, "MovieTexture")) return load_file(l, texture, url.text(), span, failures);
  if (!names_picture(url.text())) return nullptr;
  Diagnostics unsaid(l.diagnostics.sources());  // a series begins with 0 or with 1
  if (auto image = load_file(l, texture, numbered_picture(url.text(), 0), span, unsaid)) return image;
  return load_file(l, texture, numbered_picture(url.text(), 1), span, failures);
}

std::shared_ptr<const Image> load_urls(const Loading& l, NodeId texture, std::string_view field = "url") {
  Diagnostics failures(l.diagnostics.sources());
  for (const MappedText& url : l.graph.field(texture, field).strings) {
    if (auto image = load_url(l, texture, url, failures)) return image;
  }
  for (const Diagnostic& failure : failures.all()) l.diagnostics.report(failure.id, failure.span, failure.message);
  return nullptr;
}

std::shared_ptr<const Image> finish(const Loading& l, NodeId texture, std::string_view field, DecodedImage made) {
  if (!made.problem.empty()) {
    l.diagnostics.report(DiagnosticId::image_invalid, l.graph.field_span(texture, field),
                         fmt::format("this `{}` makes no image: {}", l.graph[texture].info->name, made.problem));
  }
  if (made.image && l.detail == ImageDetail::facts) made.image->pixels = {};
  return shared(std::move(made.image));
}

/// A picture inside of a volume or a cube map: only one in a file or spelled out has pixels.
std::shared_ptr<const Image> load_picture(const Loading& l, NodeId texture) {
  const bool movie = l.graph.is(texture, "MovieTexture") && has_picture_url(l.graph, texture);
  if (movie || l.graph.is(texture, "ImageTexture")) return load_urls(l, texture);
  if (l.graph.is(texture, "PixelTexture"))
    return finish(l, texture, "image", image_of_pixels(l.graph.field(texture, "image").numbers));
  if (texture.valid()) {
    l.diagnostics.report(DiagnosticId::not_drawn, l.graph[texture].type_span,
                         fmt::format("a `{}` is not drawn inside of another texture", l.graph[texture].info->name));
  }
  return nullptr;
}

/// Null unless all pictures are there; one that lacks has said why.
std::shared_ptr<const Image> load_joined(const Loading& l, NodeId texture, const std::vector<NodeId>& pictures,
                                         std::string_view field, DecodedImage (*join)(std::span<const Image* const>)) {
  std::vector<std::shared_ptr<const Image>> kept;
  std::vector<const Image*> images;
  for (const NodeId picture : pictures) {
    kept.push_back(load_picture(l, picture));
    images.push_back(kept.back().get());
  }
  if (std::ranges::find(images, nullptr) != images.end()) return nullptr;
  return finish(l, texture, field, join(images));
}

std::shared_ptr<const Image> load_cube(const Loading& l, NodeId texture) {
  constexpr std::string_view kFaces[] = {"rightTexture",  "leftTexture", "topTexture",
                                         "bottomTexture", "backTexture", "frontTexture"};
  std::vector<NodeId> pictures;
  for (const std::string_view face : kFaces) {
    pictures.push_back(l.graph.child(texture, face));
    if (pictures.back().valid()) continue;
    return finish(l, texture, face, {{}, fmt::format("it has no `{}`; it needs all six", face)});
  }
  return load_joined(l, texture, pictures, "", cube_of_faces);
}

std::shared_ptr<const Image> load_texture(const Loading& l, const SceneTexture& wanted) {
  const NodeGraph& graph = l.graph;
  const NodeId texture = wanted.node;
  if (wanted.url_field != "url") return load_urls(l, texture, wanted.url_field);
  if (graph.is(texture, "PixelTexture3D"))
    return finish(l, texture, "image", volume_of_pixels(graph.field(texture, "image").numbers));
  if (graph.is(texture, "ComposedCubeMapTexture")) return load_cube(l, texture);
  if (graph.is(texture, "ComposedTexture3D")) {
    const auto slices = graph.children(texture, "texture");
    return load_joined(l, texture, {slices.begin(), slices.end()}, "texture", volume_of_slices);
  }
  if (!graph.is(texture, "ImageCubeMapTexture") && !graph.is(texture, "ImageTexture3D")) return load_picture(l, texture);
  auto image = load_urls(l, texture);
  if (image == nullptr || graph.is(texture, "ImageTexture3D") || (image->depth == 6 && image->width == image->height))
    return image;
  return finish(l, texture, "url", {{}, "the file holds no six faces; a cube map is a DDS file with all of them"});
}

}  // namespace

std::vector<std::shared_ptr<const Image>> load_images(const NodeGraph& graph, const Scene& scene, FileAccess& files,
                                                      Diagnostics& diagnostics, ImageDetail detail, KnownImages* known) {
  ImagesByPath loaded;
  ImagesByHash decoded;
  const bool shares_facts = known != nullptr && detail == ImageDetail::facts;
  const Loading loading{graph, loaded, shares_facts ? known->by_hash : decoded, files, diagnostics, detail};
  std::vector<std::shared_ptr<const Image>> images;
  for (const SceneTexture& texture : scene.textures) {
    images.push_back(texture.has_pixels ? load_texture(loading, texture) : nullptr);
  }
  return images;
}

void drop_missing_textures(Scene& scene, const std::vector<std::shared_ptr<const Image>>& images) {
  for (SceneShape& shape : scene.shapes) {
    std::erase_if(shape.textures, [&](const TextureUse& use) {
      const auto index = static_cast<std::size_t>(use.texture);
      return scene.textures[index].has_pixels && images[index] == nullptr;
    });
  }
}

}  // namespace plugc

// A texture is an image and a sampler. An image file keeps its url, which is relative to the glTF file; an image in a buffer
// becomes a `data:` url.
//
// The transform of glTF is  p' = offset + R S p  with v down; X3D's is  q' = S R (q + T)  with t up (18.4.8, centre 0). With
// F the flip q = e + F p, where e = (0, 1) and F turns v over, both are the same when S commutes with R, that is without a
// rotation or with an even scale:   T = R'^-1 S^-1 (e + F offset) - e,  R' = F R F, the same angle the other way.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/data_url.h"
#include "document/gltf_reader.h"

namespace plugc {
namespace {

std::string_view boundary_mode(int wrap) {
  if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return "CLAMP_TO_EDGE";
  return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? "MIRRORED_REPEAT" : "REPEAT";
}

bool is_known_wrap(int wrap) {
  return wrap == TINYGLTF_TEXTURE_WRAP_REPEAT || wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ||
         wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
}

/// X3D's names for the filters of OpenGL; "" for a number that is none of them.
std::string_view minification(int filter) {
  switch (filter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST: return "NEAREST_PIXEL";
    case TINYGLTF_TEXTURE_FILTER_LINEAR: return "AVG_PIXEL";
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST: return "NEAREST_PIXEL_NEAREST_MIPMAP";
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST: return "AVG_PIXEL_NEAREST_MIPMAP";
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR: return "NEAREST_PIXEL_AVG_MIPMAP";
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR: return "AVG_PIXEL_AVG_MIPMAP";
    default: return "";
  }
}

std::array<double, 2> pair_or(const tinygltf::Value& object, const std::string& key, std::array<double, 2> otherwise) {
  const tinygltf::Value& list = object.Get(key);
  if (list.ArrayLen() != 2) return otherwise;
  return {list.Get(0).GetNumberAsDouble(), list.Get(1).GetNumberAsDouble()};
}

}  // namespace

void GltfReader::image_texture(int index, const Span& place) {
  const GltfAt at = file_.item("textures", index);
  if (file_.is_refused(at)) return;
  if (const auto known = textures_.find(index); known != textures_.end()) return write_.use(known->second, place);
  const tinygltf::Texture& texture = file_.model.textures[static_cast<std::size_t>(index)];
  if (texture.source < 0) {
    file_.text.mistake(at, "this texture has no `source`, the image that it shows");
    return;
  }
  const Name& def = textures_[index] = write_.define(texture.name, fmt::format("texture_{}", index), this->place(at, "name"));
  write_.node("ImageTexture", def, file_.text.place(at), [&] {
    image_url(texture.source);
    if (texture.sampler >= 0) texture_properties(texture.sampler);
  });
}

void GltfReader::image_url(int index) {
  const GltfAt at = file_.item("images", index);
  if (file_.is_refused(at)) return;
  const GltfAt uri = file_.text.member(at, "uri"), view = file_.text.member(at, "bufferView");
  const Span span = file_.text.place(uri.valid() ? uri : view.valid() ? view : at);
  if (uri.valid()) return write_.string("url", file_.text[uri].text, span);
  if (!view.valid()) return file_.text.mistake(at, "this image has neither a `uri` nor a `bufferView`");
  const auto bytes = file_.view_bytes(std::stoi(std::string(file_.text[view].text)));  // checked to be an index
  if (!bytes) return;
  const GltfAt type = file_.text.member(at, "mimeType");
  const std::string_view mime = type.valid() ? file_.text[type].text : "application/octet-stream";
  write_.string("url", fmt::format("data:{};base64,{}", mime, base64_encode(*bytes)), span);
}

void GltfReader::texture_properties(int index) {
  const GltfAt at = file_.item("samplers", index);
  if (file_.is_refused(at)) return;
  const tinygltf::Sampler& sampler = file_.model.samplers[static_cast<std::size_t>(index)];
  const auto check = [&](bool known, std::string_view member) {
    if (!known) file_.text.mistake(file_.text.member(at, member), "OpenGL has no such number for this; the default is taken");
  };
  check(is_known_wrap(sampler.wrapS), "wrapS");
  check(is_known_wrap(sampler.wrapT), "wrapT");
  const std::string_view min = minification(sampler.minFilter);
  check(sampler.minFilter < 0 || !min.empty(), "minFilter");
  const bool nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  check(sampler.magFilter < 0 || nearest || sampler.magFilter == TINYGLTF_TEXTURE_FILTER_LINEAR, "magFilter");
  write_.boolean("repeatS", sampler.wrapS != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, place(at, "wrapS"));
  write_.boolean("repeatT", sampler.wrapT != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, place(at, "wrapT"));
  const Span span = file_.text.place(at);
  write_.nodes("textureProperties", span, [&] {
    write_.node("TextureProperties", {}, span, [&] {
      write_.string("boundaryModeS", boundary_mode(sampler.wrapS), place(at, "wrapS"));
      write_.string("boundaryModeT", boundary_mode(sampler.wrapT), place(at, "wrapT"));
      if (!min.empty()) write_.string("minificationFilter", min, place(at, "minFilter"));
      if (min.ends_with("MIPMAP")) write_.boolean("generateMipMaps", true, place(at, "minFilter"));
      if (sampler.magFilter >= 0) {
        write_.string("magnificationFilter", nearest ? "NEAREST_PIXEL" : "AVG_PIXEL", place(at, "magFilter"));
      }
    });
  });
}

void GltfReader::texture_transform(const tinygltf::Value& transform, int set, GltfAt at) {
  const auto offset = pair_or(transform, "offset", {0, 0});
  const auto scale = pair_or(transform, "scale", {1, 1});
  const double angle = transform.Get("rotation").GetNumberAsDouble();
  if (scale[0] == 0 || scale[1] == 0 || (angle != 0 && scale[0] != scale[1])) {
    file_.build.diagnostics.report(DiagnosticId::not_drawn, file_.text.place(at),
                                   "X3D has no texture transform that turns and then scales unevenly, or scales to nothing; "
                                   "the texture is drawn without it");
    return;
  }
  const double x = offset[0] / scale[0], y = (1 - offset[1]) / scale[1];
  const double cosine = std::cos(angle), sine = std::sin(angle);
  write_.node("TextureTransform", {}, file_.text.place(at), [&] {
    write_.string("mapping", texture_set_name(set), file_.text.place(at));
    write_.numbers("translation", {cosine * x + sine * y, -sine * x + cosine * y - 1}, place(at, "offset"));
    write_.numbers("rotation", {angle}, place(at, "rotation"));
    write_.numbers("scale", scale, place(at, "scale"));
  });
}

}  // namespace plugc

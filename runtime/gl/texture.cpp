// Every picture becomes RGBA8, whatever its channels: each further texture format costs llvmpipe another code generation
// per program (some 300 ms). One and two channels are grey and grey with alpha (X3D 4.1, 5.3.7).
// Depth maps that authors see are 24 bit fixed point, because only there OpenGL clamps the reference depth to 0..1 before it
// compares: what lies beyond the far plane is then compared with 1, and lit where nothing was drawn. Reversed ones are floats,
// which resolve most near 0, where most distances of a perspective lie; who reads them clamps for himself.

#include "runtime/gl/texture.h"

#include <array>
#include <vector>

namespace plugc::gl {
namespace {

constexpr std::array<std::uint8_t, 4> kWhite = {255, 255, 255, 255};
constexpr std::array<GLfloat, 1> kFar = {1};
constexpr std::array<GLfloat, 1> kReversedFar = {0};
constexpr int kCubeFaces = 6;

/// A new texture, bound to the unit that no program reads: an upload in the middle of a draw disturbs nothing.
Texture begin_texture(const Functions& gl, GLenum target) {
  Texture texture = generate<Texture>(gl, gl.GenTextures);
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kUploadUnit));
  gl.BindTexture(target, texture.id());
  return texture;
}

GLint wrap_of(PackedWrap wrap) {
  switch (wrap) {
    case PackedWrap::repeat: return GL_REPEAT;
    case PackedWrap::clamp_to_edge: return GL_CLAMP_TO_EDGE;
    case PackedWrap::mirrored_repeat: return GL_MIRRORED_REPEAT;
    case PackedWrap::clamp_to_border: return GL_CLAMP_TO_BORDER;
  }
  return GL_REPEAT;
}

GLint filter_of(PackedFilter filter) {
  switch (filter) {
    case PackedFilter::nearest: return GL_NEAREST;
    case PackedFilter::linear: return GL_LINEAR;
    case PackedFilter::linear_mipmap_linear: return GL_LINEAR_MIPMAP_LINEAR;
    case PackedFilter::nearest_mipmap_nearest: return GL_NEAREST_MIPMAP_NEAREST;
  }
  return GL_LINEAR;
}

bool has_mipmaps(PackedFilter filter) {
  return filter >= PackedFilter::linear_mipmap_linear;
}

std::vector<std::uint8_t> expand_to_rgba(const PackedImage& image, std::size_t pixel_count) {
  const std::uint8_t* const pixels = image.pixels()->data();
  const std::size_t channels = image.channels();
  std::vector<std::uint8_t> rgba(pixel_count * 4);
  for (std::size_t i = 0; i < pixel_count; ++i) {
    const std::uint8_t* const from = pixels + i * channels;
    const bool grey = channels < 3;
    rgba[i * 4] = from[0];
    rgba[i * 4 + 1] = grey ? from[0] : from[1];
    rgba[i * 4 + 2] = grey ? from[0] : from[2];
    rgba[i * 4 + 3] = channels == 2 ? from[1] : channels == 4 ? from[3] : 255;
  }
  return rgba;
}

void set_filters(const Functions& gl, GLenum target, GLint minification, GLint magnification) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, minification);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, magnification);
}

void set_wrap(const Functions& gl, GLenum target, GLint s, GLint t, GLint r) {
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, s);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, t);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_R, r);
}

void set_border(const Functions& gl, GLenum target, const PackedBorder* border) {
  if (border == nullptr) return;
  const std::array<GLfloat, 4> color = {border->red(), border->green(), border->blue(), border->alpha()};
  gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, color.data());
}

void upload_slices(const Functions& gl, GLenum target, GLsizei width, GLsizei height, GLsizei depth, const std::uint8_t* rgba) {
  if (target == GL_TEXTURE_3D) {
    gl.TexImage3D(target, 0, GL_RGBA8, width, height, depth, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  } else if (target == GL_TEXTURE_CUBE_MAP) {
    const std::size_t face_bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
    for (int face = 0; face < kCubeFaces; ++face) {
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), 0, GL_RGBA8, width, height, 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, rgba + static_cast<std::size_t>(face) * face_bytes);
    }
  } else {
    gl.TexImage2D(target, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  }
}

/// Memory for every face, at the far plane when one texel.
void allocate_depth(const Functions& gl, GLenum target, GLsizei size, bool reversed, const void* data) {
  const GLint format = reversed ? GL_DEPTH_COMPONENT32F : GL_DEPTH_COMPONENT24;
  const int faces = target == GL_TEXTURE_CUBE_MAP ? kCubeFaces : 1;
  const GLenum first = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
  for (int face = 0; face < faces; ++face) {
    gl.TexImage2D(first + static_cast<GLenum>(face), 0, format, size, size, 0, GL_DEPTH_COMPONENT, GL_FLOAT, data);
  }
}

Texture make_compared_texture(const Functions& gl, GLenum target, GLsizei size, bool reversed, GLint filter, const void* data) {
  Texture texture = begin_texture(gl, target);
  allocate_depth(gl, target, size, reversed, data);
  set_filters(gl, target, filter, filter);
  const GLint wrap = target == GL_TEXTURE_2D ? GL_CLAMP_TO_BORDER : GL_CLAMP_TO_EDGE;
  set_wrap(gl, target, wrap, wrap, wrap);
  const GLfloat far = reversed ? 0 : 1;
  const std::array<GLfloat, 4> lit = {far, far, far, far};
  gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, lit.data());
  gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(target, GL_TEXTURE_COMPARE_FUNC, reversed ? GL_GEQUAL : GL_LEQUAL);
  gl.TexParameteri(target, GL_TEXTURE_SWIZZLE_G, GL_RED);  // without a comparison it is a grey picture
  gl.TexParameteri(target, GL_TEXTURE_SWIZZLE_B, GL_RED);
  return texture;
}

}  // namespace

GLenum texture_target(PackedUniformType sampler) {
  switch (sampler) {
    case PackedUniformType::sampler3D: return GL_TEXTURE_3D;
    case PackedUniformType::samplerCube:
    case PackedUniformType::samplerCubeShadow: return GL_TEXTURE_CUBE_MAP;
    default: return GL_TEXTURE_2D;
  }
}

GLsizei max_texture_side(const Functions& gl, GLenum target) {
  GLint side = 0;
  gl.GetIntegerv(target == GL_TEXTURE_3D         ? GL_MAX_3D_TEXTURE_SIZE
                 : target == GL_TEXTURE_CUBE_MAP ? GL_MAX_CUBE_MAP_TEXTURE_SIZE
                                                 : GL_MAX_TEXTURE_SIZE,
                 &side);
  return side;
}

Texture upload_texture(const Functions& gl, const PackedTexture& texture, const PackedImage& image, PackedUniformType sampler) {
  const GLenum target = texture_target(sampler);
  const std::size_t pixel_count = std::size_t{image.width()} * image.height() * image.depth();
  if (target == GL_TEXTURE_CUBE_MAP && (image.depth() != kCubeFaces || image.width() != image.height())) return {};
  Texture handle = begin_texture(gl, target);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  upload_slices(gl, target, static_cast<GLsizei>(image.width()), static_cast<GLsizei>(image.height()),
                static_cast<GLsizei>(image.depth()), expand_to_rgba(image, pixel_count).data());
  set_filters(gl, target, filter_of(texture.minification()), filter_of(texture.magnification()));
  set_wrap(gl, target, wrap_of(texture.wrap_s()), wrap_of(texture.wrap_t()), wrap_of(texture.wrap_r()));
  set_border(gl, target, texture.border());
  if (has_mipmaps(texture.minification())) gl.GenerateMipmap(target);
  return handle;
}

namespace {

/// A new texture to draw into.
Texture begin_drawn_texture(const Functions& gl, GLenum target, const TextureSettings& settings) {
  Texture texture = begin_texture(gl, target);
  set_filters(gl, target, filter_of(settings.minification), filter_of(settings.magnification));
  set_wrap(gl, target, wrap_of(settings.wrap_s), wrap_of(settings.wrap_t), GL_CLAMP_TO_EDGE);
  set_border(gl, target, settings.border);
  return texture;
}

}  // namespace

Texture make_color_texture(const Functions& gl, GLenum target, GLsizei width, GLsizei height, const TextureSettings& settings) {
  Texture texture = begin_drawn_texture(gl, target, settings);
  const bool cube = target == GL_TEXTURE_CUBE_MAP;
  for (int face = 0; face < (cube ? kCubeFaces : 1); ++face) {
    const GLenum image = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : target;
    gl.TexImage2D(image, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  }
  return texture;
}

Texture make_depth_picture(const Functions& gl, GLsizei width, GLsizei height, const TextureSettings& settings) {
  Texture texture = begin_drawn_texture(gl, GL_TEXTURE_2D, settings);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_RED);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_RED);
  return texture;
}

void update_mipmaps(const Functions& gl, GLenum target, const Texture& texture, PackedFilter minification) {
  if (!has_mipmaps(minification)) return;
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kUploadUnit));
  gl.BindTexture(target, texture.id());
  gl.GenerateMipmap(target);
}

Texture make_white_texture(const Functions& gl, GLenum target) {
  Texture texture = begin_texture(gl, target);
  std::array<std::uint8_t, kWhite.size() * kCubeFaces> pixels{};
  pixels.fill(kWhite[0]);
  upload_slices(gl, target, 1, 1, 1, pixels.data());
  set_filters(gl, target, GL_LINEAR, GL_LINEAR);
  return texture;
}

Texture make_depth_texture(const Functions& gl, GLenum target, GLsizei size, bool reversed, GLint filter) {
  return make_compared_texture(gl, target, size, reversed, filter, nullptr);
}

Texture make_lit_texture(const Functions& gl, GLenum target, bool reversed) {
  return make_compared_texture(gl, target, 1, reversed, GL_LINEAR, reversed ? kReversedFar.data() : kFar.data());
}

Texture make_float_texture(const Functions& gl, GLsizei size, bool two_channels) {
  Texture texture = begin_texture(gl, GL_TEXTURE_2D);
  gl.TexImage2D(GL_TEXTURE_2D, 0, two_channels ? GL_RG32F : GL_RGBA32F, size, size, 0, two_channels ? GL_RG : GL_RGBA, GL_FLOAT,
                nullptr);
  set_filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  set_wrap(gl, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
  return texture;
}

void set_mask(const Functions& gl, Texture& texture, GLsizei width, GLsizei height, const std::vector<std::uint8_t>& mask) {
  if (!texture) {
    texture = begin_texture(gl, GL_TEXTURE_2D);
    set_filters(gl, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    set_wrap(gl, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
  }
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kUploadUnit));
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, mask.data());
}

namespace {

Sampler make_sampler(const Functions& gl, GLint compare_mode, GLint filter, GLint wrap) {
  Sampler sampler = generate<Sampler>(gl, gl.GenSamplers);
  gl.SamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_MODE, compare_mode);
  gl.SamplerParameteri(sampler.id(), GL_TEXTURE_MIN_FILTER, filter);
  gl.SamplerParameteri(sampler.id(), GL_TEXTURE_MAG_FILTER, filter);
  gl.SamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_S, wrap);
  gl.SamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_T, wrap);
  return sampler;
}

}  // namespace

Sampler make_depth_texel_sampler(const Functions& gl) {
  return make_sampler(gl, GL_NONE, GL_NEAREST, GL_CLAMP_TO_EDGE);
}

Sampler make_depth_picture_sampler(const Functions& gl) {
  return make_sampler(gl, GL_NONE, GL_LINEAR, GL_CLAMP_TO_EDGE);
}

Sampler make_greater_sampler(const Functions& gl) {
  Sampler sampler = make_sampler(gl, GL_COMPARE_REF_TO_TEXTURE, GL_LINEAR, GL_CLAMP_TO_BORDER);
  gl.SamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
  constexpr std::array<GLfloat, 4> far = {1, 1, 1, 1};
  gl.SamplerParameterfv(sampler.id(), GL_TEXTURE_BORDER_COLOR, far.data());
  return sampler;
}

void bind_texture(const Functions& gl, GLint unit, GLenum target, GLuint texture, GLuint sampler) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(target, texture);
  gl.BindSampler(static_cast<GLuint>(unit), sampler);
}

}  // namespace plugc::gl

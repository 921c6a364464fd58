#pragma once
// Textures: pictures of a package, depth maps, and the stand-ins for what is missing.

#include <vector>

#include "package/package_file.h"
#include "runtime/gl/objects.h"

namespace plugc::gl {

/// Programs use the units below. OpenGL 3.3 guarantees 48.
inline constexpr GLint kUploadUnit = 47;

/// The texture target that a sampler of that type reads.
GLenum texture_target(PackedUniformType sampler);

/// Texels along a side that a texture of that target may have.
GLsizei max_texture_side(const Functions& gl, GLenum target);

/// A picture as that sampler type sees it: 2D takes the first slice, 3D all, a cube six slices (+x -x +y -y +z -z).
/// No name when the picture does not fit (a cube of other than six square slices).
Texture upload_texture(const Functions& gl, const PackedTexture& texture, const PackedImage& image, PackedUniformType sampler);

/// How a texture is looked up.
struct TextureSettings {
  PackedWrap wrap_s = PackedWrap::clamp_to_edge, wrap_t = PackedWrap::clamp_to_edge;
  PackedFilter minification = PackedFilter::linear, magnification = PackedFilter::linear;
  const PackedBorder* border = nullptr;  ///< Null: all 0.
};

/// Colours of 8 bits a channel to draw into; `target` 2D or cube.
Texture make_color_texture(const Functions& gl, GLenum target, GLsizei width, GLsizei height, const TextureSettings& settings);
/// Depths to draw into, read as they are stored, as a grey picture. Their format is that of make_color_target().
Texture make_depth_picture(const Functions& gl, GLsizei width, GLsizei height, const TextureSettings& settings);
/// The smaller copies that the minification filter reads, made from what the texture holds; nothing where it reads none.
void update_mipmaps(const Functions& gl, GLenum target, const Texture& texture, PackedFilter minification);

/// One white texel, for samplers that nothing feeds.
Texture make_white_texture(const Functions& gl, GLenum target);

/// A square depth texture that compares the nearest texel (`filter` GL_NEAREST) or 2x2 by the hardware (GL_LINEAR), and is lit
/// outside its border. `target` 2D or cube. `reversed`: what is stored falls from 1 (near) to 0 (far), and who reads it keeps
/// what it compares at 0 or above.
Texture make_depth_texture(const Functions& gl, GLenum target, GLsizei size, bool reversed, GLint filter);
/// One texel at the far plane: shadows nothing.
Texture make_lit_texture(const Functions& gl, GLenum target, bool reversed);

/// A square texture of 32-bit floats, of two or of four channels, filtered, its edge repeated outside.
Texture make_float_texture(const Functions& gl, GLsizei size, bool two_channels);

/// One number a pixel, 0 to 255, read as the red of a picture of that size. Makes the texture where it is none.
void set_mask(const Functions& gl, Texture& texture, GLsizei width, GLsizei height, const std::vector<std::uint8_t>& mask);

/// Reads a depth texture as it is stored, texel by texel.
Sampler make_depth_texel_sampler(const Functions& gl);
/// Reads a depth texture as a grey picture: no comparison.
Sampler make_depth_picture_sampler(const Functions& gl);

/// Reads a depth texture as lit where its texels are at most the reference depth. Outside its border all is far.
Sampler make_greater_sampler(const Functions& gl);

/// Binds to a unit; `sampler` 0 for the texture's own settings.
void bind_texture(const Functions& gl, GLint unit, GLenum target, GLuint texture, GLuint sampler);

}  // namespace plugc::gl

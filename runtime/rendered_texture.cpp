#include "runtime/rendered_texture.h"

#include <algorithm>

#include "base/rendered_limits.h"
#include "runtime/cube_map.h"

namespace plugc {
namespace {

GLsizei usable_side(std::uint32_t wanted, std::uint32_t largest, Messages& messages) {
  const std::uint32_t side = std::clamp(wanted, 1U, largest);
  if (side != wanted)
    messages.add("a rendered texture cannot have " + std::to_string(wanted) + " texels along a side: it gets " +
                 std::to_string(side));
  return static_cast<GLsizei>(side);
}

gl::TextureSettings settings_of(const PackedRenderedTexture& packed) {
  const bool depth = packed.kind() == PackedRenderedKind::depth;  // which has no smaller copies
  return {packed.wrap_s(), packed.wrap_t(), depth ? PackedFilter::linear : packed.minification(), packed.magnification(),
          packed.border()};
}

DrawnPicture make_cube(const gl::Functions& gl, const PackedRenderedTexture& packed, GLsizei side) {
  DrawnPicture made;
  made.texture = gl::make_color_texture(gl, GL_TEXTURE_CUBE_MAP, side, side, settings_of(packed));
  made.depth = gl::make_depth_buffer(gl, side, side);
  for (GLenum face = 0; face < kCubeFaceCount; ++face)
    made.targets.push_back(gl::make_texture_target(gl, made.texture, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, made.depth));
  return made;
}

DrawnPicture make_flat(const gl::Functions& gl, const PackedRenderedTexture& packed, GLsizei width, GLsizei height) {
  DrawnPicture made;
  const gl::TextureSettings settings = settings_of(packed);
  if (packed.kind() == PackedRenderedKind::depth) {
    made.texture = gl::make_depth_picture(gl, width, height, settings);
    made.color = gl::make_color_texture(gl, GL_TEXTURE_2D, width, height, {});
    made.targets.push_back(gl::make_texture_target(gl, made.color, made.texture));
  } else {
    made.texture = gl::make_color_texture(gl, GL_TEXTURE_2D, width, height, settings);
    made.depth = gl::make_depth_buffer(gl, width, height);
    made.targets.push_back(gl::make_texture_target(gl, made.texture, GL_TEXTURE_2D, made.depth));
  }
  return made;
}

DrawnPicture make_picture(const gl::Functions& gl, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  const bool cube = packed.kind() == PackedRenderedKind::cube;
  return cube ? make_cube(gl, packed, made.width) : make_flat(gl, packed, made.width, made.height);
}

bool is_complete(const gl::Functions& gl, const DrawnPicture& picture) {
  return std::ranges::all_of(picture.targets, [&](const gl::Framebuffer& target) { return gl::is_complete(gl, target); });
}

/// Takes its texels from those that are left; a second picture only while there are enough.
RenderedTexture make_rendered_texture(const gl::Functions& gl, const PackedRenderedTexture& packed, bool may_show_itself,
                                      std::uint64_t& texels_left, Messages& messages) {
  RenderedTexture made;
  const bool cube = packed.kind() == PackedRenderedKind::cube;
  const GLsizei of_driver = cube ? gl::max_cube_map_side(gl) : gl::max_target_side(gl);
  const std::uint32_t largest = std::min(cube ? kMaxRenderedCubeSide : kMaxRenderedSide, static_cast<std::uint32_t>(of_driver));
  made.width = usable_side(packed.width(), largest, messages);
  made.height = cube ? made.width : usable_side(packed.height(), largest, messages);
  const std::uint64_t texels =
      static_cast<std::uint64_t>(made.width) * static_cast<std::uint64_t>(made.height) * (cube ? kCubeFaceCount : 1);
  if (texels > texels_left) {
    messages.add("the scene's rendered textures have more than " + std::to_string(kMaxRenderedTexels) +
                 " texels: the last are white");
    return {};
  }
  texels_left -= texels;
  made.minification = settings_of(packed).minification;
  made.shown = make_picture(gl, packed, made);
  if (may_show_itself && texels <= texels_left) {
    texels_left -= texels;
    made.next = make_picture(gl, packed, made);
  }
  if (is_complete(gl, made.shown) && is_complete(gl, made.next)) return made;
  messages.add("the driver cannot draw a texture of " + std::to_string(made.width) + " by " + std::to_string(made.height) +
               ": it is white");
  return {};
}

/// Whether some reader stands in what it shows. One that hangs on its reader's place is drawn without that.
bool may_show_itself(const PackedScene& scene, std::uint32_t index, const std::vector<std::uint32_t>& readers) {
  const PackedRenderedTexture& packed = *scene.rendered_textures()->Get(index);
  const std::int32_t shown = packed.own_scene() ? static_cast<std::int32_t>(index) : -1;
  const auto there = std::ranges::count_if(
      readers, [&](std::uint32_t reader) { return scene.shapes()->Get(reader)->own_scene_of() == shown; });
  return there > (packed.in_mirror() || packed.kind() == PackedRenderedKind::cube ? 1 : 0);
}

}  // namespace

std::vector<RenderedTexture> make_rendered_textures(const gl::Functions& functions, const PackedScene& scene,
                                                    const BindingReaders& readers_of, Messages& messages) {
  std::vector<RenderedTexture> all;
  std::uint64_t texels_left = kMaxRenderedTexels;
  const std::uint32_t count = scene.rendered_textures() == nullptr ? 0 : scene.rendered_textures()->size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const PackedRenderedTexture& packed = *scene.rendered_textures()->Get(i);
    const std::vector<std::uint32_t>& readers = readers_of.of_texture[i];
    const bool read_by_screen = readers_of.on_screen[i];
    const bool of_use = (!readers.empty() || read_by_screen) && packed.update() != PackedShadowUpdate::none;
    all.push_back(of_use ? make_rendered_texture(functions, packed, may_show_itself(scene, i, readers), texels_left, messages)
                         : RenderedTexture());
    all.back().readers = readers;
    all.back().read_by_screen = read_by_screen;
  }
  return all;
}

}  // namespace plugc

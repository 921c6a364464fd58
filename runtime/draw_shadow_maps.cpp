// A map that is fitted to what the camera shows is drawn for one view. Where a frame has several, it is fitted and drawn anew
// for each: fitted to all of them at once it would lose, in the picture, the texels that the fit is for.

#include "runtime/draw_shadow_maps.h"

#include <algorithm>
#include <cmath>

#include "runtime/cube_map.h"
#include "runtime/draw_shape.h"
#include "runtime/gl/pass.h"
#include "runtime/update_shadow_map.h"

namespace plugc {
namespace {

/// glPolygonOffset takes any float but NaN and infinity.
float finite_offset(double value) {
  return std::isfinite(value) ? static_cast<float>(std::clamp(value, -1e6, 1e6)) : 0.0F;
}

/// Turns the map's depths into moments, and blurs them along rows and then along columns. False where the driver rejected one
/// of the programs.
bool make_moments(Frame& frame, std::uint32_t index, Pass& pass) {
  const PackedShadowMap& packed = *frame.scene.packed->shadow_maps()->Get(index);
  const ShadowMap& map = frame.scene.shadow_maps[index];
  const auto draw = [&](const gl::Framebuffer& target, std::int32_t program, const auto& bindings) {
    gl::begin_whole_pass(frame.gl, target, map.size, map.size);
    return draw_over_target(frame.gl, frame.scene, pass, static_cast<std::uint32_t>(program), bindings, frame.messages);
  };
  frame.statistics.shadow_filter_passes += 2;
  return draw(map.unblurred_target, packed.moments_program(), *packed.moments_bindings()) &&
         draw(map.moments_target, packed.blur_program(), *packed.blur_bindings());
}

/// From now on whoever reads the map is lit.
void give_up(ShadowMap& map) {
  map.texture = {};
  map.in_use = false;
}

/// The casters that the pass sees, into the depth target that is bound.
void draw_casters(Frame& frame, Pass& pass) {
  std::uint32_t drawn = 0;
  for (const std::uint32_t shape : caster_order(frame.scene, pass.view, pass.of_point_light))
    drawn += draw_shape(frame.gl, frame.scene, pass, shape, frame.messages) ? 1 : 0;
  frame.statistics.shadow_draw_calls += drawn;
  frame.statistics.shadow_passes += drawn != 0 ? 1 : 0;  // without a caster the map is only cleared
}

Pass depth_pass(const View& view) {
  return {.view = view, .depth_only = true, .shadows = false};
}

/// The six faces of a point light's map; one that nobody looks into is only cleared.
void draw_cube_map(Frame& frame, std::uint32_t index, const glm::vec2& offset) {
  const ShadowMap& map = frame.scene.shadow_maps[index];
  for (unsigned face = 0; face < kCubeFaceCount; ++face) {
    gl::begin_depth_pass(frame.gl, map.faces[face], map.size, 0, 0, false);
    if (std::ranges::find(map.read_faces, face) == map.read_faces.end()) continue;
    const View view = cube_face(map.view, face);
    Pass pass = depth_pass(view);
    pass.of_point_light = true;
    pass.depth_range = depth_pass_range(map.view, double(offset.x), double(offset.y));
    draw_casters(frame, pass);
    frame.programs.merge(pass.programs);
  }
}

void draw_shadow_map(Frame& frame, std::uint32_t index) {
  const PackedShadowMap& packed = *frame.scene.packed->shadow_maps()->Get(index);
  ShadowMap& map = frame.scene.shadow_maps[index];
  const Slots& slots = frame.scene.slots;
  const glm::vec2 offset(finite_offset(slots.number(packed.scale(), 4)),
                         finite_offset(slots.number(packed.bias(), 4) * map.fit.coarseness));
  if (map.view.all_around) return draw_cube_map(frame, index, offset);
  gl::begin_depth_pass(frame.gl, map.framebuffer, map.size, offset.x, offset.y, map.reversed);
  Pass pass = depth_pass(map.view);
  draw_casters(frame, pass);
  frame.programs.merge(pass.programs);  // those that filter the map do not count
  if (map.moments && !make_moments(frame, index, pass)) give_up(map);
}

}  // namespace

void draw_shadow_maps(Frame& frame, const View& camera) {
  for (std::uint32_t i = 0; i < frame.scene.shadow_maps.size(); ++i) {
    if (update_shadow_map(frame.scene, i, camera, frame.messages)) draw_shadow_map(frame, i);
  }
}

}  // namespace plugc

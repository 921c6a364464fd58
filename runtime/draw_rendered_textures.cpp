// A cube's six views share their shadow maps: those are made for whoever looks, from all around. Nothing that is drawn into is
// read meanwhile, so that a scene which shows itself ends after one step. The first time, all is drawn twice: what came first
// has seen the others white.

#include "runtime/draw_rendered_textures.h"

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/cube_map.h"
#include "runtime/draw_view.h"
#include "runtime/place_scene.h"

namespace plugc {
namespace {

bool may_be_seen(const LoadedScene& scene, const RenderedTexture& made) {
  return made.read_by_screen || std::ranges::any_of(made.readers, [&](std::uint32_t reader) {
           return scene.world.at(scene.shape(reader).transform()).visible;
         });
}

bool is_due(const LoadedScene& scene, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  if (!made.texture || packed.update() == PackedShadowUpdate::none) return false;
  return (packed.update() == PackedShadowUpdate::always || !made.drawn) && may_be_seen(scene, made);
}

/// What the field `rendering` tells the rest of the scene.
void set_rendering(LoadedScene& scene, const PackedRenderedTexture& packed, bool rendering) {
  if (packed.rendering_slots() == nullptr) return;
  const std::array<double, 1> value = {rendering ? 1.0 : 0.0};
  for (const std::uint32_t slot : *packed.rendering_slots()) scene.slots.set(slot, value);
}

std::uint32_t background_of(const LoadedScene& scene, const PackedRenderedTexture& packed) {
  return packed.background_color() == kNoSlot ? scene.packed->background_color() : packed.background_color();
}

void draw(Frame& frame, const RenderedTexture& made, std::size_t target, SceneView& view) {
  const bool in_world = frame.scene.placed_scene < 0;
  if (in_world) view.wearer = &frame.viewer;  // whose headlight stays where it is, as the reference engine has it, measured
  draw_view(frame, {made.targets[target], made.width, made.height}, view);
  ++frame.statistics.rendered_views;
}

View flat_camera(Frame& frame, const PackedRenderedTexture& packed, double aspect) {
  const LoadedScene& scene = frame.scene;
  if (packed.viewpoint() >= 0) {
    const auto index = static_cast<std::uint32_t>(packed.viewpoint());
    return view_from(*scene.packed->projectors()->Get(index), scene.slots, scene.world, aspect);
  }
  if (packed.own_scene()) return view_of_world(scene.world, aspect);
  return make_camera(*scene.packed, scene.slots, scene.world, frame.options.viewpoint, aspect, frame.messages);
}

void draw_flat(Frame& frame, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  const double aspect = static_cast<double>(made.width) / made.height;
  SceneView view;
  view.camera = settled_camera(frame.scene, [&] { return flat_camera(frame, packed, aspect); });
  view.shadow_camera = view.camera;
  const bool as_picture = packed.viewpoint() < 0 && !packed.own_scene();
  if (as_picture) view.viewpoint = bound_viewpoint(*frame.scene.packed, frame.scene.slots, frame.options.viewpoint);
  view.background_color = background_of(frame.scene, packed);
  draw(frame, made, 0, view);
}

/// All around a place, as far as the scene reaches.
View around(const World& world, const glm::dvec3& place) {
  double reach = 0;
  for (const glm::dvec3& corner : corners(world.bounds)) reach = std::max(reach, glm::length(corner - place));
  constexpr double kSmallestReach = 1e-30, kLargestReach = 1e30;
  if (!(reach >= kSmallestReach && reach <= kLargestReach)) reach = 1;
  View view;
  view.all_around = true;
  view.world_to_eye = glm::translate(glm::dmat4(1.0), -place);
  view.eye_to_world = glm::translate(glm::dmat4(1.0), place);
  view.projection = glm::scale(glm::dmat4(1.0), glm::dvec3(1 / reach));
  return view;
}

/// The first of those that read it which is there to be seen; -1: none is.
std::int32_t seen_from(const LoadedScene& scene, const RenderedTexture& made) {
  const auto found = std::ranges::find_if(made.readers, [&](std::uint32_t reader) {
    return scene.world.shape_visible[reader] && !scene.world.shape_bounds[reader].empty();
  });
  return found == made.readers.end() ? -1 : static_cast<std::int32_t>(*found);
}

void draw_cube(Frame& frame, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  LoadedScene& scene = frame.scene;
  const std::int32_t shape = seen_from(scene, made);
  const glm::dvec3 place = shape < 0 ? glm::dvec3(0) : scene.world.shape_bounds[static_cast<std::size_t>(shape)].center();
  SceneView view;
  view.shadow_camera = around(scene.world, place);
  view.without_shape = shape;
  view.background_color = background_of(scene, packed);
  place_for_viewer(scene, view.shadow_camera);
  for (unsigned face = 0; face < kCubeFaceCount; ++face) {
    view.camera = cube_face(view.shadow_camera, face);
    draw(frame, made, face, view);
  }
}

void draw_rendered_texture(Frame& frame, std::uint32_t index) {
  LoadedScene& scene = frame.scene;
  const PackedRenderedTexture& packed = *scene.packed->rendered_textures()->Get(index);
  RenderedTexture& made = scene.rendered_textures[index];
  const bool cube = packed.kind() == PackedRenderedKind::cube;
  set_rendering(scene, packed, true);
  place_scene(scene, packed.own_scene() ? static_cast<std::int32_t>(index) : -1);
  made.being_drawn = true;
  cube ? draw_cube(frame, packed, made) : draw_flat(frame, packed, made);
  made.being_drawn = false;
  made.drawn = true;
  set_rendering(scene, packed, false);
  gl::update_mipmaps(frame.gl, cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D, made.texture, packed.minification());
}

}  // namespace

void draw_rendered_textures(Frame& frame) {
  LoadedScene& scene = frame.scene;
  place_scene(scene);
  std::vector<std::uint32_t> due;
  bool any_new = false;
  for (std::uint32_t i = 0; i < scene.rendered_textures.size(); ++i) {
    const RenderedTexture& made = scene.rendered_textures[i];
    if (!is_due(scene, *scene.packed->rendered_textures()->Get(i), made)) continue;
    due.push_back(i);
    any_new = any_new || !made.drawn;
  }
  const int rounds = any_new && due.size() > 1 ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    for (const std::uint32_t texture : due) draw_rendered_texture(frame, texture);
  }
}

}  // namespace plugc

// A cube's six views share their shadow maps: those are made for whoever looks, from all around. Nothing that is drawn into is
// read meanwhile: a texture that shows itself shows what it held before, and so do two that show each other. So each frame is
// one step deeper; of the first picture a few steps are made at once, as the first sees the textures white.

#include "runtime/draw_rendered_textures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/cube_map.h"
#include "runtime/draw_view.h"
#include "runtime/mirror.h"
#include "runtime/place_scene.h"
#include "runtime/view_slots.h"

namespace plugc {
namespace {

constexpr int kFirstRounds = 3;  // what is seen in what is seen in a texture

bool may_be_seen(const LoadedScene& scene, const RenderedTexture& made) {
  return made.read_by_screen || std::ranges::any_of(made.readers, [&](std::uint32_t reader) {
           return scene.world.at(scene.shape(reader).transform()).visible;
         });
}

bool is_due(const LoadedScene& scene, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  if (!made.shown.texture || packed.update() == PackedShadowUpdate::none) return false;
  return (packed.update() == PackedShadowUpdate::always || made.times_drawn == 0) && may_be_seen(scene, made);
}

/// What is around the view of the texture of that index.
void set_background(const LoadedScene& scene, std::uint32_t index, SceneView& view) {
  const PackedRenderedTexture& packed = *scene.packed->rendered_textures()->Get(index);
  view.background_color = packed.background_color() == kNoSlot ? scene.packed->background_color() : packed.background_color();
  if (packed.own_backdrop()) view.backdrop_of = static_cast<std::int32_t>(index);
}

void draw(Frame& frame, const RenderedTexture& made, std::size_t target, SceneView& view) {
  const bool in_world = frame.scene.placed_scene < 0;
  if (in_world) view.wearer = &frame.viewer;  // whose headlight stays where it is, as the reference engine has it, measured
  const DrawnPicture& into = made.next.texture ? made.next : made.shown;
  draw_view(frame, {into.targets[target], made.width, made.height}, view);
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

SceneView flat_view(Frame& frame, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  const double aspect = static_cast<double>(made.width) / made.height;
  SceneView view;
  look_through(frame.scene, settled_camera(frame.scene, [&] { return flat_camera(frame, packed, aspect); }), view);
  const bool as_picture = packed.viewpoint() < 0 && !packed.own_scene();
  if (as_picture) view.viewpoint = bound_viewpoint(*frame.scene.packed, frame.scene.slots, frame.options.viewpoint);
  return view;
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

/// What the viewer sees in the shape that has the texture; nullopt where there is no mirror for him to look into. What turns to
/// him stays as it is for him.
std::optional<SceneView> mirror_view(Frame& frame, const PackedRenderedTexture& packed, const RenderedTexture& made) {
  LoadedScene& scene = frame.scene;
  const std::int32_t index = seen_from(scene, made);
  if (index < 0 || scene.shape(static_cast<std::uint32_t>(index)).mirror() == nullptr) return std::nullopt;
  place_for_viewer(scene, frame.viewer);
  const PackedShape& shape = scene.shape(static_cast<std::uint32_t>(index));
  const Mirror mirror = place_mirror(*shape.mirror(), scene.world.at(shape.transform()).matrix);
  const double distance = scene.slots.number(packed.distance_from_shape(), 0);
  const auto camera = view_in_mirror(mirror, frame.viewer, distance, scene.world.bounds);
  if (!camera) return std::nullopt;
  SceneView view;
  view.camera = *camera;
  view.without_shape = index;
  view.clips_depth = true;
  return view;
}

std::optional<SceneView> draw_flat(Frame& frame, std::uint32_t index) {
  LoadedScene& scene = frame.scene;
  const PackedRenderedTexture& packed = *scene.packed->rendered_textures()->Get(index);
  const RenderedTexture& made = scene.rendered_textures[index];
  std::optional<SceneView> view =
      packed.in_mirror() ? mirror_view(frame, packed, made) : std::optional(flat_view(frame, packed, made));
  if (!view) return std::nullopt;
  view->shadow_camera = view->camera;
  set_background(scene, index, *view);
  tell_view(scene.slots, packed, view->camera);
  draw(frame, made, 0, *view);
  return view;
}

SceneView draw_cube(Frame& frame, std::uint32_t index) {
  LoadedScene& scene = frame.scene;
  const RenderedTexture& made = scene.rendered_textures[index];
  const std::int32_t shape = seen_from(scene, made);
  const glm::dvec3 place = shape < 0 ? glm::dvec3(0) : scene.world.shape_bounds[static_cast<std::size_t>(shape)].center();
  SceneView view;
  view.shadow_camera = around(scene.world, place);
  view.without_shape = shape;
  set_background(scene, index, view);
  place_for_viewer(scene, view.shadow_camera);
  for (unsigned face = 0; face < kCubeFaceCount; ++face) {
    look_through(scene, cube_face(view.shadow_camera, face), view);
    draw(frame, made, face, view);
  }
  return view;
}

/// Whether a shape that shows a rendered texture may be seen in that view of the scene as it is placed.
bool shows_textures(const LoadedScene& scene, const SceneView& view) {
  const glm::dmat4 to_clip = view.shadow_camera.projection * view.shadow_camera.world_to_eye;
  const auto is_shown = [&](std::uint32_t shape) {
    const Box& bounds = scene.world.shape_bounds[shape];
    if (!scene.world.shape_visible[shape] || bounds.empty() || static_cast<std::int32_t>(shape) == view.without_shape)
      return false;
    return view.shadow_camera.all_around || !outside_sideways(bounds, to_clip);
  };
  return std::ranges::any_of(scene.rendered_textures,
                             [&](const RenderedTexture& made) { return std::ranges::any_of(made.readers, is_shown); });
}

/// True where another round would make another picture: it shows rendered textures.
bool draw_rendered_texture(Frame& frame, std::uint32_t index) {
  LoadedScene& scene = frame.scene;
  const PackedRenderedTexture& packed = *scene.packed->rendered_textures()->Get(index);
  RenderedTexture& made = scene.rendered_textures[index];
  const bool cube = packed.kind() == PackedRenderedKind::cube;
  const LentSlots lent = begin_view(scene.slots, packed);
  place_scene(scene, packed.own_scene() ? static_cast<std::int32_t>(index) : -1);
  made.being_drawn = true;
  const std::optional<SceneView> view = cube ? std::optional(draw_cube(frame, index)) : draw_flat(frame, index);
  made.being_drawn = false;
  const bool shows_others = view && shows_textures(scene, *view);
  end_view(scene.slots, packed, lent);
  if (!view) return false;
  ++made.times_drawn;
  if (made.next.texture) std::swap(made.shown, made.next);
  gl::update_mipmaps(frame.gl, cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D, made.shown.texture, made.minification);
  return shows_others;
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
    any_new = any_new || made.times_drawn == 0;
  }
  for (int round = 0; round < (any_new ? kFirstRounds : 1); ++round)
    std::erase_if(due, [&](std::uint32_t texture) { return !draw_rendered_texture(frame, texture); });
}

}  // namespace plugc

// Cameras and proximity sensors send when the camera is known, which hangs on slots itself. So there are two waves of events a
// frame; what the second one moves is placed again, and the camera with it, but it sends no third.

#include "runtime/scene_time.h"

#include <algorithm>
#include <utility>

#include "runtime/place_scene.h"
#include "runtime/rotations.h"

namespace plugc {
namespace {

std::vector<double> numbers(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}
std::vector<double> numbers(const glm::dmat3& m) {
  return {&m[0][0], &m[0][0] + 9};
}
std::vector<double> numbers(const glm::dmat4& m) {
  return {&m[0][0], &m[0][0] + 16};
}

/// Adds the event unless the slot holds that value and was told so before.
void add_if_new(NodeEvents& events, const PackedEventNode& node, const Slots& slots, std::size_t output,
                std::vector<double> value, bool told) {
  const std::span<const double> held = slots.values(node.outputs()->Get(static_cast<flatbuffers::uoffset_t>(output)));
  if (held.empty() || (told && std::ranges::equal(held, value))) return;
  events.sent.push_back({output, std::move(value)});
}

void look_at_camera(const PackedEventNode& node, const Slots& slots, const View& view, EventMemory& memory,
                    NodeEvents& events) {
  const bool told = std::exchange(memory.has_looked, true);
  add_if_new(events, node, slots, 0, numbers(view.world_to_eye), told);
  add_if_new(events, node, slots, 1, numbers(view.eye_to_world), told);
  add_if_new(events, node, slots, 2, numbers(glm::dmat3(view.world_to_eye)), told);
  add_if_new(events, node, slots, 3, numbers(glm::dmat3(view.eye_to_world)), told);
}

/// X3D 4.1, 22.4.1. A box without volume is never entered.
bool is_inside(const glm::dvec3& eye, const glm::dvec3& center, const glm::dvec3& size) {
  const glm::dvec3 offset = glm::abs(eye - center);
  return size.x > 0 && size.y > 0 && size.z > 0 && 2 * offset.x <= size.x && 2 * offset.y <= size.y && 2 * offset.z <= size.z;
}

void look_for_viewer(const EventNodeInputs& inputs, const glm::dmat4& to_world, const View& view, EventMemory& memory,
                     NodeEvents& events) {
  const glm::dvec3 eye(glm::inverse(to_world) * view.eye_to_world[3]);
  const glm::dvec3 center = inputs.slots.vector3(inputs.slot(1), glm::dvec3(0));
  const glm::dvec3 size = inputs.slots.vector3(inputs.slot(2), glm::dvec3(0));
  const bool inside = inputs.boolean(0, true) && is_inside(eye, center, size);
  const bool was_inside = std::exchange(memory.inside, inside);
  if (inside != was_inside) {
    events.sent.push_back({0, {inside ? 1.0 : 0.0}});
    events.sent.push_back({inside ? 1U : 2U, {inputs.time}});
  }
  if (!inside) return;
  const glm::dmat3 turned = glm::transpose(rotation_of(to_world)) * glm::dmat3(view.eye_to_world);
  add_if_new(events, inputs.node, inputs.slots, 3, numbers(eye), was_inside);
  add_if_new(events, inputs.node, inputs.slots, 4, axis_and_angle(glm::quat_cast(turned)), was_inside);
}

/// What the camera's place sets off.
std::vector<NodeEvents> view_events(LoadedScene& scene, const View& view, std::int32_t viewpoint) {
  std::vector<NodeEvents> all;
  const auto* nodes = scene.packed->event_nodes();
  for (flatbuffers::uoffset_t i = 0; nodes != nullptr && i < nodes->size(); ++i) {
    const PackedEventNode& node = *nodes->Get(i);
    EventMemory& memory = scene.events.memory[i];
    NodeEvents events{i, {}};
    if (node.kind() == PackedEventKind::camera && node.subject() == viewpoint && viewpoint >= 0)
      look_at_camera(node, scene.slots, view, memory, events);
    if (node.kind() == PackedEventKind::proximity_sensor)
      look_for_viewer({node, scene.slots, {}, scene.events.time}, scene.world.at(node.subject()).matrix, view, memory, events);
    if (!events.sent.empty()) all.push_back(std::move(events));
  }
  return all;
}

View reach_moment(LoadedScene& scene, double time, const std::string& wanted, const std::function<View()>& look) {
  advance_events(scene.events, *scene.packed, scene.slots, time);
  place_scene(scene);
  const View view = look();
  const std::int32_t viewpoint = bound_viewpoint(*scene.packed, scene.slots, wanted);
  const std::uint64_t before = scene.slots.revision();
  send_events(scene.events, *scene.packed, scene.slots, view_events(scene, view, viewpoint));
  if (scene.slots.revision() == before) return view;
  place_scene(scene);
  return look();
}

}  // namespace

View reach_time(LoadedScene& scene, double time, const std::string& wanted, const std::function<View()>& look) {
  const std::int32_t viewpoint = bound_viewpoint(*scene.packed, scene.slots, wanted);
  if (viewpoint < 0 && (scene.events.time < 0 || !scene.events.unheard.empty())) {
    place_scene(scene);
    scene.framed = scene.world.framed = scene.world.bounds;
  }
  const bool from_the_start = scene.events.time < 0 || time < scene.events.time;
  if (from_the_start && time > 0) reach_moment(scene, 0, wanted, look);
  return reach_moment(scene, time, wanted, look);
}

}  // namespace plugc

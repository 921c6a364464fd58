// The event graph: slots that exist, as many numbers at both ends of a route. What the numbers say (keys out of order, an empty
// list) is left to the runtime, where events may change them.

#include <utility>

#include "package/package_file_check.h"

namespace plugc {

namespace {

/// Slots that a node reads, and sends from, as the schema lists them.
struct Arity {
  std::size_t inputs = 0, outputs = 0;
};

Arity arity_of(PackedEventKind kind) {
  switch (kind) {
    case PackedEventKind::time_sensor: return {7, 6};
    case PackedEventKind::proximity_sensor: return {3, 5};
    case PackedEventKind::camera: return {0, 4};
    case PackedEventKind::interpolate:
    case PackedEventKind::interpolate_color:
    case PackedEventKind::interpolate_normal:
    case PackedEventKind::interpolate_rotation:
    case PackedEventKind::squad:
    case PackedEventKind::ease: return {3, 1};
    case PackedEventKind::spline: return {6, 1};
    case PackedEventKind::sequence: return {5, 1};
    case PackedEventKind::boolean_filter: return {1, 3};
    case PackedEventKind::boolean_toggle:
    case PackedEventKind::integer_trigger: return {2, 1};
    case PackedEventKind::boolean_trigger:
    case PackedEventKind::time_trigger: return {1, 1};
    case PackedEventKind::bind_stack:
    case PackedEventKind::choose:
    case PackedEventKind::script: return {};  // as many as it has fields
  }
  return {};
}

/// A stack has a slot for each of its nodes, and what is chosen as many as it is chosen from.
bool has_slots_of_kind(const PackedEventNode& node) {
  const std::size_t inputs = node.inputs()->size(), outputs = node.outputs()->size();
  if (node.kind() == PackedEventKind::bind_stack) return outputs == 1 + 2 * inputs;
  if (node.kind() == PackedEventKind::choose) return inputs >= 2 && outputs == 1;
  if (node.kind() == PackedEventKind::script) return inputs == outputs;
  const Arity arity = arity_of(node.kind());
  return inputs == arity.inputs && outputs == arity.outputs;
}

/// All but the index hold what the chosen slot takes; of one that holds more, as a list of colours, its beginning counts.
bool check_choices(SceneCheck& scene, const PackedEventNode& node, std::uint64_t size, const Place& place) {
  for (flatbuffers::uoffset_t i = 1; i < node.inputs()->size(); ++i) {
    const std::uint64_t held = scene.slot_size(node.inputs()->Get(i));
    if (held < size) return scene.check.fail(place, fmt::format("choice {} has {} numbers, not {}", i, held, size));
  }
  return true;
}

/// What the kind's arithmetic takes for granted of the value that is sent.
bool check_width(SceneCheck& scene, const PackedEventNode& node, const Place& place) {
  const auto width = [&](flatbuffers::uoffset_t output) { return scene.slot_size(node.outputs()->Get(output)); };
  const auto is = [&](flatbuffers::uoffset_t output, std::uint64_t wanted) {
    return node.outputs()->Get(output) == kNoSlot || width(output) == wanted ||
           scene.check.fail(place, fmt::format("output {} holds {} numbers, not {}", output, width(output), wanted));
  };
  switch (node.kind()) {
    case PackedEventKind::interpolate:
    case PackedEventKind::script:
    case PackedEventKind::spline: return true;
    case PackedEventKind::interpolate_normal:
      return width(0) % 3 == 0 || scene.check.fail(place, "its value is no list of vectors");
    case PackedEventKind::interpolate_color: return is(0, 3);
    case PackedEventKind::interpolate_rotation:
    case PackedEventKind::squad: return is(0, 4);
    case PackedEventKind::camera: return is(0, 16) && is(1, 16) && is(2, 9) && is(3, 9);
    case PackedEventKind::choose: return check_choices(scene, node, width(0), place);
    case PackedEventKind::proximity_sensor: return is(0, 1) && is(1, 1) && is(2, 1) && is(3, 3) && is(4, 4);
    default: break;
  }
  for (flatbuffers::uoffset_t i = 0; i < node.outputs()->size(); ++i) {
    if (!is(i, 1)) return false;
  }
  return true;
}

bool check_subject(SceneCheck& scene, const PackedEventNode& node, const Place& place) {
  if (node.kind() == PackedEventKind::bind_stack) {
    return is_index_or_none(node.subject(), node.inputs()->size()) ||
           scene.check.fail(place, fmt::format("node {} of the stack does not exist", node.subject()));
  }
  if (node.kind() == PackedEventKind::camera) {
    return is_index_or_none(node.subject(), scene.scene.viewpoints()->size()) ||
           scene.check.fail(place, fmt::format("viewpoint {} does not exist", node.subject()));
  }
  return node.kind() == PackedEventKind::proximity_sensor
             ? scene.transform(place, node.subject())
             : node.subject() == -1 || scene.check.fail(place, "its kind has no subject");
}

bool check_node(SceneCheck& scene, const PackedEventNode& node, const Place& place) {
  PackageCheck& check = scene.check;
  if (!is_enumerator(node.kind())) return check.fail(place, "its kind is unknown");
  const bool is_script = node.kind() == PackedEventKind::script;
  if (!has_slots_of_kind(node)) return check.fail(place, "it has not the slots of its kind");
  if (is_script != (node.script() != nullptr))
    return check.fail(place, is_script ? "it has no script" : "its kind has no script");
  if (is_script && !check_script(check, node, place)) return false;
  const auto is_slot = [&](std::uint32_t slot, const Place& at) { return scene.slot(at, "it", slot, 1); };
  return check.each(&place, "input", *node.inputs(), is_slot) && check.each(&place, "output", *node.outputs(), is_slot) &&
         check_width(scene, node, place) && check_subject(scene, node, place);
}

/// They ascend, so that none is there twice.
bool check_route(SceneCheck& scene, const PackedRoute& route, const Place& place) {
  if (!scene.same_size(place, route.from(), route.to())) return false;
  if (place.index == 0) return true;
  const PackedRoute& before = *scene.scene.routes()->Get(static_cast<flatbuffers::uoffset_t>(place.index - 1));
  return std::pair(before.from(), before.to()) < std::pair(route.from(), route.to()) ||
         scene.check.fail(place, "it is out of order");
}

}  // namespace

bool check_events(SceneCheck& scene, const Place& place) {
  const auto* nodes = scene.scene.event_nodes();
  const auto* routes = scene.scene.routes();
  return (nodes == nullptr ||
          scene.check.each(&place, "event node", *nodes,
                           [&](const PackedEventNode* node, const Place& at) { return check_node(scene, *node, at); })) &&
         (routes == nullptr || scene.check.each(&place, "route", *routes, [&](const PackedRoute* route, const Place& at) {
           return check_route(scene, *route, at);
         }));
}

}  // namespace plugc

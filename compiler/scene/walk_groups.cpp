// Groups: what of their children is shown, where, and under which condition.

#include "scene/scene_walk.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace plugc {

/// The current transform, but only while the field of that node has that value.
SceneTransform SceneWalk::condition(NodeId node, std::string_view field, int value) {
  SceneTransform transform;
  transform.parent = transform_;
  transform.switch_slot = context_.slots.slot(node, field);
  transform.choice = value;
  return transform;
}

int SceneWalk::add_transform(const SceneTransform& transform) {
  context_.scene.transforms.push_back(transform);
  return static_cast<int>(context_.scene.transforms.size() - 1);
}

void SceneWalk::visit_below(const SceneTransform& transform, std::span<const NodeId> nodes) {
  const int outer = std::exchange(transform_, add_transform(transform));
  visit_list(nodes);
  transform_ = outer;
}

/// A Transform, or what has its fields: parts of CAD (X3D 4.1, 32.4.4), figures, their joints and sites (26.3). A figure's
/// other lists name nodes that stand in these two.
void SceneWalk::visit_transform(NodeId node) {
  SceneTransform transform;
  transform.parent = transform_;
  transform.translation = context_.slots.slot_if_used(node, "translation");
  transform.rotation = context_.slots.slot_if_used(node, "rotation");
  transform.scale = context_.slots.slot_if_used(node, "scale");
  transform.scale_orientation = context_.slots.slot_if_used(node, "scaleOrientation");
  transform.center = context_.slots.slot_if_used(node, "center");
  if (!graph_.is(node, "HAnimHumanoid")) return visit_below(transform, graph_.children(node, "children"));
  visit_below(transform, graph_.children(node, "skeleton"));
  visit_below(transform, graph_.children(node, "skin"));
}

void SceneWalk::visit_billboard(NodeId node) {
  SceneTransform transform;
  transform.parent = transform_;
  transform.billboard_axis = context_.slots.slot(node, "axisOfRotation");
  visit_below(transform, graph_.children(node, "children"));
}

/// A Switch that nothing can change is its chosen child; one that a ROUTE drives keeps them all, each under a condition.
void SceneWalk::visit_switch(NodeId node) {
  const auto children = graph_.children(node, "children");
  if (!context_.slots.may_change(node, "whichChoice") && !context_.options.all_branches) {
    const int choice = graph_.integer(node, "whichChoice");
    if (choice >= 0 && static_cast<std::size_t>(choice) < children.size()) {
      visit_list(children.subspan(static_cast<std::size_t>(choice), 1));
    }
    return;
  }
  for (std::size_t i = 0; i < children.size(); ++i) {
    visit_below(condition(node, "whichChoice", static_cast<int>(i)), children.subspan(i, 1));
  }
}

/// Each level under a condition of its own (X3D 4.1, 23.4.3). Ranges that do not grow count as the largest so far.
void SceneWalk::visit_lod(NodeId node) {
  const auto ranges = graph_.field(node, "range").numbers;
  const auto all = graph_.children(node, "children");
  const auto levels = all.subspan(0, std::min(all.size(), ranges.size() + 1));
  if (levels.size() <= 1) return visit_list(levels);
  double from = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    SceneTransform transform;
    transform.parent = transform_;
    transform.lod_center = context_.slots.slot(node, "center");
    transform.lod_from = from;
    const bool is_last = i + 1 == levels.size();
    from = is_last ? std::numeric_limits<double>::infinity() : ranges[i] > from ? ranges[i] : from;
    transform.lod_to = from;
    visit_below(transform, levels.subspan(i, 1));
  }
}

void SceneWalk::visit_inline(NodeId node) {
  check_top(graph_.children(node, "children"));
  ++inlines_;
  visit_list(graph_.children(node, "children"));
  --inlines_;
}

}  // namespace plugc

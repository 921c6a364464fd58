// Nodes are visited in the order of the text, as a renderer of VRML 1.0 does. A file can make few lines stand for very much by
// USE inside USE, so that visits and indices are counted, and the rest is left out beyond a limit.

#include "document/vrml1_scene.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "base/transform_matrix.h"

namespace plugc {
namespace {

constexpr std::size_t kVisitWork = 128;  // of a node, in indices of a shape
constexpr std::size_t kMaxWork = kVisitWork * kMaxSceneNodes;

constexpr Vrml1State no_properties() {
  Vrml1State state;
  state.nodes.fill(kNoVrml1Node);
  return state;
}

}  // namespace

void Vrml1Scene::write() {
  const std::size_t mark = build_.nodes.open();
  const Gathering all = gather(tree_.of(tree_.roots), no_properties());
  write_items(all, all.items);
  write_.end_document(mark);
}

/// False when too much was done already, which is reported once.
bool Vrml1Scene::spend(std::size_t work, const Span& place) {
  const bool was_within = work_ <= kMaxWork;
  work_ += std::min(work, kMaxWork);
  if (work_ <= kMaxWork) return !build_.stopped();
  if (was_within) {
    build_.diagnostics.report(DiagnosticId::scene_limit, place,
                              "this file expands to more nodes than plugc takes; the rest of it is left out");
  }
  return false;
}

bool Vrml1Scene::enter(const Span& place) {
  if (depth_ >= kMaxNesting) {
    build_.too_deep(place);
    return false;
  }
  ++depth_;
  return true;
}

// What holds where

Vrml1Scene::Gathering Vrml1Scene::gather(std::span<const Vrml1Child> children, const Vrml1State& state) {
  Gathering all;
  all.states.push_back(state);
  gather_all(children, all);
  return all;
}

void Vrml1Scene::gather_all(std::span<const Vrml1Child> children, Gathering& all) {
  if (children.empty() || !enter(children[0].place)) return;
  for (const Vrml1Child& child : children) {
    if (!spend(kVisitWork, child.place)) break;
    gather_one(child, all);
  }
  --depth_;
}

void Vrml1Scene::gather_one(const Vrml1Child& child, Gathering& all) {
  const Vrml1Node& node = tree_.nodes[child.node];
  const std::uint32_t placement = all.placement;
  switch (node.info->kind) {
    case Vrml1Kind::property: return set_property(child.node, all);
    case Vrml1Kind::transform: return move(child.node, all);
    case Vrml1Kind::group: return gather_all(tree_.of(node.children), all);
    case Vrml1Kind::switch_group: return gather_chosen(child.node, all);
    case Vrml1Kind::transform_separator:
      gather_all(tree_.of(node.children), all);
      all.placement = placement;
      return;
    case Vrml1Kind::information: return;
    default: all.items.push_back({child, static_cast<std::uint32_t>(all.states.size() - 1), placement});
  }
}

void Vrml1Scene::set_property(std::uint32_t node, Gathering& all) {
  const bool is_needed = !all.items.empty() && all.items.back().state + 1 == all.states.size();
  if (is_needed) all.states.push_back(Vrml1State(all.states.back()));
  const Vrml1Slot slot = tree_.nodes[node].info->slot;
  std::uint32_t& holds = all.states.back().nodes[static_cast<std::size_t>(slot)];
  holds = slot == Vrml1Slot::texture_transform ? moved_texture(holds, node) : node;
}

void Vrml1Scene::gather_chosen(std::uint32_t node, Gathering& all) {
  constexpr double kAll = -3;
  const auto children = tree_.of(tree_.nodes[node].children);
  const double chosen = number(node, "whichChild", -1);
  if (chosen == kAll) return gather_all(children, all);
  if (chosen >= 0 && chosen < static_cast<double>(children.size()))
    gather_all(children.subspan(static_cast<std::size_t>(chosen), 1), all);
}

void Vrml1Scene::move(std::uint32_t transform, Gathering& all) const {
  const Placement& before = all.placements[all.placement];
  Placement moved;
  moved.is_identity = false;
  moved.matrix = before.matrix * matrix_of(transform);
  moved.only = before.is_identity ? transform : kNoVrml1Node;
  all.placement = static_cast<std::uint32_t>(all.placements.size());
  all.placements.push_back(moved);
}

/// Of a Transform, Translation, Rotation, Scale or MatrixTransform, whose fields have the same names.
glm::dmat4 Vrml1Scene::matrix_of(std::uint32_t node) const {
  const auto matrix = numbers(node, "matrix");
  if (!matrix.empty()) return glm::make_mat4(matrix.data());
  return transform_matrix(vector(node, "translation", glm::dvec3(0)), rotation(node, "rotation"),
                          vector(node, "scaleFactor", glm::dvec3(1)), rotation(node, "scaleOrientation"),
                          vector(node, "center", glm::dvec3(0)));
}

// What is written

/// Whether one more group may be opened, for a light and what stands behind it. Deeper inside, nodes shall still find room.
bool Vrml1Scene::opens_group(const Span& light) {
  if (depth_ < kMaxLightNesting) return true;
  if (std::exchange(lights_are_mixed_, true)) return false;
  build_.diagnostics.report(
      DiagnosticId::nesting_limit, light,
      fmt::format("this light needs a group more than {} deep; like those behind it, it lights some shapes before it, too",
                  kMaxLightNesting));
  return false;
}

/// A light shines on what stands behind it: with what does, it goes into a group where something stands in front of it.
void Vrml1Scene::write_items(const Gathering& all, Items items) {
  std::size_t done = 0;
  bool lights_may_stand = true;  // and shine on the whole group
  const auto is_light = [&](const Item& item) { return tree_.nodes[item.child.node].info->kind == Vrml1Kind::light; };
  while (done < items.size()) {
    const Item& first = items[done];
    if (is_light(first) && !lights_may_stand && opens_group(place_of(first.child.node))) {
      return group({}, {}, place_of(first.child.node), [&] { write_items(all, items.subspan(done)); });
    }
    if (is_light(first)) {
      light(first.child.node, all.placements[first.placement]);
      ++done;
      continue;
    }
    lights_may_stand = false;
    const auto run = items.subspan(done);
    const auto end =
        std::ranges::find_if(run, [&](const Item& item) { return is_light(item) || item.placement != first.placement; });
    const auto length = static_cast<std::size_t>(end - run.begin());
    write_run(all, run.first(length));
    done += length;
  }
}

/// Items of one placement.
void Vrml1Scene::write_run(const Gathering& all, Items run) {
  const auto write_all = [&] {
    for (const Item& item : run) write_item(item.child, all.states[item.state]);
  };
  const Placement& placement = all.placements[run[0].placement];
  if (placement.is_identity) return write_all();
  group(placement, {}, place_of(run[0].child.node), write_all);
}

void Vrml1Scene::write_item(const Vrml1Child& child, const Vrml1State& state) {
  const Vrml1Node& node = tree_.nodes[child.node];
  if (node.is_used) {
    const auto known = written_.find({child.node, state});
    if (known != written_.end()) return write_.use(known->second, child.place);
  }
  const std::size_t before = build_.nodes.open();
  const Name def = node.def.empty() ? Name() : write_.define(node.def.text, "", node.def.span);
  switch (node.info->kind) {
    case Vrml1Kind::shape: shape(child.node, state, def); break;
    case Vrml1Kind::camera: camera(child.node, def); break;
    case Vrml1Kind::lod: lod(child.node, state, def); break;
    case Vrml1Kind::anchor: anchor(child.node, state, def); break;
    case Vrml1Kind::separator: separator(child.node, state, def); break;
    default: plain_node(child.node, def);
  }
  if (node.is_used && build_.nodes.open() > before) written_[{child.node, state}] = def;
}

std::string_view Vrml1Scene::group_type(const Placement& placement) const {
  if (placement.is_identity) return "Group";
  const bool is_matrix = placement.only == kNoVrml1Node || find(placement.only, "matrix") != nullptr;
  return is_matrix ? "MatrixTransform" : "Transform";
}

void Vrml1Scene::place_group(const Placement& placement, const Span& place) {
  const std::string_view type = group_type(placement);
  if (type == "Transform") {
    pass(placement.only, {"translation", "rotation", "scaleOrientation", "center"});
    pass(placement.only, "scaleFactor", "scale");
  } else if (type == "MatrixTransform") {
    write_.numbers("matrix", std::span(glm::value_ptr(placement.matrix), 16), place);
  }
}

/// One whose items all stand in one place is the node that puts them there.
void Vrml1Scene::separator(std::uint32_t node, const Vrml1State& state, const Name& def) {
  Gathering all = gather(tree_.of(tree_.nodes[node].children), state);
  if (all.items.empty() && def.empty()) return;
  Placement placement;
  const auto stands_elsewhere = [&](const Item& item) { return item.placement != all.items[0].placement; };
  if (!all.items.empty() && std::ranges::none_of(all.items, stands_elsewhere)) {
    std::swap(placement, all.placements[all.items[0].placement]);
  }
  group(placement, def, place_of(node), [&] { write_items(all, all.items); });
}

void Vrml1Scene::anchor(std::uint32_t node, const Vrml1State& state, const Name& def) {
  const Gathering all = gather(tree_.of(tree_.nodes[node].children), state);
  if (!enter(place_of(node))) return;
  write_.node("Anchor", def, place_of(node), [&] {
    pass(node, "name", "url");
    pass(node, {"description"});
    write_.nodes("children", place_of(node), [&] { write_items(all, all.items); });
  });
  --depth_;
}

/// Each child is a level, and so one node, also where it draws nothing.
void Vrml1Scene::lod(std::uint32_t node, const Vrml1State& state, const Name& def) {
  write_.node("LOD", def, place_of(node), [&] {
    pass(node, {"center", "range"});
    write_.nodes("children", place_of(node), [&] {
      for (const Vrml1Child& child : tree_.of(tree_.nodes[node].children)) {
        const Gathering level = gather({&child, 1}, state);
        group({}, {}, place_of(child.node), [&] { write_items(level, level.items); });
      }
    });
  });
}

/// A node that X3D has as well. An Inline without a name does nothing.
void Vrml1Scene::plain_node(std::uint32_t node, const Name& def) {
  const Vrml1NodeInfo& info = *tree_.nodes[node].info;
  const bool inlines = info.kind == Vrml1Kind::inlined;
  if (inlines && word(node, "name").empty()) return;
  write_.node(inlines ? "Inline" : info.name, def, place_of(node), [&] {
    if (inlines) return pass(node, "name", "url");
    for (const Vrml1FieldInfo& field : info.fields) pass(node, {field.name});
  });
}

}  // namespace plugc

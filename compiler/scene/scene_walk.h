#pragma once
// The walk over the tree, from its roots. Each group first looks at its own children for what acts on their siblings too
// (effects, lights that are not global, clip planes), then visits them; global lights are handed to every shape at the end. The
// walk follows each USE anew, since a shape under two parents is two shapes; limits stop what grows without bound.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/scene_context.h"

namespace plugc {

/// A shape without a LocalFog above it is in the fog of the scene, which is known when all is visited.
inline constexpr int kBoundFog = -2;

/// How the walk treats a node.
enum class Role : std::uint8_t {
  other,
  shape,
  switch_,
  lod,
  transform,
  billboard,
  group,
  inlined,
  effect,
  light,
  local_fog,
  clip_plane,
  matrix_transform
};

/// What the walk must know of a type.
struct TypeUse {
  Role role = Role::other;
  bool has_visible = false;
};

enum class Visibility : std::uint8_t { shown, hidden, changing };

/// Fills the context's scene.
class SceneWalk {
 public:
  explicit SceneWalk(SceneContext& context) : context_(context), graph_(context.graph) {}

  void run();

 private:
  // Node by node (scene_walk.cpp).
  void visit_list(std::span<const NodeId> nodes);
  void act_on_siblings(NodeId node);
  void check_top(std::span<const NodeId> nodes);
  void visit(NodeId node);
  void visit_shape(NodeId node);
  void visit_other(NodeId node);
  void visit_viewpoint(NodeId node);
  void bind_if_first(NodeId node);
  bool within_limits(NodeId node);
  void report_limit(NodeId node, std::uint32_t limit, std::string_view of);
  Role role(NodeId node) { return use_of(node).role; }
  const TypeUse& use_of(NodeId node);
  Visibility visibility(NodeId node);

  // Groups (walk_groups.cpp).
  int add_transform(const SceneTransform& transform);
  void visit_below(const SceneTransform& transform, std::span<const NodeId> nodes);
  void visit_transform(NodeId node);
  void visit_billboard(NodeId node);
  void visit_switch(NodeId node);
  void visit_lod(NodeId node);
  void visit_inline(NodeId node);
  SceneTransform condition(NodeId node, std::string_view field, int value);

  // What is known at the end (build_scene.cpp).
  void finish_bindings();
  void add_background();
  void add_changing_background();
  bool add_backdrop_within_limits(const BoundBackground& background);
  const BindStack& stack(BindKind kind) const { return context_.stacks[static_cast<std::size_t>(kind)]; }
  void finish_shapes(std::size_t first);
  void visit_own_scene(int texture);
  void add_own_background(int texture);
  void visit_own_scenes();
  void add_unreached_effects();

  SceneContext& context_;
  const NodeGraph& graph_;
  NodeId navigation_info_;
  NodeId background_;
  int background_transform_ = -1;
  std::optional<int> bound_fog_;
  std::vector<int> global_lights_;
  std::vector<NodeId> appearances_;  // per shape; not valid where it has none
  int own_scene_of_ = -1;            // the rendered texture whose scene this is; -1: the world

  // What the next shape inherits from the groups above it.
  int transform_ = -1;
  std::vector<int> effects_;  // from the outermost in
  std::vector<int> lights_;   // not global
  int fog_ = kBoundFog;       // the nearest LocalFog; -1: one that lets everything through
  std::vector<int> clip_planes_;

  std::uint32_t hidden_ = 0;  // nodes above that are not visible, for good

  std::unordered_map<const NodeInfo*, TypeUse> uses_;
  std::uint32_t visited_ = 0;
  std::uint32_t depth_ = 0;
  std::uint32_t inlines_ = 0;  // around what is visited
  bool limit_reached_ = false;
};

}  // namespace plugc

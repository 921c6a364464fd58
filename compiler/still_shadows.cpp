// Each pair of a caster and a receiver is tried with their boxes in the light's own space: the caster must overlap the way from
// the receiver to the light, a bar for a directional light, for a spot light the box around receiver and light. A flat caster
// (a ground) only shadows what lies behind it, and a closed convex body not itself: its far side is dark anyway.

#include "still_shadows.h"

#include <algorithm>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "base/placed_box.h"
#include "base/transform_matrix.h"
#include "mesh/live_vertices.h"
#include "shadow_geometry.h"

namespace plugc {
namespace {

constexpr std::size_t kMostConvexTests = 1U << 18;  // triangles times points
constexpr double kTouching = 1e-5;                  // of the size of both boxes: what is closer may shadow

/// A scene's slots and transforms, as far as they are for good.
class StillScene {
 public:
  explicit StillScene(const Scene& scene) : scene_(scene) {
    for (const SceneTransform& transform : scene.transforms) {
      const std::optional<glm::dmat4> parent = at(transform.parent);
      const std::optional<glm::dmat4> own = matrix_of(transform);
      matrices_.push_back(parent && own ? std::optional(*parent * *own) : std::nullopt);
    }
  }

  /// Object to world; none when something above may move.
  std::optional<glm::dmat4> at(int transform) const {
    return transform < 0 ? glm::dmat4(1.0) : matrices_[static_cast<std::size_t>(transform)];
  }
  /// Values of a slot that nothing changes; `fallback` where there is no slot.
  std::optional<glm::dvec4> values(std::uint32_t slot, const glm::dvec4& fallback) const {
    if (slot == kSceneNoSlot) return fallback;
    const Slot& found = scene_.slots[slot];
    if (found.routed) return std::nullopt;
    glm::dvec4 result = fallback;
    for (std::size_t i = 0; i < std::min<std::size_t>(found.values.size(), 4); ++i)
      result[static_cast<int>(i)] = found.values[i];
    return result;
  }

 private:
  std::optional<glm::dmat4> matrix_of(const SceneTransform& transform) const {
    if (transform.billboard_axis != kSceneNoSlot) return std::nullopt;  // it turns with the viewer
    constexpr glm::dvec4 kNoRotation(0, 0, 1, 0);
    const auto translation = values(transform.translation, glm::dvec4(0));
    const auto rotation = values(transform.rotation, kNoRotation);
    const auto scale = values(transform.scale, glm::dvec4(1));
    const auto orientation = values(transform.scale_orientation, kNoRotation);
    const auto center = values(transform.center, glm::dvec4(0));
    if (!translation || !rotation || !scale || !orientation || !center) return std::nullopt;
    return transform_matrix(glm::dvec3(*translation), *rotation, glm::dvec3(*scale), *orientation, glm::dvec3(*center));
  }

  const Scene& scene_;
  std::vector<std::optional<glm::dmat4>> matrices_;
};

/// A shape as light meets it; without a place where it may move.
struct StillShape {
  std::optional<PlacedBox> place;
  bool casts = false;
  bool convex = false;
};

Box bounds_of(const Mesh& mesh) {
  Box box;
  for (const glm::vec3& position : mesh.positions) box = join(box, {glm::dvec3(position), glm::dvec3(position)});
  return box;
}

/// Closed, and without a dent.
bool is_convex(const Mesh& mesh, const Box& bounds) {
  if (!mesh.solid || mesh.topology != Topology::triangles) return false;
  if (mesh.indices.size() / 3 * mesh.positions.size() > kMostConvexTests) return false;
  const double rounding = kTouching * glm::length(bounds.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a) * (mesh.ccw ? 1.0 : -1.0);
    const double length = glm::length(normal);
    const bool flat = std::ranges::all_of(mesh.positions, [&](const glm::vec3& position) {
      return glm::dot(normal, glm::dvec3(position) - a) <= rounding * length;
    });
    if (!flat) return false;
  }
  return true;
}

std::vector<StillShape> find_still_shapes(const std::vector<EffectCode>& effects, const SceneParts& parts,
                                          const StillScene& still) {
  std::vector<StillShape> shapes(parts.shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const SceneShape& shape = parts.scene.shapes[i];
    const Mesh* const mesh = parts.shapes[i].mesh.get();
    if (mesh == nullptr) continue;
    shapes[i].casts = casts_shadow(parts, i);
    const std::optional<glm::dmat4> matrix = still.at(shape.transform);
    if (!matrix || positions_move(*mesh)) continue;
    if (!may_move_vertices(parts.scene, shape, effects)) {
      const Box bounds = bounds_of(*mesh);
      shapes[i].place = PlacedBox{bounds, *matrix};
      shapes[i].convex = is_convex(*mesh, bounds);
    } else if (shape.bounds) {
      shapes[i].place = PlacedBox{*shape.bounds, *matrix, false};
    }
  }
  return shapes;
}

/// A light that never moves. `towards` as front_of() takes it; `to_light` turns the world so that light comes along -z.
struct StillLight {
  glm::dvec4 towards{0};
  glm::dmat4 to_light{1.0};
  double reach = std::numeric_limits<double>::infinity();  ///< How far it shines.
};

std::optional<StillLight> find_still_light(const SceneLight& light, const StillScene& still) {
  const std::optional<glm::dmat4> matrix = still.at(light.transform);
  if (!matrix || light.headlight) return std::nullopt;
  if (light.kind != LightKind::directional) {
    const std::optional<glm::dvec4> place = still.values(light.location, glm::dvec4(0));
    if (!place) return std::nullopt;
    StillLight found{*matrix * glm::dvec4(glm::dvec3(*place), 1)};
    const glm::dmat3 axes(*matrix);
    const double longest = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    const std::optional<glm::dvec4> radius = still.values(light.radius, glm::dvec4(-1));
    if (radius && radius->x >= 0) found.reach = radius->x * longest;
    return found;
  }
  const std::optional<glm::dvec4> written = still.values(light.direction, {0, 0, -1, 0});
  if (!written) return std::nullopt;
  const glm::dvec3 direction = glm::dmat3(*matrix) * glm::dvec3(*written);
  const double length = glm::length(direction);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const glm::dvec3 towards = -direction / length;
  const glm::dvec3 up = std::abs(towards.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return StillLight{{towards, 0}, glm::lookAt(glm::dvec3(0), -towards, up)};
}

/// Whether the caster may stand between the light and the receiver.
bool may_shadow(const PlacedBox& caster, const PlacedBox& receiver, const StillLight& light) {
  const Box from = transformed(caster.box, light.to_light * caster.to_world);
  Box way = transformed(receiver.box, light.to_light * receiver.to_world);
  if (from.empty() || way.empty()) return true;  // no usable numbers: the renderer will see
  const double touching = kTouching * (glm::length(from.size()) + glm::length(way.size()));
  if (const std::optional<glm::dvec4> front = front_of(caster, light.towards)) {
    const auto all = corners(receiver.box);
    const bool before = std::ranges::all_of(all, [&](const glm::dvec3& corner) {
      return glm::dot(*front, receiver.to_world * glm::dvec4(corner, 1)) >= -touching;
    });
    if (before) return false;
  }
  if (light.towards.w == 0) {
    way.max.z = std::max(way.max.z, from.max.z);
  } else {
    way = join(way, {glm::dvec3(light.towards), glm::dvec3(light.towards)});
  }
  return glm::all(glm::lessThanEqual(from.min, way.max + touching)) &&
         glm::all(glm::lessThanEqual(way.min, from.max + touching));
}

double distance_to(const glm::dvec3& point, const Box& box) {
  return glm::distance(point, glm::clamp(point, box.min, box.max));
}

bool may_be_shadowed(const std::vector<StillShape>& shapes, std::size_t receiver, const StillLight& light) {
  if (!shapes[receiver].place) return true;
  const Box reached = transformed(shapes[receiver].place->box, shapes[receiver].place->to_world);
  if (light.towards.w != 0 && !reached.empty() && distance_to(glm::dvec3(light.towards), reached) > light.reach) return false;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!shapes[i].casts || (i == receiver && shapes[i].convex)) continue;
    if (!shapes[i].place || may_shadow(*shapes[i].place, *shapes[receiver].place, light)) return true;
  }
  return false;
}

/// Its shadows leave all light where it is, for good.
bool takes_nothing(const SceneLight& light, const StillScene& still) {
  const std::optional<glm::dvec4> intensity = still.values(light.shadow_intensity, glm::dvec4(1));
  return intensity && intensity->x == 0;
}

}  // namespace

void drop_impossible_shadows(const std::vector<EffectCode>& effects, SceneParts& parts) {
  Scene& scene = parts.scene;
  if (scene.shadow_maps.empty()) return;
  const StillScene still(scene);
  const std::vector<StillShape> shapes = find_still_shapes(effects, parts, still);
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    std::erase_if(scene.shapes[i].receives, [&](const ReceivedShadow& shadow) {
      const SceneLight& light = scene.lights[static_cast<std::size_t>(shadow.light)];
      if (takes_nothing(light, still)) return true;
      if (shadow.compare != DepthCompare::less_equal) return false;  // it darkens where nothing casts
      const std::optional<StillLight> found = find_still_light(light, still);
      return found && !may_be_shadowed(shapes, i, *found);
    });
  }
}

bool needs_casters(const Scene& scene) {
  const auto shows_light = [&scene](const SceneShape& shape) {
    if (shape.shader >= 0) return true;
    return shape.material >= 0 && scene.materials[static_cast<std::size_t>(shape.material)].lighting != Lighting::unlit;
  };
  return std::ranges::any_of(scene.shadow_maps, &SceneShadowMap::author_visible) ||
         std::ranges::any_of(scene.shapes,
                             [&](const SceneShape& shape) { return !shape.receives.empty() && shows_light(shape); });
}

}  // namespace plugc

// One walk over the transforms (parents come first) gives matrices and visibility, one over the shapes their boxes.
// All of it in double, so that a scene far from its origin loses nothing until matrices relative to the eye become floats.
// NaN and infinity in a slot make the boxes below it empty; they never reach a fit.

#include "runtime/world.h"

#include <cmath>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

namespace plugc {
namespace {

const glm::dvec4 kNoRotation(0, 0, 1, 0);

PlacedTransform place_transform(const PackedTransform& packed, const PlacedTransform& parent, const Slots& slots) {
  PlacedTransform placed;
  placed.visible = parent.visible && (packed.switch_slot() == kNoSlot ||
                                      slots.number(packed.switch_slot(), -1.0) == static_cast<double>(packed.choice()));
  placed.matrix = parent.matrix * transform_matrix(slots.vector3(packed.translation(), glm::dvec3(0)),
                                                   slots.vector4(packed.rotation(), kNoRotation),
                                                   slots.vector3(packed.scale(), glm::dvec3(1)),
                                                   slots.vector4(packed.scale_orientation(), kNoRotation),
                                                   slots.vector3(packed.center(), glm::dvec3(0)));
  return placed;
}

/// Local +y as the viewer's up, and +z as near as that allows to what is behind the viewer (X3D 4.1, 23.4.1: viewer alignment),
/// so that what is flat lies parallel to the picture. Under a scale that is not the same along all axes the shape is sheared.
glm::dmat4 viewer_alignment(const glm::dmat3& to_local, const Viewer& viewer) {
  const glm::dvec3 up = to_local * viewer.up;
  const glm::dvec3 right = glm::cross(up, to_local * viewer.back);
  const bool usable = glm::length(up) > 0 && glm::length(right) > 0 && std::isfinite(glm::length(up) + glm::length(right));
  if (!usable) return glm::dmat4(1.0);
  const glm::dvec3 x = glm::normalize(right), y = glm::normalize(up);
  return glm::dmat4(glm::dmat3(x, y, glm::cross(x, y)));
}

/// About `axis` until local +z points to the eye, as far as that goes. Nothing where the eye stands on the axis.
glm::dmat4 billboard_turn(const glm::dvec3& axis, const glm::dmat4& to_world, const Viewer& viewer) {
  const glm::dmat4 to_local = glm::inverse(to_world);
  if (axis == glm::dvec3(0)) return viewer_alignment(glm::dmat3(to_local), viewer);
  const glm::dvec3 eye(to_local * glm::dvec4(viewer.eye, 1));
  const double distance = glm::length(eye);
  if (!(distance > 0) || !std::isfinite(distance)) return glm::dmat4(1.0);
  const glm::dvec3 about = glm::normalize(axis);
  const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, about) * about; };
  const glm::dvec3 from = across({0, 0, 1}), to = across(eye / distance);
  constexpr double kParallel = 1e-9;
  if (!(glm::length(from) > kParallel && glm::length(to) > kParallel)) return glm::dmat4(1.0);
  return rotation_matrix(glm::dvec4(about, std::atan2(glm::dot(about, glm::cross(from, to)), glm::dot(from, to))));
}

bool is_on(const PackedSwitch& one, const PackedScene& scene, const Slots& slots, const World& world) {
  if (one.kind() == PackedSwitchKind::slot) return slots.boolean(one.index(), true);
  return light_shines(*scene.lights()->Get(one.index()), slots, world);
}

/// What is no part of a backdrop, or of the one that is bound.
bool is_bound(const PackedShape& shape, const PackedScene& scene, const Slots& slots) {
  return shape.background() < 0 || slots.number(scene.bound_background(), -1) == static_cast<double>(shape.background());
}

/// Neither its ambient nor its direct term adds anything.
bool is_black(const PackedLight& light, const Slots& slots) {
  if (slots.vector3(light.color(), glm::dvec3(1)) == glm::dvec3(0)) return true;
  return slots.number(light.intensity(), 1) == 0 && slots.number(light.ambient_intensity(), 0) == 0;
}

std::uint8_t current_variant(const PackedShape& shape, const PackedScene& scene, const Slots& slots, const World& world) {
  std::uint32_t state = 0;
  const std::uint32_t count = shape.switches()->size();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_on(*shape.switches()->Get(i), scene, slots, world)) state |= 1U << i;
  }
  return count == 0 ? 0 : shape.states()->Get(state);
}

/// Without a viewer, or where there is no distance, the nearest level is.
bool is_shown(const PackedLodLevel& level, const glm::dmat4& to_world, const Slots& slots, const Viewer* viewer) {
  double distance = 0;
  if (viewer != nullptr) {
    const glm::dvec3 eye(glm::inverse(to_world) * glm::dvec4(viewer->eye, 1));
    distance = glm::length(eye - slots.vector3(level.center(), glm::dvec3(0)));
    if (!std::isfinite(distance)) distance = 0;
  }
  return distance >= level.from() && distance < level.to();
}

/// The few transforms that have more than a PackedTransform says, by index.
struct SpecialTransforms {
  std::map<std::uint32_t, std::uint32_t> billboard_axes;
  std::map<std::uint32_t, const PackedLodLevel*> lod_levels;
};

SpecialTransforms find_special(const PackedScene& scene) {
  SpecialTransforms special;
  if (scene.billboards() != nullptr)
    for (const PackedBillboard* billboard : *scene.billboards())
      special.billboard_axes[billboard->transform()] = billboard->axis();
  if (scene.lod_levels() != nullptr)
    for (const PackedLodLevel* level : *scene.lod_levels()) special.lod_levels[level->transform()] = level;
  return special;
}

/// What stands above `placed` is placed.
void follow_viewer(const SpecialTransforms& special, std::uint32_t index, const Slots& slots, const Viewer* viewer,
                   PlacedTransform& placed) {
  if (const auto level = special.lod_levels.find(index); level != special.lod_levels.end())
    placed.visible = placed.visible && is_shown(*level->second, placed.matrix, slots, viewer);
  if (viewer == nullptr) return;
  if (const auto axis = special.billboard_axes.find(index); axis != special.billboard_axes.end())
    placed.matrix = placed.matrix * billboard_turn(slots.vector3(axis->second, {0, 1, 0}), placed.matrix, *viewer);
}

}  // namespace

bool light_shines(const PackedLight& light, const Slots& slots, const World& world) {
  return world.at(light.transform()).visible && slots.boolean(light.on(), true);
}

glm::dvec3 light_direction(const PackedLight& light, const glm::dmat4& to_world, const Slots& slots) {
  const glm::dvec3 direction = glm::dmat3(to_world) * slots.vector3(light.direction(), {0, 0, -1});
  return -glm::dvec3(look_along(glm::dvec3(0), direction, {0, 1, 0}).eye_to_world[2]);
}

double shadow_intensity(std::uint32_t slot, const Slots& slots) {
  const double written = slots.number(slot, 1);
  return written >= 0 ? std::min(written, 1.0) : 0;  // not a number: none
}

bool shadow_shows(const PackedShadowMap& map, const PackedScene& scene, const Slots& slots, const World& world) {
  const PackedLight& light = *scene.lights()->Get(map.light());
  if (!light_shines(light, slots, world) || shadow_intensity(light.shadow_intensity(), slots) == 0) return false;
  return map.other_light() || !is_black(light, slots);
}

const PlacedTransform& World::at(std::int32_t transform) const {
  return transform < 0 ? root_ : transforms[static_cast<std::size_t>(transform)];
}

World place(const Package& package, const PackedScene& scene, const Slots& slots, const Viewer* viewer,
            std::int32_t own_scene_of, const LiveMeshes* live) {
  World world;
  world.transforms.reserve(scene.transforms()->size());
  const SpecialTransforms special = find_special(scene);
  for (const PackedTransform* packed : *scene.transforms()) {
    const auto index = static_cast<std::uint32_t>(world.transforms.size());
    world.transforms.push_back(place_transform(*packed, world.at(packed->parent()), slots));
    follow_viewer(special, index, slots, viewer, world.transforms.back());
  }
  for (const PackedShape* shape : *scene.shapes()) {
    const PlacedTransform& placed = world.at(shape->transform());
    const bool in_world = shape->layer() == PackedLayer::world;
    const bool chosen = placed.visible || !in_world;  // what is bound shows wherever it stands
    const bool visible = chosen && is_bound(*shape, scene, slots) && shape->own_scene_of() == own_scene_of;
    const bool has_place = visible && in_world;
    const Box own = has_place ? object_bounds(package, *shape, live == nullptr ? nullptr : live->find(shape->mesh())) : Box{};
    world.object_bounds.push_back(own);
    world.shape_visible.push_back(visible);
    world.shape_variant.push_back(current_variant(*shape, scene, slots, world));
    world.shape_bounds.push_back(transformed(own, placed.matrix));
    world.bounds = join(world.bounds, world.shape_bounds.back());
  }
  return world;
}

bool depends_on_viewer(const PackedScene& scene) {
  const bool turns = scene.billboards() != nullptr && scene.billboards()->size() != 0;
  const bool chooses = scene.lod_levels() != nullptr && scene.lod_levels()->size() != 0;
  return turns || chooses;
}

Box object_bounds(const Package& package, const PackedShape& shape, const LiveMesh* live) {
  const PackedMesh& mesh = *package.meshes()->Get(shape.mesh());
  const bool written = shape.bounds_min() != nullptr && shape.bounds_max() != nullptr;
  if (!written && live != nullptr) return live->bounds;
  const PackedVec3& low = written ? *shape.bounds_min() : *mesh.bounds_min();
  const PackedVec3& high = written ? *shape.bounds_max() : *mesh.bounds_max();
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

double average_scale(const glm::dmat4& matrix) {
  return (glm::length(glm::dvec3(matrix[0])) + glm::length(glm::dvec3(matrix[1])) + glm::length(glm::dvec3(matrix[2]))) / 3.0;
}

bool outside_sideways(const Box& box, const glm::dmat4& to_clip) {
  if (box.empty()) return false;
  int outside = 0b1111;
  for (const glm::dvec3& corner : corners(box)) {
    const glm::dvec4 clip = to_clip * glm::dvec4(corner, 1.0);
    outside &= (clip.x > clip.w ? 1 : 0) | (clip.x < -clip.w ? 2 : 0) | (clip.y > clip.w ? 4 : 0) | (clip.y < -clip.w ? 8 : 0);
  }
  return outside != 0;
}

}  // namespace plugc

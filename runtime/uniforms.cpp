// One case a source. Matrices are multiplied in double and become floats at the very end, relative to the eye, so that a
// scene a million units from its origin keeps its place in the picture. Each source gives as many numbers as it has; the
// uniform's type then takes what it needs.

#include "runtime/uniforms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/gl/program.h"
#include "runtime/mirror.h"
#include "runtime/projection.h"

namespace plugc {
namespace {

using Numbers = std::vector<double>;

Numbers numbers(const glm::dvec4& v) {
  return {v.x, v.y, v.z, v.w};
}
Numbers numbers(const glm::dmat3& m) {
  return {&m[0][0], &m[0][0] + 9};
}
Numbers numbers(const glm::dmat4& m) {
  return {&m[0][0], &m[0][0] + 16};
}

/// A light in the space of the eye. Defaults: X3D 4.1, 17.4.
struct EyeLight {
  const PackedLight& light;
  const Slots& slots;
  glm::dmat4 to_eye;
  glm::dvec3 travel;  ///< Its direction; unit.
  bool shines;
};

EyeLight eye_light(std::uint32_t index, const UniformInputs& inputs) {
  const PackedLight& light = *inputs.scene.lights()->Get(index);
  const bool on_eye = light.headlight() && inputs.wearer == nullptr;  // eye space is its world, then
  const glm::dmat4 world_to_eye = on_eye ? glm::dmat4(1.0) : inputs.view.world_to_eye;
  const glm::dmat4 to_world = on_eye              ? glm::dmat4(1.0)
                              : light.headlight() ? inputs.wearer->eye_to_world
                                                  : inputs.world.at(light.transform()).matrix;
  return {light, inputs.slots, world_to_eye * to_world,
          glm::dmat3(world_to_eye) * light_direction(light, to_world, inputs.slots),
          light_shines(light, inputs.slots, inputs.world)};
}

/// Homogeneous: w is 0 for a directional light, whose position is the direction towards it.
glm::dvec4 position(const EyeLight& l) {
  if (l.light.kind() == PackedLightKind::directional) return {-l.travel, 0.0};
  return l.to_eye * glm::dvec4(l.slots.vector3(l.light.location(), glm::dvec3(0)), 1.0);
}

glm::dvec4 color(const EyeLight& l, double strength) {
  return {l.shines ? l.slots.vector3(l.light.color(), glm::dvec3(1)) * strength : glm::dvec3(0), 1.0};
}

double cut_off_angle(const EyeLight& l) {
  return l.slots.number(l.light.cut_off_angle(), std::numbers::pi / 2);
}

Numbers light_numbers(const PackedBinding& binding, const UniformInputs& inputs) {
  const EyeLight l = eye_light(binding.a(), inputs);
  switch (binding.source()) {
    case PackedSource::light_position: return numbers(position(l));
    case PackedSource::light_spot_direction: return numbers(glm::dvec4(l.travel, 0.0));
    case PackedSource::light_spot_cos_cutoff: return {std::cos(cut_off_angle(l))};
    case PackedSource::light_on: return {l.shines ? 1.0 : 0.0};
    case PackedSource::light_spot_cutoff: return {cut_off_angle(l)};
    case PackedSource::light_beam_width: return {l.slots.number(l.light.beam_width(), std::numbers::pi / 4)};
    case PackedSource::light_radius: return {l.slots.number(l.light.radius(), 100) * average_scale(l.to_eye)};
    case PackedSource::light_color: return numbers(color(l, l.slots.number(l.light.intensity(), 1)));
    case PackedSource::light_ambient_color: return numbers(color(l, l.slots.number(l.light.ambient_intensity(), 0)));
    case PackedSource::light_attenuation: return numbers(glm::dvec4(l.slots.vector3(l.light.attenuation(), {1, 0, 0}), 0));
    default: return {};
  }
}

/// What a uniform takes.
struct Wanted {
  std::size_t size = 0, count = 0;  ///< Numbers of an element, elements.
};

/// Element by element: a slot of vec3 elements fills an array of vec3, whatever either side's count.
Numbers slot_numbers(std::uint32_t slot, double scale, const Wanted& wanted, const Slots& slots) {
  const std::span<const double> values = slots.values(slot);
  const std::size_t size = slots.element_size(slot);
  Numbers result;
  if (size == 0) return result;
  for (std::size_t first = 0; first + size <= values.size() && first / size < wanted.count; first += size) {
    for (std::size_t i = 0; i < wanted.size; ++i) result.push_back(i < size ? values[first + i] * scale : 0.0);
  }
  return result;
}

/// An angle around z, or an axis with its angle.
glm::dmat4 texture_rotation(std::uint32_t slot, const Slots& slots) {
  if (slots.element_size(slot) == 4) return rotation_matrix(slots.vector4(slot, {0, 0, 1, 0}));
  return glm::rotate(glm::dmat4(1.0), slots.number(slot, 0), glm::dvec3(0, 0, 1));
}

glm::dmat4 texture_matrix(const PackedTextureTransform& packed, const Slots& slots) {
  const auto vector = [&slots](std::uint32_t slot, double z) {
    glm::dvec3 found = slots.vector3(slot, glm::dvec3(z));
    if (slots.element_size(slot) < 3) found.z = z;
    return found;
  };
  const glm::dmat4 one(1.0);
  const glm::dvec3 center = vector(packed.center(), 0);
  return glm::translate(one, -center) * glm::scale(one, vector(packed.scale(), 1)) *
         texture_rotation(packed.rotation(), slots) * glm::translate(one, center) *
         glm::translate(one, vector(packed.translation(), 0));
}

glm::dmat4 rotation_part(const glm::dmat4& matrix) {
  return glm::dmat4(glm::dmat3(matrix));
}

/// The map a binding speaks of: in a depth pass the one being drawn (one list of bindings serves all maps of a shape).
const View& shadow_view(const PackedBinding& binding, const UniformInputs& inputs) {
  return inputs.depth_pass_view != nullptr ? *inputs.depth_pass_view : inputs.shadow_views[binding.a()];
}

/// What a viewpoint projects: bound, the picture itself; else its fieldOfView both ways, or its rectangle.
View projecting_view(const PackedBinding& binding, const UniformInputs& inputs) {
  if (binding.b() != 0 && static_cast<std::int32_t>(binding.b()) - 1 == inputs.bound_viewpoint) return inputs.view;
  const PackedViewpoint& projector = *inputs.scene.projectors()->Get(binding.a());
  double aspect = 1;
  if (projector.orthographic()) {
    const glm::dvec4 field = inputs.slots.vector4(projector.field_of_view(), {-1, -1, 1, 1});  // left bottom right top
    const double shape = (field.z - field.x) / (field.w - field.y);
    if (std::isnormal(shape) && shape > 0) aspect = shape;
  }
  return view_from(projector, inputs.slots, inputs.world, aspect);
}

/// Where what the picture's viewer sees in the shape lies in a picture that just covers it; without a mirror, where the shape
/// lies in the picture itself.
glm::dmat4 mirror_projector(const UniformInputs& inputs) {
  if (inputs.mirror == nullptr) return world_to_texture(inputs.view);
  const View& viewer = inputs.wearer == nullptr ? inputs.view : *inputs.wearer;
  const auto seen = view_in_mirror(place_mirror(*inputs.mirror, inputs.object_to_world), viewer, 0, Box());
  return seen ? world_to_texture(*seen) : glm::dmat4(1.0);
}

Numbers matrix_numbers(const PackedBinding& binding, const UniformInputs& inputs) {
  const View& view = inputs.view;
  const glm::dmat4 model_view = view.world_to_eye * inputs.object_to_world;
  switch (binding.source()) {
    case PackedSource::model_view_matrix: return numbers(model_view);
    case PackedSource::projection_matrix: return numbers(view.projection);
    case PackedSource::model_view_projection_matrix: return numbers(view.projection * model_view);
    case PackedSource::normal_matrix: return numbers(normal_matrix(model_view));
    case PackedSource::texture_matrix:
      return numbers(texture_matrix(*inputs.scene.texture_transforms()->Get(binding.a()), inputs.slots));
    case PackedSource::projector_matrix:
    case PackedSource::mirror_projector_matrix:
    case PackedSource::viewpoint_projector_matrix: return numbers(projector_matrix(binding, inputs) * view.eye_to_world);
    case PackedSource::camera_matrix: return numbers(view.world_to_eye);
    case PackedSource::camera_inverse_matrix: return numbers(view.eye_to_world);
    case PackedSource::camera_rotation_matrix: return numbers(rotation_part(view.world_to_eye));
    case PackedSource::camera_rotation_inverse_matrix: return numbers(rotation_part(view.eye_to_world));
    case PackedSource::light_view_projection_matrix: {
      const View& light = shadow_view(binding, inputs);
      return numbers(light.projection * light.world_to_eye);
    }
    default: return {};
  }
}

/// In eye space units. A range of 0 means that there is no fog (X3D 4.1, 24.4.2): what is seen lies far in front of it.
double visibility_range(const PackedBinding& binding, const UniformInputs& inputs) {
  constexpr double kVeryFar = 1e30;
  const double range = inputs.slots.number(binding.a(), 0);
  if (!(range > 0)) return kVeryFar;
  const int transform = static_cast<int>(binding.b()) - 1;
  return range * average_scale(inputs.world.at(transform).matrix);
}

/// A plane is a row that points are multiplied with, so it goes the other way than they do.
glm::dvec4 eye_clip_plane(const PackedClipPlane& plane, const UniformInputs& inputs) {
  const glm::dvec4 nothing_cut(0, 0, 0, 1);
  if (inputs.slots.number(plane.enabled(), 1) == 0) return nothing_cut;
  const glm::dmat4 to_eye = inputs.view.world_to_eye * inputs.world.at(plane.transform()).matrix;
  return inputs.slots.vector4(plane.plane(), nothing_cut) * glm::inverse(to_eye);
}

/// In eye space units, as the visibility range; a direction without length is the default's.
glm::dvec4 eye_fog_plane(const PackedFogPlane& plane, const UniformInputs& inputs) {
  const glm::dmat4& to_world = inputs.world.at(plane.transform()).matrix;
  const glm::dvec3 written = inputs.slots.vector3(plane.direction(), {0, -1, 0});
  const double length = glm::length(written);
  const glm::dvec3 direction = length > 0 ? written / length : glm::dvec3(0, -1, 0);
  const glm::dvec4 depth(direction, -inputs.slots.number(plane.start(), 0));
  return average_scale(to_world) * (depth * glm::inverse(inputs.view.world_to_eye * to_world));
}

Numbers source_numbers(const PackedBinding& binding, const Wanted& wanted, const UniformInputs& inputs) {
  switch (binding.source()) {
    case PackedSource::slot: return slot_numbers(binding.a(), 1.0, wanted, inputs.slots);
    case PackedSource::shadow_intensity: return {shadow_intensity(binding.a(), inputs.slots)};
    case PackedSource::slot_scaled:
      return slot_numbers(binding.a(), static_cast<double>(binding.scale()), wanted, inputs.slots);
    case PackedSource::slot_product:
      return slot_numbers(binding.a(), inputs.slots.number(binding.b(), 1), wanted, inputs.slots);
    case PackedSource::color_and_transparency:
      return numbers(glm::dvec4(inputs.slots.vector3(binding.a(), glm::dvec3(1)), 1.0 - inputs.slots.number(binding.b(), 0)));
    case PackedSource::depth_pass_range: return numbers(inputs.depth_range);
    case PackedSource::screen_width: return {inputs.target_size.x};
    case PackedSource::screen_height: return {inputs.target_size.y};
    case PackedSource::fog_visibility_range: return {visibility_range(binding, inputs)};
    case PackedSource::clip_plane: return numbers(eye_clip_plane(*inputs.scene.clip_planes()->Get(binding.a()), inputs));
    case PackedSource::fog_plane: return numbers(eye_fog_plane(*inputs.scene.fog_planes()->Get(binding.a()), inputs));
    case PackedSource::target_size: return {inputs.target_size.x, inputs.target_size.y};
    case PackedSource::color_and_alpha:
      return numbers(glm::dvec4(inputs.slots.vector3(binding.a(), glm::dvec3(1)), inputs.slots.number(binding.b(), 1)));
    case PackedSource::light_position:
    case PackedSource::light_spot_direction:
    case PackedSource::light_spot_cos_cutoff:
    case PackedSource::light_spot_cutoff:
    case PackedSource::light_beam_width:
    case PackedSource::light_radius:
    case PackedSource::light_color:
    case PackedSource::light_ambient_color:
    case PackedSource::light_attenuation:
    case PackedSource::light_on: return light_numbers(binding, inputs);
    case PackedSource::shadow_depth_plane:
      return numbers(linear_depth_plane(shadow_view(binding, inputs)) * inputs.view.eye_to_world);
    case PackedSource::shadow_depth_line: return numbers(linear_depth_line(shadow_view(binding, inputs)));
    default: return matrix_numbers(binding, inputs);
  }
}

/// 4x4 to 3x3 where a shader wants the rotation only.
Numbers upper_left(const Numbers& m) {
  return {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
}

}  // namespace

float finite_float(double value) {
  constexpr double largest = static_cast<double>(std::numeric_limits<float>::max());
  return std::isnan(value) ? 0.0F : static_cast<float>(std::clamp(value, -largest, largest));
}

glm::dmat4 projector_matrix(const PackedBinding& binding, const UniformInputs& inputs) {
  if (binding.source() == PackedSource::mirror_projector_matrix) return mirror_projector(inputs);
  const bool of_light = binding.source() == PackedSource::projector_matrix;
  return world_to_texture(of_light ? shadow_view(binding, inputs) : projecting_view(binding, inputs));
}

glm::dmat3 normal_matrix(const glm::dmat4& model_view) {
  const glm::dmat3 m(model_view);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const double determinant = glm::dot(m[0], cofactors[0]);
  const bool regular = std::isnormal(determinant) && std::isfinite(1 / determinant);
  return regular ? cofactors / determinant : cofactors;
}

std::vector<float> evaluate(const PackedBinding& binding, PackedUniformType type, std::uint32_t count,
                            const UniformInputs& inputs) {
  if (gl::is_sampler(type)) return {};
  const std::size_t size = component_count(type);
  Numbers values = source_numbers(binding, {size, count}, inputs);
  if (type == PackedUniformType::mat3 && values.size() == 16) values = upper_left(values);
  std::vector<float> result(size * count, 0.0F);
  for (std::size_t i = 0; i < std::min(values.size(), result.size()); ++i) result[i] = finite_float(values[i]);
  return result;
}

}  // namespace plugc

#pragma once
// What the numbers of a binding are for one draw.

#include <span>
#include <vector>

#include "runtime/events.h"
#include "runtime/world.h"

namespace plugc {

/// Everything a binding may ask for. `view` is the eye of the pass: the camera, or the light of a depth pass.
struct UniformInputs {
  const PackedScene& scene;
  const Slots& slots;
  const World& world;
  const View& view;
  std::span<const View> shadow_views = {};  ///< One per shadow map of the scene; none in a depth pass.
  const View* depth_pass_view = nullptr;    ///< Set in a depth pass: the map being drawn.
  glm::dmat4 object_to_world{1.0};
  glm::dvec4 depth_range{0};             ///< PackedSource::depth_pass_range.
  std::int32_t bound_viewpoint = -1;     ///< Through which `view` looks; -1: it is none of the scene's.
  glm::dvec2 target_size{1};             ///< PackedSource::target_size.
  const View* wearer = nullptr;          ///< Who wears the headlight, and whom mirrors serve; null: `view`.
  const PackedWindow* mirror = nullptr;  ///< Of the shape.
};

/// The binding's value as `count` elements of `type`, finite floats. Vectors are cut or filled with zeros to fit.
/// Samplers (texture, shadow_map) have no numbers: nothing is returned.
std::vector<float> evaluate(const PackedBinding& binding, PackedUniformType type, std::uint32_t count,
                            const UniformInputs& inputs);

/// What projects texture coordinates, from world space (PackedSource::projector_matrix, viewpoint_projector_matrix or
/// mirror_projector_matrix).
glm::dmat4 projector_matrix(const PackedBinding& binding, const UniformInputs& inputs);

/// NaN becomes 0, and what is beyond the range of floats its end.
float finite_float(double value);

/// Inverse transpose of the upper left 3x3; of a singular matrix the nearest that still is finite (its cofactors).
glm::dmat3 normal_matrix(const glm::dmat4& model_view);

}  // namespace plugc

#pragma once
// Rays to a light: what is between it and a point. By Embree, which is optional when plugc is built and when it runs.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "runtime/surfaces.h"

namespace plugc {

/// A triangle of a shape; rays that leave it ignore it.
struct TriangleId {
  std::uint32_t shape = 0;
  std::uint32_t triangle = 0;
};

/// Where light comes from: along a direction (unit, towards the light), or from a place. World space.
struct LightSource {
  bool directional = true;
  glm::dvec3 towards{0, 0, 1};
  glm::dvec3 place{0};
  double near = 0;  ///< What is nearer to the place casts no shadow.
};

/// The light of a map.
LightSource light_source(const PackedScene& scene, const PackedShadowMap& map, const Slots& slots, const World& world);

/// Unit vector from the point.
glm::dvec3 towards_light(const LightSource& light, const glm::dvec3& point);

/// The casters of a scene. Coordinates are taken from the scene's centre, so that a scene far from its origin loses nothing
/// when they become floats.
class Tracer {
 public:
  /// Null, with `error`, where plugc was built without Embree, or the machine has none.
  static std::unique_ptr<Tracer> make(const std::vector<Surface>& surfaces, std::string& error);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// Whether something stands between the point and the light. Rays begin 1e-5 of the scene's size from the point. Threads may
  /// ask at the same time.
  bool shadowed(const glm::dvec3& point, const TriangleId& from, const LightSource& light) const;

  /// The diagonal of the box around all surfaces.
  double scene_size() const;

 private:
  Tracer();
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plugc

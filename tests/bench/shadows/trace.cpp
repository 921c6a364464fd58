// One Embree geometry a casting surface, in the order of the surfaces. A filter is asked about every hit: it refuses the
// triangle that the ray left, and the holes of alpha-tested surfaces.

#include "shadows/trace.h"

#include <embree3/rtcore.h>

#include <algorithm>

#include "runtime/box.h"

namespace plugc {
namespace {

constexpr double kStartOfRay = 1e-5;  // of the scene's size

struct Caster {
  std::uint32_t shape = 0;
  std::optional<AlphaTest> alpha_test;
  std::vector<glm::dvec2> tex_coords;
};

/// Embree hands its context back to the filter: the ray's own data stands behind it.
struct RayContext {
  RTCIntersectContext embree;
  TriangleId from;
};

bool is_hole(const Caster& caster, std::uint32_t triangle, double u, double v) {
  if (!caster.alpha_test) return false;
  const glm::dvec2* const corner = &caster.tex_coords[std::size_t{triangle} * 3];
  return alpha_at(*caster.alpha_test, (1 - u - v) * corner[0] + u * corner[1] + v * corner[2]) < caster.alpha_test->cutoff;
}

void filter_hit(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] != -1) return;  // single rays only
  const auto& caster = *static_cast<const Caster*>(arguments->geometryUserPtr);
  const auto& context = *reinterpret_cast<const RayContext*>(arguments->context);
  const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
  const bool own = caster.shape == context.from.shape && hit.primID == context.from.triangle;
  const bool hole = is_hole(caster, hit.primID, static_cast<double>(hit.u), static_cast<double>(hit.v));
  if (own || hole) arguments->valid[0] = 0;
}

Box box_of(const std::vector<Surface>& surfaces) {
  Box box;
  for (const Surface& surface : surfaces) {
    for (const glm::dvec3& point : surface.points) {
      const glm::dvec3 world(surface.to_world * glm::dvec4(point, 1));
      box.min = glm::min(box.min, world);
      box.max = glm::max(box.max, world);
    }
  }
  return box.empty() ? Box{glm::dvec3(-1), glm::dvec3(1)} : box;
}

void add_geometry(RTCDevice device, RTCScene scene, const Surface& surface, const glm::dvec3& center, Caster* caster) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t count = surface.points.size();
  auto* const vertices = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), count));
  auto* const indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count / 3));
  for (std::size_t i = 0; i < count; ++i) {
    vertices[i] = glm::vec3(glm::dvec3(surface.to_world * glm::dvec4(surface.points[i], 1)) - center);
    indices[i] = static_cast<std::uint32_t>(i);
  }
  rtcSetGeometryUserData(geometry, caster);
  rtcSetGeometryOccludedFilterFunction(geometry, filter_hit);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace

struct Tracer::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  glm::dvec3 center{0};
  double size = 1;
  std::vector<std::unique_ptr<Caster>> casters;

  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

Tracer::Tracer(const std::vector<Surface>& surfaces) : state_(std::make_unique<State>()) {
  const Box box = box_of(surfaces);
  state_->center = box.center();
  state_->size = glm::length(box.size());
  state_->device = rtcNewDevice(nullptr);
  state_->scene = rtcNewScene(state_->device);
  rtcSetSceneFlags(state_->scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  for (const Surface& surface : surfaces) {
    if (!surface.casts || surface.points.empty()) continue;
    state_->casters.push_back(std::make_unique<Caster>(Caster{surface.shape, surface.alpha_test, surface.tex_coords}));
    add_geometry(state_->device, state_->scene, surface, state_->center, state_->casters.back().get());
  }
  rtcCommitScene(state_->scene);
}

Tracer::~Tracer() = default;

bool Tracer::shadowed(const glm::dvec3& point, const TriangleId& from, const LightSource& light) const {
  const glm::dvec3 path = light.place - point;
  const double distance = light.directional ? 2 * state_->size : glm::length(path);
  const glm::vec3 direction(light.directional ? light.towards : path / distance);
  const glm::vec3 origin(point - state_->center);
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.tnear = static_cast<float>(kStartOfRay * state_->size);
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = static_cast<float>(distance);
  ray.mask = ~0U;
  RayContext context{{}, from};
  rtcInitIntersectContext(&context.embree);
  rtcOccluded1(state_->scene, &context.embree, &ray);
  return ray.tfar < 0;
}

double Tracer::scene_size() const {
  return state_->size;
}

}  // namespace plugc

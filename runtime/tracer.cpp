// One Embree geometry a casting surface, in the order of the surfaces. A filter is asked about every hit: it refuses the
// triangle that the ray left, and the holes of alpha-tested surfaces.

#include "runtime/tracer.h"

#include "runtime/embree_library.h"
#include "runtime/projection.h"

#ifdef PLUGC_EMBREE

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

void add_geometry(const EmbreeLibrary& embree, RTCDevice device, RTCScene scene, const Surface& surface,
                  const glm::dvec3& center, Caster* caster) {
  auto* const geometry = embree.rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t count = surface.points.size();
  auto* const vertices = static_cast<glm::vec3*>(
      embree.rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), count));
  auto* const indices = static_cast<std::uint32_t*>(embree.rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count / 3));
  for (std::size_t i = 0; i < count; ++i) {
    vertices[i] = glm::vec3(glm::dvec3(surface.to_world * glm::dvec4(surface.points[i], 1)) - center);
    indices[i] = static_cast<std::uint32_t>(i);
  }
  embree.rtcSetGeometryUserData(geometry, caster);
  embree.rtcSetGeometryOccludedFilterFunction(geometry, filter_hit);
  embree.rtcCommitGeometry(geometry);
  embree.rtcAttachGeometry(scene, geometry);
  embree.rtcReleaseGeometry(geometry);
}

}  // namespace

struct Tracer::State {
  const EmbreeLibrary* embree = nullptr;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  glm::dvec3 center{0};
  double size = 1;
  std::vector<std::unique_ptr<Caster>> casters;

  ~State() {
    if (!embree_is_there()) return;
    if (scene != nullptr) embree->rtcReleaseScene(scene);
    if (device != nullptr) embree->rtcReleaseDevice(device);
  }
};

std::unique_ptr<Tracer> Tracer::make(const std::vector<Surface>& surfaces, std::string& error) {
  const EmbreeLibrary* const library = embree_library(error);
  if (library == nullptr) return nullptr;
  const EmbreeLibrary& embree = *library;
  std::unique_ptr<Tracer> tracer(new Tracer());
  State& state = *tracer->state_;
  const Box box = box_of(surfaces);
  state.embree = library;
  state.center = box.center();
  state.size = glm::length(box.size());
  state.device = embree.rtcNewDevice(nullptr);
  if (state.device == nullptr) {
    error = "Embree cannot work here";
    return nullptr;
  }
  state.scene = embree.rtcNewScene(state.device);
  embree.rtcSetSceneFlags(state.scene, RTC_SCENE_FLAG_ROBUST);
  for (const Surface& surface : surfaces) {
    if (!surface.casts || surface.points.empty()) continue;
    state.casters.push_back(std::make_unique<Caster>(Caster{surface.shape, surface.alpha_test, surface.tex_coords}));
    add_geometry(embree, state.device, state.scene, surface, state.center, state.casters.back().get());
  }
  embree.rtcCommitScene(state.scene);
  return tracer;
}

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
  ray.tfar = static_cast<float>(std::max(distance - light.near, 0.0));
  ray.mask = ~0U;
  RayContext context{{}, from};
  rtcInitIntersectContext(&context.embree);
  state_->embree->rtcOccluded1(state_->scene, &context.embree, &ray);
  return ray.tfar < 0;
}

double Tracer::scene_size() const {
  return state_->size;
}

#else

namespace plugc {

struct Tracer::State {};

std::unique_ptr<Tracer> Tracer::make(const std::vector<Surface>&, std::string& error) {
  error = "plugc was built without Embree";
  return nullptr;
}

bool Tracer::shadowed(const glm::dvec3&, const TriangleId&, const LightSource&) const {
  return false;
}

double Tracer::scene_size() const {
  return 0;
}

#endif

LightSource light_source(const PackedScene& scene, const PackedShadowMap& map, const Slots& slots, const World& world) {
  const PackedLight& packed = *scene.lights()->Get(map.light());
  const glm::dmat4& place = world.at(packed.transform()).matrix;
  LightSource source;
  source.directional = packed.kind() == PackedLightKind::directional;
  source.towards = -light_direction(packed, place, slots);
  source.place = glm::dvec3(place * glm::dvec4(slots.vector3(packed.location(), glm::dvec3(0)), 1));
  Messages said_by_the_map;
  if (packed.kind() == PackedLightKind::point) source.near = light_frame(scene, map, slots, world, said_by_the_map).near;
  return source;
}

glm::dvec3 towards_light(const LightSource& light, const glm::dvec3& point) {
  return light.directional ? light.towards : glm::normalize(light.place - point);
}

Tracer::Tracer() : state_(std::make_unique<State>()) {}

Tracer::~Tracer() = default;

}  // namespace plugc

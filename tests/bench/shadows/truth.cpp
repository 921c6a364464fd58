// The receiver of a pixel is not what a camera ray hits, but the triangle that OpenGL drew there: the pixel's ray is cut with
// that triangle's plane. So rasteriser and tracer cannot disagree about what is seen, and no depth is rounded.

#include "shadows/truth.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

#include "shadows/instrument.h"

namespace plugc {
namespace {

constexpr double kGrazing = 0.01;  // normal . L at and below which a surface is as good as unlit

/// A triangle in world space.
struct WorldTriangle {
  glm::dvec3 a{0}, b{0}, c{0};
};

WorldTriangle triangle_of(const Surface& surface, std::uint32_t triangle) {
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(surface.to_world * glm::dvec4(surface.points[std::size_t{triangle} * 3 + i], 1));
  };
  return {corner(0), corner(1), corner(2)};
}

bool is_receiver(const PackedShape& shape, std::uint32_t map) {
  return std::find(shape.receives()->begin(), shape.receives()->end(), map) != shape.receives()->end();
}

glm::dvec3 towards_light(const LightSource& light, const glm::dvec3& point) {
  return light.directional ? light.towards : glm::normalize(light.place - point);
}

/// The pixel's ray cut with its triangle. Not counted where that has no area, or is seen from its edge.
TruthPixel find_receiver(const Surface& surface, const TriangleId& id, const CameraRays& rays, double x, double y,
                         const glm::dvec3& eye, const glm::dvec3& looking) {
  TruthPixel pixel;
  pixel.triangle = id;
  const WorldTriangle t = triangle_of(surface, id.triangle);
  const glm::dvec3 across = glm::cross(t.b - t.a, t.c - t.a);
  const double twice_area = glm::length(across);
  if (!(twice_area > 0)) return pixel;
  pixel.normal = across / twice_area;
  pixel.point = rays.on_plane(x, y, t.a, pixel.normal);
  const glm::dvec3 to_viewer = looking == glm::dvec3(0) ? eye - pixel.point : -looking;
  if (glm::dot(pixel.normal, to_viewer) < 0) pixel.normal = -pixel.normal;
  pixel.counted = std::isfinite(pixel.point.x + pixel.point.y + pixel.point.z);
  return pixel;
}

}  // namespace

CameraRays::CameraRays(const View& camera, int width, int height) : eye_to_world_(camera.eye_to_world) {
  const glm::dmat4 pixels_to_clip = glm::translate(glm::dmat4(1.0), glm::dvec3(-1, -1, 0)) *
                                    glm::scale(glm::dmat4(1.0), glm::dvec3(2.0 / width, 2.0 / height, 1));
  picture_to_eye_ = glm::inverse(camera.projection) * pixels_to_clip;
}

glm::dvec3 CameraRays::on_plane(double x, double y, const glm::dvec3& point, const glm::dvec3& normal) const {
  const auto at_depth = [&](double depth) {
    const glm::dvec4 eye = picture_to_eye_ * glm::dvec4(x, y, depth, 1);
    return glm::dvec3(eye_to_world_ * glm::dvec4(glm::dvec3(eye) / eye.w, 1));
  };
  const glm::dvec3 begin = at_depth(-1);
  const glm::dvec3 along = at_depth(1) - begin;
  return begin + along * (glm::dot(normal, point - begin) / glm::dot(normal, along));
}

LightSource light_source(const PackedScene& scene, std::uint32_t light, const Slots& slots, const World& world) {
  const PackedLight& packed = *scene.lights()->Get(light);
  const glm::dmat4& place = world.at(packed.transform()).matrix;
  LightSource source;
  source.directional = packed.kind() == PackedLightKind::directional;
  source.towards = -glm::normalize(glm::dmat3(place) * slots.vector3(packed.direction(), {0, 0, -1}));
  source.place = glm::dvec3(place * glm::dvec4(slots.vector3(packed.location(), glm::dvec3(0)), 1));
  return source;
}

TruthPicture trace_picture(const Shot& shot, const LoadedScene& scene, const std::vector<Surface>& surfaces,
                           const Tracer& tracer, std::uint32_t map, const View& camera) {
  TruthPicture picture{shot.width, shot.height, std::vector<TruthPixel>(shot.triangles.size()), 0, 0};
  const CameraRays rays(camera, shot.width, shot.height);
  const LightSource light =
      light_source(*scene.packed, scene.packed->shadow_maps()->Get(map)->light(), scene.slots, scene.world);
  std::map<std::uint32_t, const Surface*> surface_of;
  for (const Surface& surface : surfaces) surface_of[surface.shape] = &surface;
  const glm::dvec3 eye(camera.eye_to_world[3]);
  const bool orthographic = camera.projection[3][3] == 1.0;
  const glm::dvec3 looking = orthographic ? -glm::dvec3(camera.eye_to_world[2]) : glm::dvec3(0);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const glm::vec4& seen = shot.triangles[i];
    const auto found = surface_of.find(static_cast<std::uint32_t>(std::max(seen.x, 0.0F)));
    if (seen.w != kSeen || found == surface_of.end()) continue;
    const Surface& surface = *found->second;
    if (surface.may_move || scene.shape(surface.shape).blended() || !is_receiver(scene.shape(surface.shape), map)) continue;
    const TriangleId id{surface.shape, static_cast<std::uint32_t>(seen.y)};
    const double x = static_cast<double>(i % static_cast<std::size_t>(shot.width)) + 0.5;
    const double y = static_cast<double>(i / static_cast<std::size_t>(shot.width)) + 0.5;
    TruthPixel& pixel = picture.pixels[i] = find_receiver(surface, id, rays, x, y, eye, looking);
    pixel.facing = glm::dot(pixel.normal, towards_light(light, pixel.point));
    pixel.counted = pixel.counted && pixel.facing > kGrazing;
    if (!pixel.counted) continue;
    pixel.lit = !tracer.shadowed(pixel.point, id, light);
    ++picture.counted;
    picture.shadowed += pixel.lit ? 0 : 1;
  }
  return picture;
}

}  // namespace plugc

// Directional: turn the world so that the light looks along -z; there take the rectangle of what receives, cut to the
// rectangle of what casts (outside of it nothing can be shadowed, so a ground plane wastes nothing), one texel wider.
// Depth runs from the nearest box to the last receiver; what casts from before is clamped to the near plane.
// Spot: the cone's angle is known, only near and far are fitted, and near stays above a thousandth of far.
// Numbers that are not usable leave by one door: `checked` replaces a projection that is not finite.

#include "runtime/projection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/cube_map.h"

namespace plugc {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSmallestSpotAngle = 1e-3;
constexpr double kLargestSpotAngle = 0.95 * kPi;  // X3D's default cutOffAngle of pi/2 would ask for 180 degrees
constexpr double kNearestSpotRatio = 1e-3;        // near / far
constexpr double kDepthMargin = 0.01;             // of the fitted range, on both ends

bool all_known(const std::vector<PlacedBox>& boxes) {
  return std::ranges::all_of(boxes, &PlacedBox::known);
}

Box box_in(const std::vector<PlacedBox>& boxes, const glm::dmat4& world_to_light) {
  Box all;
  for (const PlacedBox& placed : boxes) all = join(all, transformed(placed.box, world_to_light * placed.to_world));
  return all;
}

/// True for a flat shape behind which, seen from the light, nothing receives: a ground that everything stands on. It
/// cannot shadow itself either, so it takes no part in the window, though as a caster it may be the largest.
bool shadows_nothing(const PlacedBox& caster, const glm::dvec3& towards_light, const Box& receivers) {
  const std::optional<glm::dvec4> front = front_of(caster, {towards_light, 0});
  if (!front || receivers.empty()) return false;
  const double rounding = kThinnest * glm::length(receivers.size());
  return std::ranges::all_of(corners(receivers),
                             [&](const glm::dvec3& corner) { return glm::dot(*front, glm::dvec4(corner, 1)) >= -rounding; });
}

/// The casters that can shadow a receiver.
std::vector<PlacedBox> effective_casters(const FitInput& input, const glm::dvec3& towards_light) {
  const Box receivers = box_in(input.receivers, glm::dmat4(1.0));
  std::vector<PlacedBox> casters;
  std::ranges::copy_if(input.casters, std::back_inserter(casters),
                       [&](const PlacedBox& caster) { return !shadows_nothing(caster, towards_light, receivers); });
  return casters;
}

bool finite_as_float(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) <= static_cast<double>(std::numeric_limits<float>::max()))) return false;
    }
  }
  return true;
}

/// Distances along the direction. What the author wrote wins.
Interval chosen(const LightFrame& light, Interval fitted) {
  if (light.near > 0) fitted.low = light.near;
  if (light.far > 0) fitted.high = light.far;
  if (fitted.low < fitted.high) return fitted;
  if (light.far > 0 && light.near <= 0) return {light.far * kNearestSpotRatio, light.far};
  return {fitted.low, fitted.low + std::max(std::abs(fitted.low), kSmallestLength)};
}

View fit_directional(const LightFrame& light, const FitInput& input) {
  View view = look_along(light.location, light.direction, light.up);
  const bool may_move = !all_known(input.casters) || !all_known(input.receivers);
  const Box casters =
      box_in(may_move ? input.casters : effective_casters(input, glm::dvec3(view.eye_to_world[2])), view.world_to_eye);
  const Box receivers = box_in(input.receivers, view.world_to_eye);
  Box around = join(casters, receivers);
  if (around.empty()) around = {glm::dvec3(-1), glm::dvec3(1)};
  const Box shadowed = intersect(casters, receivers);
  const bool cut = !may_move && shadowed.min.x <= shadowed.max.x && shadowed.min.y <= shadowed.max.y;
  const Box& fitted = cut ? shadowed : around;

  glm::dvec4 rectangle = light.rectangle;
  if (rectangle == glm::dvec4(0)) {
    const double texel = 1.0 / std::max(light.map_size, 16U);
    const Interval x = widened({fitted.min.x, fitted.max.x}, texel);
    const Interval y = widened({fitted.min.y, fitted.max.y}, texel);
    rectangle = {x.low, y.low, x.high, y.high};
  }
  const double first = -around.max.z;
  const double last_receiver = receivers.empty() ? -around.min.z : -receivers.min.z;
  // Where the location is computed too, it lies where the boxes begin, and written distances count from there.
  const double start = light.located ? 0 : first;
  Interval depth = widened({first, std::max(last_receiver, first)}, kDepthMargin);
  depth = chosen(light, {depth.low - start, depth.high - start});
  view.near = depth.low + start;
  view.far = depth.high + start;
  view.projection = parallel(rectangle, {view.near, view.far}, false);
  return view;
}

/// The nearest depth in front of the light at which a box begins; 0 when the light stands beside or inside one.
double nearest_depth(const std::vector<PlacedBox>& boxes, const glm::dmat4& world_to_light, double nearest) {
  for (const PlacedBox& placed : boxes) {
    const Box seen = transformed(placed.box, world_to_light * placed.to_world);
    if (seen.empty() || -seen.min.z <= 0) continue;
    nearest = std::min(nearest, std::max(-seen.max.z, 0.0));
  }
  return nearest;
}

View fit_spot(const LightFrame& light, const FitInput& input) {
  View view = look_along(light.location, light.direction, light.up);
  const Box receivers = box_in(input.receivers, view.world_to_eye);
  const double last_receiver = receivers.empty() ? 0 : -receivers.min.z;
  const double far = last_receiver > kSmallestLength ? last_receiver * (1 + kDepthMargin) : 1.0;
  const double nearest =
      nearest_depth(input.receivers, view.world_to_eye, nearest_depth(input.casters, view.world_to_eye, far));
  const double half = std::tan(std::clamp(light.angle, kSmallestSpotAngle, kLargestSpotAngle) / 2);
  Interval depth = chosen(light, {nearest * (1 - kDepthMargin), far});
  depth.low = light.near > 0 ? depth.low : std::max(depth.low, depth.high * kNearestSpotRatio);
  view.projection = perspective({-half, -half, half, half}, depth, false);
  view.near = depth.low;
  view.far = depth.high;
  return view;
}

std::string title(const PackedLight& light) {
  return light.name()->size() == 0 ? "a light" : "the light `" + light.name()->str() + "`";
}

void check_distances(LightFrame& frame, const PackedLight& light, Messages& messages) {
  if (!(frame.near >= 0 && frame.near <= kLargestLength)) {
    messages.add("`projectionNear` of " + title(light) + " is no distance: it is computed instead");
    frame.near = 0;
  }
  if (frame.far != 0 && !(frame.far > frame.near && frame.far <= kLargestLength)) {
    messages.add("`projectionFar` of " + title(light) + " is not behind `projectionNear`: both are computed instead");
    frame.near = frame.far = 0;
  }
}

void check_rectangle(LightFrame& frame, const PackedLight& light, Messages& messages) {
  const glm::dvec4& r = frame.rectangle;
  const bool usable = r.x < r.z && r.y < r.w && glm::all(glm::lessThanEqual(glm::abs(r), glm::dvec4(kLargestLength)));
  if (r == glm::dvec4(0) || usable) return;
  messages.add("`projectionRectangle` of " + title(light) + " is empty (left, bottom, right, top): it is computed instead");
  frame.rectangle = glm::dvec4(0);
}

}  // namespace

double look_up_reach(PackedShadowMethod method) {
  switch (method) {
    case PackedShadowMethod::pcf4:
    case PackedShadowMethod::pcf4_taps:
    case PackedShadowMethod::poisson: return 2.5;  // 1.5 to the outer look-ups, and theirs
    default: return 2;                             // pcf3 and sharp3: 1 and theirs; moments: 1 by the blur and 1 by the look-up
  }
}

LightFrame light_frame(const PackedScene& scene, const PackedShadowMap& map, const Slots& slots, const World& world,
                       Messages& messages) {
  const PackedLight& light = *scene.lights()->Get(map.light());
  const glm::dmat4& place = world.at(light.transform()).matrix;
  const double longer = average_scale(place);
  LightFrame frame;
  frame.kind = light.kind();
  frame.map_size = map.size();
  frame.reach = look_up_reach(map.method());
  frame.unit = longer;
  frame.direction = glm::dmat3(place) * slots.vector3(light.direction(), {0, 0, -1});
  const glm::dvec3 up = slots.vector3(map.up(), glm::dvec3(0));
  frame.up_written = up != glm::dvec3(0);
  frame.up = glm::dmat3(place) * (frame.up_written ? up : glm::dvec3(0, 1, 0));
  frame.near = slots.number(map.near(), 0) * longer;
  frame.far = slots.number(map.far(), 0) * longer;
  const bool spot = light.kind() == PackedLightKind::spot;
  const double cut_off = slots.number(light.cut_off_angle(), kPi / 2);
  const double angle = slots.number(map.angle(), 0);
  frame.angle_written = angle > 0;
  frame.angle = frame.angle_written ? angle : 2 * cut_off;
  if (!std::isfinite(frame.angle)) frame.angle = kLargestSpotAngle;
  const bool directional = light.kind() == PackedLightKind::directional;
  if (!directional) frame.radius = slots.number(light.radius(), 100) * longer;
  if (!spot) frame.rectangle = slots.vector4(map.rectangle(), glm::dvec4(0)) * longer;
  check_distances(frame, light, messages);
  check_rectangle(frame, light, messages);
  const glm::dvec3 own = slots.vector3(directional ? map.location() : light.location(), glm::dvec3(0));
  frame.location = glm::dvec3(place * glm::dvec4(own, 1));
  frame.located = own != glm::dvec3(0) || frame.rectangle != glm::dvec4(0);
  return frame;
}

Interval widened(Interval range, double margin) {
  const double reach = std::max({std::abs(range.low), std::abs(range.high), kSmallestLength});
  const double extra = std::max((range.high - range.low) * margin, reach * kThinnest);
  return {range.low - extra, range.high + extra};
}

glm::dmat4 parallel(const glm::dvec4& rectangle, const Interval& depth, bool reversed) {
  glm::dmat4 matrix = glm::ortho(rectangle.x, rectangle.z, rectangle.y, rectangle.w, depth.low, depth.high);
  if (!reversed) return matrix;
  // Half of the range alone: a float near 0 would resolve more than the arithmetic before it, and offset less than that needs.
  matrix[2][2] = 0.5 / (depth.high - depth.low);
  matrix[3][2] = 1 + depth.low * matrix[2][2];
  return matrix;
}

glm::dmat4 perspective(const glm::dvec4& window, const Interval& depth, bool reversed) {
  const glm::dvec4 cut = window * depth.low;
  glm::dmat4 matrix = glm::frustum(cut.x, cut.z, cut.y, cut.w, depth.low, depth.high);
  if (!reversed) return matrix;
  matrix[2][2] = 0;
  matrix[3][2] = depth.low;
  return matrix;
}

View checked(const View& view) {
  if (finite_as_float(view.world_to_eye) && finite_as_float(view.projection) &&
      finite_as_float(view.projection * view.world_to_eye)) {
    return view;
  }
  View fallback = look_along(glm::dvec3(0), {0, 0, -1}, {0, 1, 0});
  fallback.projection = parallel({-1, -1, 1, 1}, {-1, 1}, view.reversed);
  fallback.reversed = view.reversed;
  return fallback;
}

View fit_light(const LightFrame& light, const FitInput& input) {
  if (light.kind == PackedLightKind::point) return fit_point_light(light, input);
  return checked(light.kind == PackedLightKind::spot ? fit_spot(light, input) : fit_directional(light, input));
}

glm::dvec4 linear_depth_plane(const View& light) {
  const double range = light.far - light.near;
  if (!(range > 0)) return glm::dvec4(0);
  const glm::dmat4& to_eye = light.world_to_eye;
  const glm::dvec4 height(to_eye[0][2], to_eye[1][2], to_eye[2][2], to_eye[3][2]);  // against the light's direction
  return -(height + glm::dvec4(0, 0, 0, light.near)) / range;
}

glm::dvec4 linear_depth_line(const View& light) {
  // Clip depth c = (a z + b) / (p z + q), so z = (b - c q) / (c p - a); the distance -z is then counted from near to far.
  const glm::dmat4& m = light.projection;
  const double a = m[2][2], b = m[3][2], p = m[2][3], q = m[3][3];
  const double range = light.far - light.near;
  const glm::dvec2 above(q - light.near * p, light.near * a - b);  // of c, and alone
  const glm::dvec2 below(range * p, -range * a);
  if (light.reversed) return glm::dvec4(above, below);
  return {2 * above.x, above.y - above.x, 2 * below.x, below.y - below.x};  // c = 2 d - 1
}

glm::dmat4 world_to_texture(const View& light) {
  if (light.all_around) return light.projection * light.world_to_eye;
  const glm::dvec3 half(0.5, 0.5, light.reversed ? 1.0 : 0.5);
  const glm::dvec3 shift(0.5, 0.5, light.reversed ? 0.0 : 0.5);
  const glm::dmat4 halve = glm::translate(glm::dmat4(1.0), shift) * glm::scale(glm::dmat4(1.0), half);
  return halve * light.projection * light.world_to_eye;
}

}  // namespace plugc

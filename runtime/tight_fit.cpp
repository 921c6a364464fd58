// All in the light's own space, looking along -z. There a map is a window: of lengths x, y for a directional light, of
// tangents x / depth, y / depth for a spot light. Receivers are cut to what the camera shows and the spot's cone holds; the
// window around what remains, continued towards the light, is where casters matter; the window around casters in there is
// what the map shows. Outside of it all is lit, as nothing casts there.
//
// Steps: a texel's size is one of a geometric series, the window's low end a whole number of texels (in cells of several), so
// that equal demands give equal windows, whichever way the camera came. They are counted in the light's own units, so that a
// scene with its light looks the same at whatever size it stands. A window that was used last is kept as long as it
// holds what is needed and is not much larger.

#include "runtime/tight_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/hull.h"

namespace plugc {
namespace {

constexpr std::uint32_t kCellsPerSide = 64;     // steps by which the window moves
constexpr std::uint32_t kSmallestSnapped = 32;  // maps with fewer texels along a side could not spare any
constexpr double kTexelSteps = 16;              // sizes of a texel from one to its double
constexpr double kKeptSize = 1.1;               // how much larger than needed a texel may be for its window to be kept
constexpr double kKeptDepth = 4;                // the same for the depths
constexpr double kDepthMargin = 0.01;
constexpr std::size_t kMostReceiversTried = 256;  // for each flat caster
constexpr double kCoarsest = 65536;               // beyond, shadows would part from what casts them by more than eyes forgive
constexpr double kNearestRatio = 1e-6;  // near / far of a spot light: nearness costs nothing, but floats end somewhere
// Radians that a sun's map is turned around its direction: see slanted(). At this angle to the columns a kernel of 3 x 3
// look-ups places an edge 0.07 texels off on the average, the nearest texel 0.25. Less than 15 degrees would not do; near 27
// and 45 an edge meets the texels alike every other row.
constexpr double kSlant = 20 * std::numbers::pi / 180;
constexpr double kSmallestHalfAngle = 5e-4;
constexpr double kLargestHalfAngle = 0.475 * std::numbers::pi;

/// The light's own space, and the part of it that the light reaches.
struct LightSpace {
  View view;
  bool spot = false;
  double half_window = 0;  ///< Spot: tangent of half its angle.
  Hull cone;               ///< Spot: without planes else.
};

/// From the light on through a window of tangents, to a distance.
Hull cone_hull(const glm::dvec4& window, double far) {
  Hull hull;
  const glm::dvec3 apex(0);
  const std::array<glm::dvec3, 4> ends = {glm::dvec3(window.x, window.y, -1) * far, glm::dvec3(window.z, window.y, -1) * far,
                                          glm::dvec3(window.z, window.w, -1) * far, glm::dvec3(window.x, window.w, -1) * far};
  for (std::size_t i = 0; i < ends.size(); ++i) hull.faces.push_back({apex, ends[i], ends[(i + 1) % ends.size()]});
  hull.faces.emplace_back(ends.begin(), ends.end());
  hull.planes = {{1, 0, window.x, 0}, {-1, 0, -window.z, 0}, {0, 1, window.y, 0}, {0, -1, -window.w, 0}, {0, 0, 1, far}};
  return hull;
}

double farthest(const FitInput& input, const glm::dmat4& world_to_light) {
  double far = kSmallestLength;
  for (const auto* boxes : {&input.casters, &input.receivers}) {
    for (const PlacedBox& placed : *boxes) {
      const Box seen = transformed(placed.box, world_to_light * placed.to_world);
      if (!seen.empty()) far = std::max(far, -seen.min.z);
    }
  }
  return far * (1 + kDepthMargin);
}

/// With +y upwards in a sun's map, the shadow of every vertical edge would run along a column of texels: each row has it at the
/// same place, and no filter can tell where in the texel it lies. Where an edge crosses columns, a kernel finds it from several
/// rows together. So the map lies aslant, unless its author says how it lies.
View slanted(const View& view, const LightFrame& light) {
  if (light.kind == PackedLightKind::spot || light.up_written || light.rectangle != glm::dvec4(0)) return view;
  const glm::dvec3 along(0, 0, 1);
  View turned = view;
  turned.eye_to_world = glm::rotate(view.eye_to_world, -kSlant, along);
  turned.world_to_eye = glm::rotate(glm::dmat4(1.0), kSlant, along) * view.world_to_eye;
  return turned;
}

LightSpace light_space(const LightFrame& light, const FitInput& input) {
  LightSpace space;
  space.view = slanted(look_along(light.location, light.direction, light.up), light);
  space.view.reversed = true;
  space.spot = light.kind == PackedLightKind::spot;
  if (!space.spot) return space;
  const double half = std::tan(std::clamp(light.angle / 2, kSmallestHalfAngle, kLargestHalfAngle));
  space.half_window = half;
  const double far = farthest(input, space.view.world_to_eye);
  space.cone = cone_hull({-half, -half, half, half}, light.radius > 0 ? std::min(far, light.radius) : far);
  return space;
}

/// Window x, y and depth of points in the light's space.
Box window_of(const LightSpace& space, const std::vector<glm::dvec3>& points, double far) {
  Box box;
  for (const glm::dvec3& point : points) {
    const double depth = -point.z;
    if (space.spot && !(depth > far * kNearestRatio)) continue;  // the light itself: the other ends say where to
    const glm::dvec3 found =
        space.spot ? glm::dvec3(point.x / depth, point.y / depth, depth) : glm::dvec3(point.x, point.y, depth);
    box.min = glm::min(box.min, found);
    box.max = glm::max(box.max, found);
  }
  return box;
}

Box common_window(const LightSpace& space, std::initializer_list<const Hull*> hulls, double far) {
  std::vector<const Hull*> present;
  for (const Hull* hull : hulls) {
    if (hull != nullptr) present.push_back(hull);
  }
  return window_of(space, common_points(present), far);
}

/// Whether all of the box is outside of one plane.
bool is_outside(const PlacedBox& placed, const glm::dmat4& world_to_light, const Hull& hull) {
  const glm::dmat4 to_light = world_to_light * placed.to_world;
  return std::ranges::any_of(hull.planes, [&](const glm::dvec4& plane) {
    const glm::dvec4 in_box = plane * to_light;
    const auto points = corners(placed.box);
    return std::ranges::all_of(points, [&](const glm::dvec3& corner) { return glm::dot(in_box, glm::dvec4(corner, 1)) < 0; });
  });
}

bool any_unknown(const std::vector<PlacedBox>& boxes) {
  return std::ranges::any_of(boxes, [](const PlacedBox& placed) { return !placed.known; });
}

/// The window of all that receives and can be seen, and is behind `part` where there is such a plane; a receiver without known
/// bounds may be anywhere that is in view.
Box receivers_window(const LightSpace& space, const FitInput& input, const Hull* part, double far) {
  const Hull* const cone = space.spot ? &space.cone : nullptr;
  Hull camera;
  if (input.camera != nullptr) {
    camera = view_hull(input.camera->world_to_eye * space.view.eye_to_world, input.camera->projection);
  }
  const Hull* const view = input.camera != nullptr ? &camera : nullptr;
  Box window;
  for (const PlacedBox& placed : input.receivers) {
    if (part != nullptr && is_outside(placed, space.view.world_to_eye, *part)) continue;  // most, and quicker told so
    const Hull hull = hull_of(placed.box, space.view.world_to_eye * placed.to_world);
    window = join(window, common_window(space, {&hull, view, cone, part}, far));
  }
  if (!any_unknown(input.receivers)) return window;
  if (view != nullptr || cone != nullptr) return join(window, common_window(space, {view, cone, part}, far));
  for (const PlacedBox& placed : input.casters) {
    const Hull hull = hull_of(placed.box, space.view.world_to_eye * placed.to_world);
    window = join(window, common_window(space, {&hull, part}, far));
  }
  return window;
}

/// The same, never flat.
Box thickened(const Box& window) {
  if (window.empty()) return window;
  const Interval x = widened({window.min.x, window.max.x}, 0);
  const Interval y = widened({window.min.y, window.max.y}, 0);
  const Interval z = widened({window.min.z, window.max.z}, 0);
  return {{x.low, y.low, z.low}, {x.high, y.high, z.high}};
}

/// Where the first caster begins, along the way of the light.
double first_caster(const LightSpace& space, const FitInput& input) {
  double first = -std::numeric_limits<double>::infinity();
  for (const PlacedBox& placed : input.casters) {
    const Box seen = transformed(placed.box, space.view.world_to_eye * placed.to_world);
    if (!seen.empty()) first = std::max(first, seen.max.z);
  }
  return first;
}

/// From what receives towards the light, or of a directional light to `first`.
Hull casting_space(const LightSpace& space, double first, const Box& receivers) {
  if (space.spot) return cone_hull({receivers.min.x, receivers.min.y, receivers.max.x, receivers.max.y}, receivers.max.z);
  first = std::max(first, -receivers.min.z);
  return hull_of({{receivers.min.x, receivers.min.y, -receivers.max.z}, {receivers.max.x, receivers.max.y, first}},
                 glm::dmat4(1.0));
}

/// Where what receives lies behind a flat caster; all of it for another caster. A ground that all stands on shadows nothing,
/// and one that things stick in a little shadows little.
Box receivers_behind(const LightSpace& space, const FitInput& input, const PlacedBox& caster, const Box& receivers,
                     double far) {
  if (input.receivers.size() > kMostReceiversTried) return receivers;
  const PlacedBox seen = {caster.box, space.view.world_to_eye * caster.to_world, caster.known};
  const std::optional<glm::dvec4> front = front_of(seen, space.spot ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(0, 0, 1, 0));
  if (!front) return receivers;
  Hull behind;
  behind.planes = {-*front - glm::dvec4(0, 0, 0, kThinnest * far)};
  return intersect(thickened(receivers_window(space, input, &behind, far)), receivers);
}

/// The window, within that of the receivers, where something casts.
Box casters_window(const LightSpace& space, const FitInput& input, const Box& receivers, double far) {
  if (any_unknown(input.casters)) return receivers;
  Box window;
  const double first = first_caster(space, input);
  for (const PlacedBox& caster : input.casters) {
    const Box reached = receivers_behind(space, input, caster, receivers, far);
    if (reached.empty()) continue;
    const Hull where = casting_space(space, first, reached);
    const Hull hull = hull_of(caster.box, space.view.world_to_eye * caster.to_world);
    window = join(window, common_window(space, {&hull, &where}, far));
  }
  return window;
}

/// The next of a geometric series of lengths, `steps` from one to its double.
double stepped_up(double length, double unit, double steps) {
  return unit * std::exp2(std::ceil(std::log2(length / unit) * steps) / steps);
}

/// An extent of the map's texels around what is needed, its texel from a geometric series and its low end on a grid. Around
/// what is needed is a margin as wide as look-ups reach: beyond the map all is lit.
Interval in_steps(Interval needed, const LightFrame& light, double unit) {
  const std::uint32_t size = light.map_size;
  needed = widened(needed, 0);
  if (size < kSmallestSnapped) return widened(needed, 1.0 / std::max(size, 16U));
  const double cell = std::max(size / kCellsPerSide, 1U);
  const double usable = size - 2 * light.reach - cell;
  const double texel = stepped_up((needed.high - needed.low) / usable, unit, kTexelSteps);
  const double low = std::floor((needed.low / texel - light.reach) / cell) * cell * texel;
  return {low, low + size * texel};
}

Interval depth_in_steps(const Interval& needed, double unit) {
  const double step = stepped_up(needed.high - needed.low, unit, 2) / 8;
  return {std::floor(needed.low / step) * step, std::ceil(needed.high / step) * step};
}

bool holds(const Interval& range, const Interval& needed) {
  return range.low <= needed.low && needed.high <= range.high;
}

bool still_serves(const Interval& kept, const Interval& needed, const Interval& fresh, const LightFrame& light) {
  const double margin = (kept.high - kept.low) / light.map_size * light.reach;
  return holds(kept, {needed.low - margin, needed.high + margin}) &&
         kept.high - kept.low <= (fresh.high - fresh.low) * kKeptSize;
}

/// How far the camera sees what receives; without one, how far that spreads.
double reach_of(const LightSpace& space, const View* camera, const Box& receivers) {
  const glm::dvec3 eye = camera == nullptr ? receivers.center() : glm::dvec3(space.view.world_to_eye * camera->eye_to_world[3]);
  double reach = 0;
  for (const glm::dvec3& corner : corners(receivers)) {
    const glm::dvec2 beside = glm::dvec2(corner) * (space.spot ? corner.z : 1.0);
    reach = std::max(reach, glm::distance(eye, glm::dvec3(beside, -corner.z)));
  }
  return reach;
}

/// In powers of two, so that a camera that moves on changes it rarely.
double coarseness_of(double reach, double depth) {
  const double ratio = std::clamp(reach / std::max(depth, kSmallestLength), 1.0, kCoarsest);
  return std::exp2(std::ceil(std::log2(ratio)));
}

/// Window and depths that hold `needed`: those of the memory, or new ones.
void choose(const LightSpace& space, const LightFrame& light, const Box& needed, double coarseness, FitMemory& memory) {
  const Interval x = {needed.min.x, needed.max.x};
  const Interval y = {needed.min.y, needed.max.y};
  const double unit = light.unit > kSmallestLength && light.unit < kLargestLength ? light.unit : 1;
  const Interval fresh_x = in_steps(x, light, space.spot ? 1 : unit);
  const Interval fresh_y = in_steps(y, light, space.spot ? 1 : unit);
  Interval depth = widened({needed.min.z, needed.max.z}, kDepthMargin);
  if (space.spot) depth.low = std::max(depth.low, depth.high * kNearestRatio);
  const Interval fresh_depth = space.spot ? Interval{unit * std::exp2(std::floor(std::log2(depth.low / unit))), depth.high}
                                          : depth_in_steps(depth, unit);
  if (memory.any && memory.light == light) {
    const Interval kept_x = {memory.window.x, memory.window.z};
    const Interval kept_y = {memory.window.y, memory.window.w};
    const bool depth_serves = space.spot ? memory.depth.low <= depth.low && depth.low <= memory.depth.low * kKeptDepth
                                         : holds(memory.depth, depth) && memory.depth.high - memory.depth.low <=
                                                                             (fresh_depth.high - fresh_depth.low) * kKeptDepth;
    const bool coarse_enough = coarseness <= memory.coarseness && memory.coarseness <= coarseness * kKeptDepth;
    if (depth_serves && coarse_enough && still_serves(kept_x, x, fresh_x, light) && still_serves(kept_y, y, fresh_y, light))
      return;
  }
  memory = {light, {fresh_x.low, fresh_y.low, fresh_x.high, fresh_y.high}, fresh_depth, coarseness, true};
  if (!space.spot) return;
  // no wider than the cone is
  const double half = space.half_window;
  if (fresh_x.high - fresh_x.low >= 2 * half) memory.window.x = -half, memory.window.z = half;
  if (fresh_y.high - fresh_y.low >= 2 * half) memory.window.y = -half, memory.window.w = half;
}

/// The eye moved in front of the window: numbers stay small wherever it lies.
View centred(const View& view, const glm::dvec3& shift) {
  View moved = view;
  moved.eye_to_world = glm::translate(view.eye_to_world, shift);
  moved.world_to_eye = glm::translate(glm::dmat4(1.0), -shift) * view.world_to_eye;
  return moved;
}

/// `far`: where the last box ends. A spot light's depths run on beyond those of the memory; linear ones must end there.
View view_of(const LightSpace& space, const FitMemory& memory, double far) {
  View view = space.view;
  const glm::dvec4& window = memory.window;
  if (space.spot) {
    view.projection = perspective(window, memory.depth, true);
    view.near = memory.depth.low;
    view.far = std::max(memory.depth.high, far);
    return view;
  }
  const glm::dvec2 center((window.x + window.z) / 2, (window.y + window.w) / 2);
  view = centred(view, {center, -memory.depth.low});
  const glm::dvec2 half((window.z - window.x) / 2, (window.w - window.y) / 2);
  view.far = memory.depth.high - memory.depth.low;
  view.projection = parallel({-half, half}, {0, view.far}, true);
  return view;
}

}  // namespace

TightFit fit_tightly(const LightFrame& light, const FitInput& input, FitMemory& memory) {
  const LightSpace space = light_space(light, input);
  const double far = farthest(input, space.view.world_to_eye);
  const Box receivers = thickened(receivers_window(space, input, nullptr, far));
  if (receivers.empty()) return {};
  Box needed = casters_window(space, input, receivers, far);
  if (needed.empty()) return {};
  needed.min.z = space.spot ? std::min(needed.min.z, receivers.min.z) : receivers.min.z;
  needed.max.z = receivers.max.z;
  const double coarseness =
      coarseness_of(reach_of(space, input.camera, receivers), space.spot ? receivers.min.z : receivers.max.z - receivers.min.z);
  choose(space, light, needed, coarseness, memory);
  if (light.rectangle != glm::dvec4(0)) memory.window = light.rectangle;
  if (light.angle_written) memory.window = glm::dvec4(-1, -1, 1, 1) * space.half_window;
  return {checked(view_of(space, memory, far)), true, memory.coarseness};
}

}  // namespace plugc

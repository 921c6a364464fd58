// The camera: a viewpoint's position and axes carried to the world and made rigid again (a scaled viewpoint moves, and
// does not stretch the picture), or a view of the whole scene. Near and far come from the boxes of what is shown; they
// need not be safe, because depth is clamped, only well spread.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/perspective.h"
#include "runtime/world.h"

namespace plugc {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSmallestAngle = 1e-4;
constexpr double kLargestAngle = kPi - 1e-3;
constexpr double kNearestRatio = 1e-4;  // near / far when the eye stands inside of a box: leaves 10 of 24 bits to the far end
constexpr double kMargin = 1.01;        // rounding in the shader must not cut what the fit just includes

bool usable(const glm::dvec3& vector) {
  return glm::all(glm::lessThanEqual(glm::abs(vector), glm::dvec3(kLargestLength)));  // false for NaN
}

/// The unit vector, or `fallback` where there is none.
glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& fallback) {
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  if (!usable(vector) || !(largest > 1e-200)) return fallback;
  return glm::normalize(vector / largest);
}

/// A fixed unit vector orthogonal to `direction`: made from the axis that it is least along.
glm::dvec3 any_orthogonal(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 axis = size.y <= size.x && size.y <= size.z ? glm::dvec3(0, 1, 0)
                          : size.x <= size.z                   ? glm::dvec3(1, 0, 0)
                                                               : glm::dvec3(0, 0, 1);
  return glm::normalize(axis - glm::dot(axis, direction) * direction);
}

/// Distances along the view at which something is shown: low to high.
struct DepthRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double nearest_in_front = std::numeric_limits<double>::infinity();  ///< Of boxes that the eye plane does not cut.
  bool cut_by_eye = false;
};

DepthRange depth_range(const World& world, const View& view) {
  DepthRange range;
  for (const Box& bounds : world.shape_bounds) {
    const Box seen = transformed(bounds, view.world_to_eye);
    if (seen.empty()) continue;
    const double low = -seen.max.z;
    const double high = -seen.min.z;
    range.low = std::min(range.low, low);
    range.high = std::max(range.high, high);
    if (low > 0) range.nearest_in_front = std::min(range.nearest_in_front, low);
    if (low <= 0 && high > 0) range.cut_by_eye = true;
  }
  return range;
}

glm::dmat4 fitted_perspective(const DepthRange& range, double field, double aspect, bool is_vertical = false) {
  const double far = range.high > 0 ? range.high * kMargin : 100.0;
  const double nearest = range.cut_by_eye ? 0.0 : std::min(range.nearest_in_front / kMargin, far);
  const double near = std::max(nearest, far * kNearestRatio);
  const double distance = std::max(far, near * kMargin);
  return perspective(field, aspect, near, distance, is_vertical);
}

/// `field` is left, bottom, right, top; the shorter way is widened to the picture's shape (X3D 4.1, 23.4.5).
glm::dmat4 orthographic(const DepthRange& range, glm::dvec4 field, double aspect) {
  if (!(field.x < field.z && field.y < field.w)) field = {-1, -1, 1, 1};
  const double width = field.z - field.x;
  const double height = field.w - field.y;
  const glm::dvec2 center(0.5 * (field.x + field.z), 0.5 * (field.y + field.w));
  const glm::dvec2 half(std::max(width, height * aspect) / 2, std::max(height, width / aspect) / 2);
  const bool any = range.low <= range.high;
  const double low = any ? range.low : 0.0;
  const double high = any ? range.high : 1.0;
  const double margin = std::max({high - low, std::abs(high), std::abs(low), 1e-30}) * (kMargin - 1);
  return glm::ortho(center.x - half.x, center.x + half.x, center.y - half.y, center.y + half.y, low - margin, high + margin);
}

double clamped_angle(double angle) {
  return angle > 0 ? std::clamp(angle, kSmallestAngle, kLargestAngle) : kDefaultFieldOfView;
}

/// By DEF name, else by index; none for what is neither.
std::optional<std::uint32_t> named_viewpoint(const PackedScene& scene, const std::string& wanted) {
  for (std::uint32_t i = 0; i < scene.viewpoints()->size(); ++i) {
    if (scene.viewpoints()->Get(i)->name()->string_view() == wanted) return i;
  }
  std::uint32_t index = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [stopped, error] = std::from_chars(wanted.data(), end, index);
  if (error == std::errc() && stopped == end && index < scene.viewpoints()->size()) return index;
  return std::nullopt;
}

void report_unknown_viewpoint(const PackedScene& scene, const std::string& wanted, Messages& messages) {
  if (wanted.empty() || named_viewpoint(scene, wanted)) return;
  const std::uint32_t count = scene.viewpoints()->size();
  const std::string shown = scene.bound_viewpoint() < 0 ? "the whole scene" : "the bound one";
  messages.add("no viewpoint `" + wanted + "`: " +
               (count == 0 ? "the scene has none, so the whole of it is shown"
                           : shown + " is shown; give a DEF name or an index below " + std::to_string(count)));
}

/// Out of range is as none.
std::int32_t viewpoint_bound_now(const PackedScene& scene, const Slots& slots) {
  if (scene.bound_viewpoint_now() == kNoSlot) return scene.bound_viewpoint();
  const double index = slots.number(scene.bound_viewpoint_now(), -1);
  return index >= 0 && index < scene.viewpoints()->size() ? static_cast<std::int32_t>(index) : -1;
}

/// In front of the scene by twice its mean size.
View view_of_whole(const Box& bounds) {
  const glm::dvec3 forward(0, 0, -1);
  const glm::dvec3 up(0, 1, 0);
  if (bounds.empty()) return look_along({0, 0, 10}, forward, up);
  const glm::dvec3 size = bounds.size();
  const double mean = (size.x + size.y + size.z) / 3;
  return look_along({bounds.center().x, bounds.center().y, bounds.max.z + 2 * mean}, forward, up);
}

/// In the space of the viewpoint's transform.
struct LookingWay {
  glm::dvec3 direction, up;
};

LookingWay looking_way(const PackedViewpoint& viewpoint, const Slots& slots) {
  const glm::dvec3 direction = slots.vector3(viewpoint.direction(), glm::dvec3(0));
  if (direction != glm::dvec3(0)) {
    const glm::dvec3 up = slots.vector3(viewpoint.up(), glm::dvec3(0));
    return {direction, up == glm::dvec3(0) ? glm::dvec3(0, 1, 0) : up};
  }
  const glm::dmat3 axes(rotation_matrix(slots.vector4(viewpoint.orientation(), {0, 0, 1, 0})));
  return {-axes[2], axes[1]};
}

}  // namespace

View look_along(const glm::dvec3& position, const glm::dvec3& direction, const glm::dvec3& up) {
  const glm::dvec3 forward = unit_or(direction, {0, 0, -1});
  const glm::dvec3 wished = unit_or(up, {0, 1, 0});
  const glm::dvec3 rest = wished - glm::dot(wished, forward) * forward;
  // Below this the remainder is rounding of two almost parallel vectors: its direction means nothing.
  const glm::dvec3 straight = glm::length(rest) > 1e-6 ? glm::normalize(rest) : any_orthogonal(forward);
  const glm::dvec3 right = glm::cross(forward, straight);
  const glm::dvec3 place = usable(position) ? position : glm::dvec3(0);
  View view;
  view.eye_to_world = glm::dmat4(glm::dvec4(right, 0), glm::dvec4(straight, 0), glm::dvec4(-forward, 0), glm::dvec4(place, 1));
  const glm::dmat4 turn = glm::dmat4(glm::transpose(glm::dmat3(view.eye_to_world)));
  view.world_to_eye = turn * glm::translate(glm::dmat4(1.0), -place);
  return view;
}

bool is_orthographic(const View& view) {
  return view.projection[3][3] == 1.0;
}

glm::dmat3 rotation_of(const glm::dmat4& matrix) {
  return glm::dmat3(look_along(glm::dvec3(0), -glm::dvec3(matrix[2]), glm::dvec3(matrix[1])).eye_to_world);
}

View view_from(const PackedViewpoint& viewpoint, const Slots& slots, const World& world, double aspect) {
  const glm::dmat4& place = world.at(viewpoint.transform()).matrix;
  const LookingWay way = looking_way(viewpoint, slots);
  const glm::dvec4 position = place * glm::dvec4(slots.vector3(viewpoint.position(), {0, 0, 10}), 1);
  View view = look_along(glm::dvec3(position), glm::dmat3(place) * way.direction, glm::dmat3(place) * way.up);
  const DepthRange range = depth_range(world, view);
  view.projection = viewpoint.orthographic()
                        ? orthographic(range, slots.vector4(viewpoint.field_of_view(), {-1, -1, 1, 1}), aspect)
                        : fitted_perspective(range, clamped_angle(slots.number(viewpoint.field_of_view(), kDefaultFieldOfView)),
                                             aspect, viewpoint.field_is_vertical());
  return view;
}

std::int32_t bound_viewpoint(const PackedScene& scene, const Slots& slots, const std::string& wanted) {
  if (scene.viewpoints()->size() == 0) return -1;
  const auto named = wanted.empty() ? std::nullopt : named_viewpoint(scene, wanted);
  return named ? static_cast<std::int32_t>(*named) : viewpoint_bound_now(scene, slots);
}

View view_of_world(const World& world, double aspect) {
  View view = view_of_whole(world.framed.empty() ? world.bounds : world.framed);
  view.projection = fitted_perspective(depth_range(world, view), kDefaultFieldOfView, aspect);
  return view;
}

View make_camera(const PackedScene& scene, const Slots& slots, const World& world, const std::string& wanted, double aspect,
                 Messages& messages) {
  report_unknown_viewpoint(scene, wanted, messages);
  const std::int32_t bound = bound_viewpoint(scene, slots, wanted);
  return bound < 0 ? view_of_world(world, aspect)
                   : view_from(*scene.viewpoints()->Get(static_cast<std::uint32_t>(bound)), slots, world, aspect);
}

}  // namespace plugc

#pragma once
// Simple polygons in a plane, with holes, cut into triangles.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace plugc {

/// Corners of one polygon that triangulate() takes, holes included; it answers larger ones with nothing.
inline constexpr std::size_t kMaxPolygonCorners = 4096;

/// Triangles as indices into `points`, counter-clockwise where the plane's y is up. The first ring is the outline, the others
/// are holes; ring i is points [ring_ends[i - 1], ring_ends[i]). Rings may run either way. Rings that cross themselves or
/// others give triangles of the right number and no particular shape.
/// `work_left`, where there is one, is what may be spent: corners times reflex corners. Where that does not do, nothing is
/// spent, and nothing is the answer.
std::vector<std::uint32_t> triangulate(std::span<const glm::dvec2> points, std::span<const std::uint32_t> ring_ends,
                                       std::uint64_t* work_left = nullptr);

/// Twice the area, positive when the ring runs counter-clockwise.
double signed_area(std::span<const glm::dvec2> ring);

}  // namespace plugc

// Ear clipping. The outline becomes a circular list that runs counter-clockwise. Each hole, the rightmost first, is joined to
// it by a bridge: a ray from the hole's rightmost point to the right hits an edge, and the visible corner nearest to that hit
// is entered twice, so that the list stays one ring. Then ears (convex corners whose triangle holds no reflex corner) are cut
// off. Cutting one ear changes only its two neighbours, so their state alone is computed anew: O(n * reflex corners) in all.
// kMaxPolygonCorners bounds that for one polygon, the caller for many. Where a full round finds no ear (the polygon crosses
// itself) the corner at hand is cut.

#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace plugc {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool inside_triangle(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

using Ring = std::vector<std::uint32_t>;  // indices of points, counter-clockwise for the outline, clockwise for holes

Ring ring_of(std::span<const glm::dvec2> points, std::uint32_t begin, std::uint32_t end, bool counter_clockwise) {
  Ring ring(end - begin);
  std::iota(ring.begin(), ring.end(), begin);
  if ((signed_area(points.subspan(begin, end - begin)) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

// Whether a line from corner `at` of the ring toward `to` starts inside the polygon.
bool opens_toward(std::span<const glm::dvec2> points, const Ring& ring, std::size_t at, const glm::dvec2& to) {
  const glm::dvec2 &before = points[ring[(at + ring.size() - 1) % ring.size()]], &corner = points[ring[at]],
                   &after = points[ring[(at + 1) % ring.size()]];
  const bool left_of_first = cross(before, corner, to) >= 0, left_of_second = cross(corner, after, to) >= 0;
  return cross(before, corner, after) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
}

// What the ray from a point to the right meets first: where, and the end of the edge there that lies farther right.
struct RayHit {
  glm::dvec2 point;
  std::size_t corner;  // place in the ring
};

std::optional<RayHit> hit_to_the_right(std::span<const glm::dvec2> points, const Ring& ring, const glm::dvec2& from) {
  std::optional<RayHit> hit;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    const glm::dvec2 &a = points[ring[i]], &b = points[ring[next]];
    if (a.y > from.y || b.y < from.y || a.y == b.y) continue;  // the inside lies to the left of an edge that goes up
    const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x >= from.x && (!hit || x < hit->point.x)) hit = RayHit{{x, from.y}, a.x > b.x ? i : next};
  }
  return hit;
}

// Where in `ring` a bridge from `from` may end. The end of the edge that the ray hits is seen unless corners lie in the
// triangle between; of those, the one nearest to the ray's direction is. Bridges made before repeat points, hence opens_toward.
std::optional<std::size_t> visible_corner(std::span<const glm::dvec2> points, const Ring& ring, const glm::dvec2& from) {
  const std::optional<RayHit> hit = hit_to_the_right(points, ring, from);
  if (!hit) return std::nullopt;
  const glm::dvec2 end = points[ring[hit->corner]];
  std::size_t best = hit->corner;
  double least_slope = std::numeric_limits<double>::infinity(), least_x = least_slope;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2& p = points[ring[i]];
    if (p.x <= from.x || p.x > std::max(hit->point.x, end.x)) continue;
    const bool inside = end.y > from.y ? inside_triangle(p, from, hit->point, end) : inside_triangle(p, from, end, hit->point);
    if (!inside || !opens_toward(points, ring, i, from)) continue;
    const double slope = std::abs(p.y - from.y) / (p.x - from.x);
    if (slope > least_slope || (slope == least_slope && p.x >= least_x)) continue;
    least_slope = slope;
    least_x = p.x;
    best = i;
  }
  return best;
}

// outline a b c, hole p q r, bridge b-p   ->   a b p q r p b c
void join_hole(std::span<const glm::dvec2> points, Ring& outline, Ring hole) {
  const auto rightmost =
      std::max_element(hole.begin(), hole.end(), [&points](auto a, auto b) { return points[a].x < points[b].x; });
  std::rotate(hole.begin(), rightmost, hole.end());
  const std::optional<std::size_t> corner = visible_corner(points, outline, points[hole[0]]);
  if (!corner) return;  // the hole lies outside
  hole.push_back(hole[0]);
  hole.push_back(outline[*corner]);
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(*corner) + 1, hole.begin(), hole.end());
}

Ring one_ring(std::span<const glm::dvec2> points, std::span<const std::uint32_t> ring_ends) {
  Ring outline = ring_of(points, 0, ring_ends[0], true);
  std::vector<Ring> holes;
  for (std::size_t i = 1; i < ring_ends.size(); ++i)
    if (ring_ends[i] - ring_ends[i - 1] >= 3) holes.push_back(ring_of(points, ring_ends[i - 1], ring_ends[i], false));
  const auto right_end = [&points](const Ring& ring) {
    double x = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : ring) x = std::max(x, points[i].x);
    return x;
  };
  std::stable_sort(holes.begin(), holes.end(), [&](const Ring& a, const Ring& b) { return right_end(a) > right_end(b); });
  for (Ring& hole : holes) join_hole(points, outline, std::move(hole));
  return outline;
}

class EarClipper {
 public:
  EarClipper(std::span<const glm::dvec2> points, Ring ring) : points_(points), ring_(std::move(ring)) {
    const std::size_t n = ring_.size();
    next_.resize(n);
    previous_.resize(n);
    reflex_.resize(n);
    ear_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    for (std::size_t i = 0; i < n; ++i) reflex_[i] = is_reflex(i);
    for (std::size_t i = 0; i < n; ++i)
      if (reflex_[i]) reflex_places_.push_back(i);
  }

  std::uint64_t work() const { return std::uint64_t{ring_.size()} * reflex_places_.size(); }

  std::vector<std::uint32_t> clip() {
    std::vector<std::uint32_t> triangles;
    if (ring_.size() < 3) return triangles;
    for (std::size_t i = 0; i < ring_.size(); ++i) ear_[i] = is_ear(i);
    std::size_t left = ring_.size(), at = 0, misses = 0;
    while (left > 3) {
      if (!ear_[at] && misses++ < left) {
        at = next_[at];
        continue;
      }
      misses = 0;
      cut(at, triangles);
      --left;
      at = next_[next_[at]];  // not the neighbour, which would make a fan of slivers
    }
    cut(at, triangles);
    return triangles;
  }

 private:
  const glm::dvec2& point(std::size_t place) const { return points_[ring_[place]]; }

  bool is_reflex(std::size_t i) const { return cross(point(previous_[i]), point(i), point(next_[i])) <= 0; }

  bool is_ear(std::size_t i) const {
    if (reflex_[i]) return false;
    const glm::dvec2 &a = point(previous_[i]), &b = point(i), &c = point(next_[i]);
    return std::none_of(reflex_places_.begin(), reflex_places_.end(), [&](std::size_t other) {
      if (!reflex_[other]) return false;
      const glm::dvec2& p = point(other);
      return p != a && p != b && p != c && inside_triangle(p, a, b, c);
    });
  }

  void update(std::size_t i) {
    if (reflex_[i]) reflex_[i] = is_reflex(i);  // cutting ears never makes a convex corner reflex
    ear_[i] = is_ear(i);
  }

  void cut(std::size_t i, std::vector<std::uint32_t>& triangles) {
    const std::size_t before = previous_[i], after = next_[i];
    triangles.insert(triangles.end(), {ring_[before], ring_[i], ring_[after]});
    next_[before] = after;
    previous_[after] = before;
    reflex_[i] = false;
    update(before);
    update(after);
  }

  std::span<const glm::dvec2> points_;
  Ring ring_;
  std::vector<std::size_t> next_, previous_;
  std::vector<std::uint8_t> reflex_, ear_;
  std::vector<std::size_t> reflex_places_;  // once reflex; those that no longer are, are passed over
};

}  // namespace

double signed_area(std::span<const glm::dvec2> ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

std::vector<std::uint32_t> triangulate(std::span<const glm::dvec2> points, std::span<const std::uint32_t> ring_ends,
                                       std::uint64_t* work_left) {
  if (ring_ends.empty() || ring_ends[0] < 3 || points.size() > kMaxPolygonCorners) return {};
  EarClipper clipper(points, one_ring(points, ring_ends));
  if (work_left != nullptr) {
    if (clipper.work() > *work_left) return {};
    *work_left -= clipper.work();
  }
  return clipper.clip();
}

}  // namespace plugc

// Newell's teapot: bicubic Bézier patches. The round parts (rim, body, lid, bottom) are profiles, each turned by four quarter
// patches whose inner control points lie at 0.56 of the radius, as Newell drew them; handle and spout are half tubes, mirrored.
// The published numbers have z up; here y is up and the spout points to +x. Each patch becomes a grid of kSegments squared
// quads with the true normals of the surface; where an edge of a patch shrinks to a point, the normal is taken beside it.
// Vertices that patches share are welded. The pot is moved to the centre and each axis scaled by size / 3, where 3 is the
// width from handle to spout of a pot of the default size. Texture: as IndexedFaceSet's default, 18.2.3 and 13.3.6.

#include <array>
#include <cmath>
#include <span>
#include <unordered_map>

#include "base/box_texture.h"
#include "mesh/geometry.h"

namespace plugc {

namespace {

constexpr int kSegments = 7;

using Patch = std::array<std::array<glm::dvec3, 4>, 4>;  // [v][u]

struct ProfilePoint {
  double radius, height;
};
using Profile = std::array<ProfilePoint, 4>;

// Downward along the outside, outward along the lid.
constexpr std::array<Profile, 6> kProfiles = {{
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},  // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}},                // body
    {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},
    {{{0, 3.15}, {0.8, 3.15}, {0, 2.85}, {0.2, 2.7}}},     // lid: knob
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},  // lid
    {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}}},     // bottom
}};

// A half ring of a tube: from the inner point out to `width`, across, and back to the outer point.
struct TubeRing {
  double inner_x, inner_height;
  double outer_x, outer_height;
  double width;
};
using Tube = std::array<TubeRing, 4>;

constexpr std::array<Tube, 4> kTubes = {{
    // handle
    {{{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3}, {-2.7, 2.025, -3, 2.25, 0.3}, {-2.7, 1.8, -3, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3, 1.8, 0.3}, {-2.7, 1.575, -3, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3}, {-2, 0.9, -1.9, 0.6, 0.3}}},
    // spout
    {{{1.7, 1.425, 1.7, 0.6, 0.66}, {2.6, 1.425, 3.1, 0.825, 0.66}, {2.3, 2.1, 2.4, 2.025, 0.25}, {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

Patch quarter_patch(const Profile& profile, int quarter) {
  constexpr double kBow = 0.56;
  constexpr std::array<glm::dvec2, 4> kArc = {{{1, 0}, {1, kBow}, {kBow, 1}, {0, 1}}};
  Patch patch;
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t u = 0; u < 4; ++u) {
      glm::dvec2 p = kArc[u] * profile[v].radius;
      for (int turn = 0; turn < quarter; ++turn) p = {-p.y, p.x};
      patch[v][u] = {p.x, profile[v].height, p.y};
    }
  }
  return patch;
}

Patch half_tube_patch(const Tube& tube, double side) {
  Patch patch;
  for (std::size_t v = 0; v < 4; ++v) {
    const TubeRing& ring = tube[v];
    const double z = side * ring.width;
    patch[v] = {{{ring.inner_x, ring.inner_height, 0},
                 {ring.inner_x, ring.inner_height, z},
                 {ring.outer_x, ring.outer_height, z},
                 {ring.outer_x, ring.outer_height, 0}}};
  }
  return patch;
}

using Weights = std::array<double, 4>;

Weights bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Weights bernstein_slope(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

glm::dvec3 blend(const Patch& patch, const Weights& u, const Weights& v) {
  glm::dvec3 sum{0};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) sum += patch[i][j] * (v[i] * u[j]);
  return sum;
}

glm::dvec3 normal_at(const Patch& patch, double u, double v) {
  glm::dvec3 normal =
      glm::cross(blend(patch, bernstein_slope(u), bernstein(v)), blend(patch, bernstein(u), bernstein_slope(v)));
  if (glm::length(normal) < 1e-9) {  // an edge shrunk to a point
    const double inner_u = u + (0.5 - u) * 1e-3, inner_v = v + (0.5 - v) * 1e-3;
    normal = glm::cross(blend(patch, bernstein_slope(inner_u), bernstein(inner_v)),
                        blend(patch, bernstein(inner_u), bernstein_slope(inner_v)));
  }
  return glm::normalize(normal);
}

class PotBuilder {
 public:
  Mesh mesh;

  // `facing` is +1 where du x dv points outside, -1 where inside.
  void add_patch(const Patch& patch, double facing) {
    std::array<std::array<std::uint32_t, kSegments + 1>, kSegments + 1> grid;
    for (int i = 0; i <= kSegments; ++i)
      for (int j = 0; j <= kSegments; ++j) grid[i][j] = add_vertex(patch, double(j) / kSegments, double(i) / kSegments, facing);
    for (int i = 0; i < kSegments; ++i) {
      for (int j = 0; j < kSegments; ++j) {
        add_triangle(grid[i][j], grid[i][j + 1], grid[i + 1][j + 1], facing);
        add_triangle(grid[i][j], grid[i + 1][j + 1], grid[i + 1][j], facing);
      }
    }
  }

 private:
  std::uint32_t add_vertex(const Patch& patch, double u, double v, double facing) {
    const glm::dvec3 position = blend(patch, bernstein(u), bernstein(v));
    const auto [place, is_new] = welded_.try_emplace(weld_key(position), static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.emplace_back(position);
      mesh.normals.emplace_back(normal_at(patch, u, v) * facing);
    }
    return place->second;
  }

  // Equal for points that agree to a ten-thousandth; the pot is less than 7 wide.
  static std::uint64_t weld_key(const glm::dvec3& p) {
    const glm::dvec3 cell = glm::round((p + 8.0) * 1e4);
    return (std::uint64_t(cell.x) << 40) | (std::uint64_t(cell.y) << 20) | std::uint64_t(cell.z);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, double facing) {
    if (a == b || b == c || c == a) return;
    if (facing < 0) std::swap(b, c);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  }

  std::unordered_map<std::uint64_t, std::uint32_t> welded_;
};

Mesh newell_pot() {
  PotBuilder builder;
  for (const Profile& profile : kProfiles)
    for (int quarter = 0; quarter < 4; ++quarter) builder.add_patch(quarter_patch(profile, quarter), 1);
  for (const Tube& tube : kTubes)
    for (const double side : {1.0, -1.0}) builder.add_patch(half_tube_patch(tube, side), side);
  return std::move(builder.mesh);
}

void fit(Mesh& mesh, const glm::vec3& size) {
  const Box3 box = box_of(mesh.positions);
  const glm::vec3 center = (box.low + box.high) / 2.0f;
  const glm::vec3 scale = size / (box.high.x - box.low.x);
  for (glm::vec3& position : mesh.positions) position = (position - center) * scale;
  for (glm::vec3& normal : mesh.normals) {
    normal /= scale;
    const float length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::vec3(0, 1, 0);
  }
}

}  // namespace

std::optional<Mesh> make_teapot(const GeometrySource& source) {
  Mesh mesh = newell_pot();
  fit(mesh, glm::vec3(source.graph.vec3(source.node, "size")));
  mesh.tex_coords = {box_texture(mesh.positions)};
  mesh.solid = source.graph.boolean(source.node, "solid");
  return mesh;
}

}  // namespace plugc

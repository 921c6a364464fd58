// Sky and ground are stops of colour at angles, the sky's from the zenith, the ground's from the nadir. Each stop is a ring,
// and between two rings lies one belt, along which the colour is linear in the distance, not in the angle: the reference engine
// has it so. Beyond its last stop the sky keeps its colour, and the ground is not there; drawn after the sky, it lies over it.

#include "mesh/backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSlices = 64;        // the middle of a chord hangs a tenth of a degree low: a pixel of 800 for 90 degrees
constexpr double kWidestBelt = 3;  // one of half a circle would pass through the eye

struct Stop {
  double angle;  // from the zenith
  glm::vec4 color;
};

/// The first colour at 0, each further one at its angle, as far as there are both. An angle that is less than the one
/// before counts as that one.
std::vector<Stop> read_stops(const NodeGraph& graph, NodeId background, std::string_view colors, std::string_view angles) {
  const auto values = graph.field(background, colors).numbers;
  const auto written = graph.field(background, angles).numbers;
  const std::size_t count = std::min(values.size() / 3, written.size() + 1);
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < count; ++i) {
    const auto part = [&](std::size_t k) { return static_cast<float>(std::clamp(values[3 * i + k], 0.0, 1.0)); };
    double angle = i == 0 ? 0.0 : stops.back().angle;
    if (i > 0 && written[i - 1] > angle) angle = std::min(written[i - 1], kPi);
    stops.push_back({angle, {part(0), part(1), part(2), 1}});
  }
  return stops;
}

/// From the zenith to the nadir; none for one colour alone, with which the picture is cleared.
std::vector<Stop> sky_stops(const NodeGraph& graph, NodeId background) {
  std::vector<Stop> stops = read_stops(graph, background, "skyColor", "skyAngle");
  if (stops.size() < 2) return {};
  stops.push_back({kPi, stops.back().color});
  return stops;
}

/// From the edge of the ground to the nadir.
std::vector<Stop> ground_stops(const NodeGraph& graph, NodeId background) {
  std::vector<Stop> stops = read_stops(graph, background, "groundColor", "groundAngle");
  for (Stop& stop : stops) stop.angle = kPi - stop.angle;
  std::ranges::reverse(stops);
  return stops;
}

void add_ring(Mesh& mesh, const Stop& stop) {
  const double out = std::sin(stop.angle);
  for (int i = 0; i < kSlices; ++i) {
    const double around = 2 * kPi * i / kSlices;
    mesh.positions.emplace_back(out * std::sin(around), std::cos(stop.angle), out * std::cos(around));
    mesh.colors.push_back(stop.color);
  }
}

/// The belt between the last two rings, its front to the eye.
void add_belt(Mesh& mesh) {
  const auto below = static_cast<std::uint32_t>(mesh.positions.size()) - kSlices;
  const std::uint32_t above = below - kSlices;
  for (std::uint32_t i = 0; i < kSlices; ++i) {
    const std::uint32_t next = (i + 1) % kSlices;
    mesh.indices.insert(mesh.indices.end(), {above + i, below + next, below + i, above + i, above + next, below + next});
  }
}

int belts_between(const Stop& above, const Stop& below) {
  return static_cast<int>(std::ceil((below.angle - above.angle) / kWidestBelt));
}

std::size_t count_rings(const std::vector<Stop>& stops) {
  std::size_t rings = 0;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    rings += static_cast<std::size_t>(belts_between(stops[i], stops[i + 1])) + 1;
  return rings;
}

void add_stops(Mesh& mesh, const std::vector<Stop>& stops) {
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const Stop &above = stops[i], &below = stops[i + 1];
    const int belts = belts_between(above, below);
    if (belts == 0) continue;  // a sudden change of colour
    add_ring(mesh, above);
    for (int k = 1; k <= belts; ++k) {
      const double share = static_cast<double>(k) / belts;
      add_ring(mesh,
               {std::lerp(above.angle, below.angle, share), glm::mix(above.color, below.color, static_cast<float>(share))});
      add_belt(mesh);
    }
  }
}

std::optional<Mesh> make_gradient(const NodeGraph& graph, NodeId background, Diagnostics& diagnostics) {
  const std::vector<Stop> sky = sky_stops(graph, background);
  const std::vector<Stop> ground = ground_stops(graph, background);
  const std::size_t vertices = (count_rings(sky) + count_rings(ground)) * kSlices;
  if (vertices > kMaxMeshVertices) {
    diagnostics.report(DiagnosticId::geometry_limit, graph[background].type_span,
                       fmt::format("the colours of this `{}` make {} vertices; plugc takes at most {}",
                                   graph[background].info->name, vertices, kMaxMeshVertices));
    return std::nullopt;
  }
  Mesh mesh;
  mesh.solid = false;
  add_stops(mesh, sky);
  add_stops(mesh, ground);
  return mesh;
}

struct Side {
  ScenePart part;
  glm::vec3 right, up;  // of the picture, as the eye sees it
};

constexpr std::array<Side, 6> kSides = {{{ScenePart::back, {-1, 0, 0}, {0, 1, 0}},
                                         {ScenePart::bottom, {1, 0, 0}, {0, 0, -1}},
                                         {ScenePart::front, {1, 0, 0}, {0, 1, 0}},
                                         {ScenePart::left, {0, 0, -1}, {0, 1, 0}},
                                         {ScenePart::right, {0, 0, 1}, {0, 1, 0}},
                                         {ScenePart::top, {1, 0, 0}, {0, 0, 1}}}};

Mesh make_side(const Side& side) {
  Mesh mesh;
  mesh.solid = false;
  const glm::vec3 middle = glm::cross(side.up, side.right);  // away from the eye
  mesh.tex_coords.resize(1);
  for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
    mesh.positions.push_back(middle + (2 * corner.x - 1) * side.right + (2 * corner.y - 1) * side.up);
    mesh.tex_coords[0].emplace_back(corner, 0, 1);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

}  // namespace

std::optional<Mesh> make_backdrop_mesh(const NodeGraph& graph, NodeId background, ScenePart part, Diagnostics& diagnostics) {
  if (part == ScenePart::gradient) return make_gradient(graph, background, diagnostics);
  return make_side(*std::ranges::find(kSides, part, &Side::part));
}

}  // namespace plugc

// One table from node type to the function that makes its mesh, and what holds for every mesh whatever made it: no more
// vertices than the limit, no coordinate that is not a finite number, at least something to draw.

#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "mesh/geometry.h"

namespace plugc {

namespace {

struct Maker {
  std::string_view type;
  std::optional<Mesh> (*make)(const GeometrySource&);
};

constexpr Maker kMakers[] = {
    {"Box", make_box},
    {"Sphere", make_sphere},
    {"Cone", make_cone},
    {"Cylinder", make_cylinder},
    {"Rectangle2D", make_rectangle},
    {"Plane", make_rectangle},
    {"Teapot", make_teapot},
    {"IndexedFaceSet", make_indexed_face_set},
    {"ElevationGrid", make_elevation_grid},
    {"TriangleSet", make_triangles},
    {"TriangleStripSet", make_triangles},
    {"TriangleFanSet", make_triangles},
    {"QuadSet", make_triangles},
    {"IndexedTriangleSet", make_triangles},
    {"IndexedTriangleStripSet", make_triangles},
    {"IndexedTriangleFanSet", make_triangles},
    {"IndexedQuadSet", make_triangles},
    {"IndexedLineSet", make_lines},
    {"LineSet", make_lines},
    {"PointSet", make_points},
    {"Text", make_text},
    {"Text3D", make_text},
    {"Extrusion", make_extrusion},
    {"Arc2D", make_arc},
    {"Circle2D", make_arc},
    {"ArcClose2D", make_closed_arc},
    {"Disk2D", make_disk},
    {"Polyline2D", make_polyline},
    {"Polypoint2D", make_polypoint},
    {"TriangleSet2D", make_triangle_set_2d},
};

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// What the maker left: drawable, or reported and nothing.
std::optional<Mesh> checked(std::optional<Mesh> mesh, const GeometrySource& source) {
  if (!mesh) return mesh;
  if (mesh->positions.size() > kMaxMeshVertices) {
    source.report(DiagnosticId::geometry_limit, fmt::format("this `{}` has {} vertices; plugc takes at most {}", source.type(),
                                                            mesh->positions.size(), kMaxMeshVertices));
    return std::nullopt;
  }
  if (!std::all_of(mesh->positions.begin(), mesh->positions.end(), is_finite)) {
    source.report(DiagnosticId::geometry_invalid,
                  fmt::format("this `{}` has sizes that are not finite numbers", source.type()));
    return std::nullopt;
  }
  if (mesh->indices.empty()) {
    source.report(DiagnosticId::not_drawn, fmt::format("this `{}` is empty; nothing is drawn", source.type()));
    return std::nullopt;
  }
  return mesh;
}

}  // namespace

std::optional<Mesh> make_mesh(const NodeGraph& graph, NodeId geometry, Diagnostics& diagnostics,
                              std::span<const VertexField> changing) {
  if (!graph.is(geometry, "X3DGeometryNode")) return std::nullopt;  // reported as misplaced
  const GeometrySource source{graph, geometry, diagnostics, changing};
  const auto* maker = std::ranges::find(kMakers, source.type(), &Maker::type);
  if (maker == std::end(kMakers)) {
    source.report(DiagnosticId::not_drawn, fmt::format("plugc does not draw `{}`", source.type()));
    return std::nullopt;
  }
  return checked(maker->make(source), source);
}

}  // namespace plugc

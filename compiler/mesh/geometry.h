#pragma once
// The families of geometry nodes, one file each. make_mesh.cpp picks one by the node's type.

#include <optional>

#include "mesh/mesh.h"

namespace plugc {

/// Where a geometry node stands and where to complain about it.
struct GeometrySource {
  const NodeGraph& graph;
  NodeId node;
  Diagnostics& diagnostics;
  std::span<const VertexField> changing = {};  ///< Lists that events change.

  std::string_view type() const { return graph[node].info->name; }
  void report(DiagnosticId id, std::string_view field, std::string message) const {
    diagnostics.report(id, graph.field_span(node, field), std::move(message));
  }
  void report(DiagnosticId id, std::string message) const { diagnostics.report(id, graph[node].type_span, std::move(message)); }
};

// Each gives nullopt, without or with a diagnostic of its own, where there is nothing to draw.
std::optional<Mesh> make_box(const GeometrySource& source);
std::optional<Mesh> make_sphere(const GeometrySource& source);
std::optional<Mesh> make_cone(const GeometrySource& source);
std::optional<Mesh> make_cylinder(const GeometrySource& source);
std::optional<Mesh> make_rectangle(const GeometrySource& source);
std::optional<Mesh> make_teapot(const GeometrySource& source);
std::optional<Mesh> make_indexed_face_set(const GeometrySource& source);
std::optional<Mesh> make_elevation_grid(const GeometrySource& source);
std::optional<Mesh> make_triangles(const GeometrySource& source);  ///< Triangle and quad sets, strips and fans, indexed or not.
std::optional<Mesh> make_lines(const GeometrySource& source);      ///< IndexedLineSet, LineSet.
std::optional<Mesh> make_points(const GeometrySource& source);
std::optional<Mesh> make_text(const GeometrySource& source);
std::optional<Mesh> make_extrusion(const GeometrySource& source);
std::optional<Mesh> make_arc(const GeometrySource& source);         ///< Arc2D, Circle2D.
std::optional<Mesh> make_closed_arc(const GeometrySource& source);  ///< ArcClose2D.
std::optional<Mesh> make_disk(const GeometrySource& source);
std::optional<Mesh> make_polyline(const GeometrySource& source);
std::optional<Mesh> make_polypoint(const GeometrySource& source);
std::optional<Mesh> make_triangle_set_2d(const GeometrySource& source);

}  // namespace plugc

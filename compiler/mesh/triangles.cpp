// Triangle and quad sets, strips and fans (X3D 4.1, 11.4 and 32.4 for quads). Two questions tell the eight nodes apart: where
// the runs of coordinates come from (an `index`, cut at -1 for strips and fans; a count list; or all in order), and how a run
// becomes faces. Normals without a Normal node are smoothed over all faces that share a coordinate.

#include <numbers>

#include <fmt/format.h>

#include "mesh/face_reader.h"
#include "mesh/lists.h"

namespace plugc {

namespace {

using Run = std::vector<std::int64_t>;  // indices of coordinates

void add_polygons(FaceReader& reader, const Run& run, std::size_t corners) {
  for (std::size_t i = 0; i + corners <= run.size(); i += corners) reader.add_face(std::span(run).subspan(i, corners));
}

void add_strip(FaceReader& reader, const Run& run) {
  for (std::size_t i = 0; i + 2 < run.size(); ++i) {
    const bool odd = i % 2 == 1;
    const std::int64_t face[] = {run[i], run[odd ? i + 2 : i + 1], run[odd ? i + 1 : i + 2]};
    reader.add_face(face);
  }
}

void add_fan(FaceReader& reader, const Run& run) {
  for (std::size_t i = 1; i + 1 < run.size(); ++i) {
    const std::int64_t face[] = {run[0], run[i], run[i + 1]};
    reader.add_face(face);
  }
}

void add_run(FaceReader& reader, std::string_view type, const Run& run) {
  if (type.ends_with("StripSet")) return add_strip(reader, run);
  if (type.ends_with("FanSet")) return add_fan(reader, run);
  add_polygons(reader, run, type.ends_with("QuadSet") ? 4 : 3);
}

void add_indexed(FaceReader& reader, const GeometrySource& source) {
  Run run;
  for (const double index : source.graph.field(source.node, "index").numbers) {
    if (index >= 0) {
      run.push_back(static_cast<std::int64_t>(index));
      continue;
    }
    add_run(reader, source.type(), run);
    run.clear();
  }
  add_run(reader, source.type(), run);
}

void add_counted(FaceReader& reader, const GeometrySource& source, std::string_view count_field) {
  const auto available = static_cast<std::int64_t>(reader.faces.coords.size());
  std::int64_t next = 0;
  for (const double value : source.graph.field(source.node, count_field).numbers) {
    const auto count = static_cast<std::int64_t>(value);
    if (count < 3 || count > available - next) {
      source.report(count < 3 ? DiagnosticId::geometry_invalid : DiagnosticId::geometry_index, count_field,
                    fmt::format("`{}` holds {}, but {} points are left in `coord` and a run needs 3; what follows is left out",
                                count_field, count, available - next));
      return;
    }
    Run run;
    for (; static_cast<std::int64_t>(run.size()) < count; ++next) run.push_back(next);
    add_run(reader, source.type(), run);
  }
}

void add_in_order(FaceReader& reader, const GeometrySource& source) {
  Run run(reader.faces.coords.size());
  for (std::size_t i = 0; i < run.size(); ++i) run[i] = static_cast<std::int64_t>(i);
  add_run(reader, source.type(), run);
}

}  // namespace

std::optional<Mesh> make_triangles(const GeometrySource& source) {
  FaceReader reader(source, read_coords(source));
  reader.faces.crease_angle = std::numbers::pi_v<float>;
  if (source.type().starts_with("Indexed"))
    add_indexed(reader, source);
  else if (source.type() == "TriangleStripSet")
    add_counted(reader, source, "stripCount");
  else if (source.type() == "TriangleFanSet")
    add_counted(reader, source, "fanCount");
  else
    add_in_order(reader, source);
  return mesh_of_faces(std::move(reader.faces), source);
}

}  // namespace plugc

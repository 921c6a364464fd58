// A corner's place in a list (X3D 4.1, 13.3.6; tangents as normals): per vertex, the entry of the index list beside coordIndex,
// or without one the coordinate's own index; per face, the face's entry of the index list, or without one the face's number.

#include "mesh/face_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "mesh/lists.h"

namespace plugc {

namespace {

bool boolean_or(const GeometrySource& source, std::string_view name, bool otherwise) {
  return source.graph.has_field(source.node, name) ? source.graph.boolean(source.node, name) : otherwise;
}

// The corners' `tex` serves all units, so the shortest list bounds it.
std::size_t tex_size(const std::vector<std::vector<glm::vec4>>& units) {
  std::size_t size = 0;
  for (const std::vector<glm::vec4>& unit : units)
    if (!unit.empty()) size = size == 0 ? unit.size() : std::min(size, unit.size());
  return size;
}

}  // namespace

FaceReader::FaceReader(const GeometrySource& source, std::vector<glm::vec3> coords) : source_(source) {
  ColorList colors = read_colors(source);
  faces.coords = std::move(coords);
  faces.normals = read_normals(source);
  faces.tangents = read_tangents(source);
  faces.colors = std::move(colors.colors);
  faces.colors_have_alpha = colors.have_alpha;
  faces.tex_units = read_tex_units(source);
  faces.fog_coords = read_fog_coords(source, faces.coords.size());
  faces.attributes = read_attributes(source, faces.coords.size());
  faces.lists = read_list_slots(source);
  faces.normal_per_vertex = boolean_or(source, "normalPerVertex", true);
  faces.ccw = boolean_or(source, "ccw", true);
  faces.solid = boolean_or(source, "solid", true);
  faces.convex = boolean_or(source, "convex", true);
  coord_ =
      channel("coord", source.graph.has_field(source.node, "coordIndex") ? "coordIndex" : "index", "", faces.coords.size());
  normal_ = channel("normal", "normalIndex", "normalPerVertex", faces.normals.size());
  tangent_ = channel("tangent", "normalIndex", "normalPerVertex", faces.tangents.size());
  color_ = channel("color", "colorIndex", "colorPerVertex", faces.colors.size());
  tex_ = channel("texCoord", "texCoordIndex", "", tex_size(faces.tex_units));
}

FaceReader::Channel FaceReader::channel(std::string_view field, std::string_view index_field, std::string_view per_vertex_field,
                                        std::size_t size) const {
  Channel result{.field = field, .size = size};
  if (source_.graph.has_field(source_.node, index_field)) {
    result.index_field = index_field;
    result.index = source_.graph.field(source_.node, index_field).numbers;
  }
  if (!per_vertex_field.empty()) result.per_vertex = boolean_or(source_, per_vertex_field, true);
  return result;
}

void FaceReader::add_face(std::span<const std::int64_t> coord_indices, std::size_t position) {
  ++faces_seen_;
  if (coord_indices.size() < 3) return;
  if (faces.corners.size() + coord_indices.size() > kMaxMeshVertices) {
    if (!reported_limit_)
      source_.report(DiagnosticId::geometry_limit,
                     fmt::format("this `{}` has more than {} corners; plugc takes no more", source_.type(), kMaxMeshVertices));
    reported_limit_ = true;
    return;
  }
  face_.clear();
  for (std::size_t i = 0; i < coord_indices.size(); ++i) {
    if (!is_usable(coord_indices[i])) return;
    Corner corner{.coord = static_cast<std::uint32_t>(coord_indices[i])};
    if (!find(normal_, coord_indices[i], position + i, corner.normal) ||
        !find(tangent_, coord_indices[i], position + i, corner.tangent) ||
        !find(color_, coord_indices[i], position + i, corner.color) || !find(tex_, coord_indices[i], position + i, corner.tex))
      return;
    face_.push_back(corner);
  }
  faces.add_face(face_);
}

bool FaceReader::is_usable(std::int64_t coord) {
  if (coord < 0 || static_cast<std::size_t>(coord) >= coord_.size) {
    report_index(coord_, coord);
    return false;
  }
  const glm::vec3& point = faces.coords[static_cast<std::size_t>(coord)];
  if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) return true;
  if (!reported_not_finite_)
    source_.report(DiagnosticId::geometry_invalid, "coord",
                   fmt::format("point {} of `coord` is not finite; the faces that use it are left out", coord));
  reported_not_finite_ = true;
  return false;
}

bool FaceReader::find(Channel& channel, std::int64_t coord, std::size_t position, std::uint32_t& result) {
  if (channel.size == 0) return true;
  const std::size_t place = channel.per_vertex ? position : faces_seen_ - 1;
  std::int64_t index = channel.per_vertex ? coord : static_cast<std::int64_t>(place);
  if (!channel.index.empty()) {
    if (place >= channel.index.size()) {
      if (!channel.reported)
        source_.report(DiagnosticId::geometry_invalid, channel.index_field,
                       fmt::format("`{}` has {} entries, too few for the faces; those without are left out",
                                   channel.index_field, channel.index.size()));
      channel.reported = true;
      return false;
    }
    index = static_cast<std::int64_t>(channel.index[place]);
  }
  if (index < 0 || static_cast<std::size_t>(index) >= channel.size) {
    report_index(channel, index);
    return false;
  }
  result = static_cast<std::uint32_t>(index);
  return true;
}

void FaceReader::report_index(Channel& channel, std::int64_t index) {
  if (channel.reported) return;
  channel.reported = true;
  if (channel.index.empty()) {
    source_.report(DiagnosticId::geometry_invalid, channel.field,
                   fmt::format("`{}` has {} entries, but entry {} is needed; the faces that need more are left out",
                               channel.field, channel.size, index));
    return;
  }
  source_.report(DiagnosticId::geometry_index, channel.index_field,
                 fmt::format("`{}` holds {}, but `{}` has {} entries; faces with such an index are left out",
                             channel.index_field, index, channel.field, channel.size));
}

}  // namespace plugc

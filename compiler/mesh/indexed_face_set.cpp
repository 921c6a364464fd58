// IndexedFaceSet (X3D 4.1, 13.3.6): coordIndex is cut at each -1 into faces; the other index lists run beside it.

#include "mesh/face_reader.h"
#include "mesh/lists.h"

namespace plugc {

std::optional<Mesh> make_indexed_face_set(const GeometrySource& source) {
  FaceReader reader(source, read_coords(source));
  reader.faces.crease_angle = static_cast<float>(source.graph.number(source.node, "creaseAngle"));
  const std::span<const double> indices = source.graph.field(source.node, "coordIndex").numbers;
  std::vector<std::int64_t> face;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= indices.size(); ++i) {
    if (i < indices.size() && indices[i] >= 0) {
      face.push_back(static_cast<std::int64_t>(indices[i]));
      continue;
    }
    if (!face.empty()) reader.add_face(face, begin);
    face.clear();
    begin = i + 1;
  }
  return mesh_of_faces(std::move(reader.faces), source);
}

}  // namespace plugc

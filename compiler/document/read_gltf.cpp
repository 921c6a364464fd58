// Nodes become Transforms, inside of which stand their mesh, camera, light and children. glTF wants a strict tree, so a node
// that is reached twice (a second parent, or a circle) is a mistake and is passed over the second time.
//
//     {"name": "Lamp", "translation": [0, 1, 0], "mesh": 2}   ->   DEF Lamp Transform { translation 0 1 0 children USE Bulb }

#include "document/read_gltf.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/gltf_reader.h"
#include "document/read_document.h"

namespace plugc {
namespace {

using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Axis and angle of a unit quaternion x y z w.
std::array<double, 4> axis_and_angle(double x, double y, double z, double w) {
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return {0, 0, 1, 0};
  return {x / length, y / length, z / length, 2 * std::atan2(length, w)};
}

/// The same of three orthogonal columns of length 1, right-handed.
std::array<double, 4> axis_and_angle(const std::array<Vector3, 3>& c) {
  const auto [x, y, z] = c;
  const double trace = x[0] + y[1] + z[2];
  if (trace > 0) return axis_and_angle(y[2] - z[1], z[0] - x[2], x[1] - y[0], 1 + trace);
  if (x[0] >= y[1] && x[0] >= z[2]) return axis_and_angle(1 + x[0] - y[1] - z[2], x[1] + y[0], z[0] + x[2], y[2] - z[1]);
  if (y[1] >= z[2]) return axis_and_angle(x[1] + y[0], 1 + y[1] - x[0] - z[2], y[2] + z[1], z[0] - x[2]);
  return axis_and_angle(z[0] + x[2], y[2] + z[1], 1 + z[2] - x[0] - y[1], x[1] - y[0]);
}

}  // namespace

Span GltfReader::place(GltfAt object, std::string_view member) const {
  const GltfAt found = file_.text.member(object, member);
  return file_.text.place(found.valid() ? found : object);
}

void GltfReader::read() {
  const std::size_t mark = file_.build.nodes.open();
  for (const int root : root_nodes()) node(root, 0);
  write_.end_document(mark);
  report_unread();
}

std::vector<int> GltfReader::root_nodes() {
  const tinygltf::Model& model = file_.model;
  if (!model.scenes.empty()) {
    const bool known = model.defaultScene >= 0 && static_cast<std::size_t>(model.defaultScene) < model.scenes.size();
    return model.scenes[known ? static_cast<std::size_t>(model.defaultScene) : 0].nodes;
  }
  std::vector<bool> is_child(model.nodes.size());
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

void GltfReader::node(int index, std::uint32_t depth) {
  const GltfAt at = file_.item("nodes", index);
  if (depth >= kMaxNesting) return file_.build.too_deep(file_.text.place(at));
  if (!visited_.insert(index).second) {
    return file_.text.mistake(at, "this node has two parents, or contains itself; it is read once");
  }
  const tinygltf::Node& node = file_.model.nodes[static_cast<std::size_t>(index)];
  const Name def = node.name.empty() ? Name() : write_.define(node.name, "", place(at, "name"));
  write_.node("Transform", def, file_.text.place(at), [&] {
    transform(node, at);
    write_.nodes("children", file_.text.place(at), [&] {
      if (node.mesh >= 0) mesh(node.mesh, place(at, "mesh"));
      if (node.camera >= 0) camera(node.camera, place(at, "camera"));
      light(node, at);
      for (const int child : node.children) this->node(child, depth + 1);
    });
  });
}

void GltfReader::transform(const tinygltf::Node& node, GltfAt at) {
  if (!node.matrix.empty()) return matrix(node.matrix, file_.text.member(at, "matrix"));
  if (!node.translation.empty()) write_.numbers("translation", node.translation, place(at, "translation"));
  if (!node.rotation.empty()) {
    const std::vector<double>& q = node.rotation;
    write_.numbers("rotation", axis_and_angle(q[0], q[1], q[2], q[3]), place(at, "rotation"));
  }
  if (!node.scale.empty()) write_.numbers("scale", node.scale, place(at, "scale"));
}

/// A matrix of glTF is a translation, a rotation and a scale multiplied (3.5.3); each column of a rotation and scale has the
/// scale as its length, and a mirrored one points the other way.
void GltfReader::matrix(const std::vector<double>& m, GltfAt at) {
  constexpr double kSkew = 1e-3;
  const Span span = file_.text.place(at);
  std::array<Vector3, 3> columns;
  Vector3 scale;
  for (std::size_t i = 0; i < 3; ++i) {
    columns[i] = {m[4 * i], m[4 * i + 1], m[4 * i + 2]};
    scale[i] = std::sqrt(dot(columns[i], columns[i]));
    if (!(scale[i] > 0)) columns[i] = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    for (double& component : columns[i]) component /= scale[i] > 0 ? scale[i] : 1;
  }
  const auto& [x, y, z] = columns;
  const bool skewed = std::abs(dot(x, y)) > kSkew || std::abs(dot(y, z)) > kSkew || std::abs(dot(z, x)) > kSkew;
  const bool flat = scale[0] == 0 || scale[1] == 0 || scale[2] == 0;
  if ((skewed && !flat) || m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
    file_.text.mistake(at,
                       "this matrix is no product of a translation, a rotation and a scale; it is drawn as the nearest one");
  }
  const Vector3 cross = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  if (dot(cross, z) < 0) {
    scale[0] = -scale[0];
    for (double& component : columns[0]) component = -component;
  }
  write_.numbers("translation", {m[12], m[13], m[14]}, span);
  write_.numbers("rotation", axis_and_angle(columns), span);
  write_.numbers("scale", scale, span);
}

void GltfReader::mesh(int index, const Span& place) {
  const GltfAt at = file_.item("meshes", index);
  if (file_.is_refused(at)) return;
  if (const auto known = meshes_.find(index); known != meshes_.end()) return write_.use(known->second, place);
  const tinygltf::Mesh& mesh = file_.model.meshes[static_cast<std::size_t>(index)];
  const GltfAt primitives = file_.text.member(at, "primitives");
  const Name& def = meshes_[index] = write_.define(mesh.name, fmt::format("mesh_{}", index), this->place(at, "name"));
  write_.node("Group", def, file_.text.place(at), [&] {
    write_.nodes("children", file_.text.place(primitives), [&] {
      for (std::size_t i = 0; i < mesh.primitives.size(); ++i) shape(mesh.primitives[i], file_.text.item(primitives, i));
    });
  });
}

void GltfReader::report_unread() {
  const auto note = [&](GltfAt at, std::string_view message) {
    if (file_.text.size(at) == 0) return;
    file_.build.diagnostics.report(DiagnosticId::not_drawn, file_.text.place(at), std::string(message));
  };
  const GltfAt root = file_.text.root();
  note(file_.text.member(root, "animations"), "animations of glTF are not read; the model stands still");
  note(file_.text.member(root, "skins"), "skins of glTF are not read; the meshes stand as they were modelled");
  const GltfAt meshes = file_.text.member(root, "meshes");
  for (std::size_t i = 0; i < file_.model.meshes.size(); ++i) {
    const auto& primitives = file_.model.meshes[i].primitives;
    const auto morphs = std::ranges::find_if(primitives, [](const auto& one) { return !one.targets.empty(); });
    if (morphs == primitives.end()) continue;
    const GltfAt list = file_.text.member(file_.text.item(meshes, i), "primitives");
    const GltfAt primitive = file_.text.item(list, static_cast<std::size_t>(morphs - primitives.begin()));
    return note(file_.text.member(primitive, "targets"), "morph targets of glTF are not read; meshes keep their first form");
  }
}

Document read_gltf(SourceId source, const std::filesystem::path& path, FileAccess& files, SourceSet& sources,
                   Diagnostics& diagnostics) {
  GltfInput input{source, {}, path};
  const std::string_view bytes = sources.text(source);
  if (bytes.starts_with("glTF")) {
    std::string problem;
    const auto chunks = split_glb(bytes, problem);
    if (!chunks) {
      diagnostics.report(DiagnosticId::gltf_invalid, {source, 0, 0}, std::move(problem));
      Document empty;
      empty.source = source;
      empty.encoding = Encoding::gltf;
      return empty;
    }
    input.binary = chunks->binary;
    input.source = sources.add(std::string(sources.name(source)), std::string(chunks->json));
  }
  GltfFile file(input, files, sources, diagnostics);
  file.build.document.version_major = 4;
  if (file.readable()) GltfReader(file).read();
  return std::move(file.build.document);
}

Document read_document(SourceId source, const std::filesystem::path& path, FileAccess& files, SourceSet& sources,
                       Diagnostics& diagnostics) {
  if (is_gltf(sources.text(source), path)) return read_gltf(source, path, files, sources, diagnostics);
  return read_document(source, sources, diagnostics);
}

}  // namespace plugc

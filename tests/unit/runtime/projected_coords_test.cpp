#include "runtime/projected_coords.h"

#include "test_scene.h"

namespace plugc {
namespace {

using test::kGreen;
using test::kRed;
using test::make_renderer;
using test::pixel;
using test::SceneBuilder;

/// Paints a mesh in the colour of that attribute of its vertices.
std::uint32_t paint_program(SceneBuilder& builder, const std::string& attribute) {
  const std::uint32_t program = builder.program(
      "#version 330 core\n"
      "in vec3 castle_Vertex;\n"
      "in vec3 " +
          attribute +
          ";\n"
          "uniform mat4 to_clip;\n"
          "out vec3 paint;\n"
          "void main() { paint = " +
          attribute + "; gl_Position = to_clip * vec4(castle_Vertex, 1.0); }\n",
      "#version 330 core\n"
      "in vec3 paint;\n"
      "out vec4 castle_FragColor;\n"
      "void main() { castle_FragColor = vec4(paint, 1.0); }\n",
      {{"to_clip", PackedUniformType::mat4}});
  auto custom = std::make_unique<PackedAttributeT>();
  custom->name = attribute;
  custom->semantic = PackedSemantic::custom;
  builder.package.programs[program]->attributes.push_back(std::move(custom));
  return program;
}

/// Three numbers, the same at each vertex, behind those that are there.
void add_attribute(PackedMeshT& mesh, const std::string& name, const std::array<float, 3>& value) {
  std::vector<std::uint8_t> vertices;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const auto vertex = mesh.vertices.begin() + static_cast<std::ptrdiff_t>(i * mesh.stride);
    vertices.insert(vertices.end(), vertex, vertex + static_cast<std::ptrdiff_t>(mesh.stride));
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(value.data());
    vertices.insert(vertices.end(), bytes, bytes + sizeof(value));
  }
  auto added = std::make_unique<PackedMeshAttributeT>();
  added->name = name;
  added->components = 3;
  added->offset = mesh.stride;
  mesh.attributes.push_back(std::move(added));
  mesh.vertices = std::move(vertices);
  mesh.stride += sizeof(value);
}

/// The two programs of a shape read attributes of their own at one place.
TEST(ProjectedCoords, LeaveToEachProgramItsOwnAttributes) {
  SceneBuilder builder;
  const std::uint32_t mesh = builder.square(1);
  add_attribute(*builder.package.meshes[mesh], "first", {1, 0, 0});
  add_attribute(*builder.package.meshes[mesh], "second", {0, 1, 0});
  const std::uint32_t shape = builder.flat_shape(mesh, paint_program(builder, "first"), {0, 0, 0, 1});
  builder.shape(shape).bindings.pop_back();
  builder.scene().projectors.push_back(std::make_unique<PackedViewpointT>());
  builder.shape(shape).projected_coords = {PackedBinding(0, 0, 0, 1, PackedSource::viewpoint_projector_matrix)};
  const std::uint32_t choice = builder.slot(PackedValueType::bool_, {1});
  builder.add_off_program(shape, PackedSwitch(choice, PackedSwitchKind::slot), paint_program(builder, "second"),
                          {PackedBinding(0, 0, 0, 1, PackedSource::model_view_projection_matrix)});
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  FrameOptions frame;
  frame.width = frame.height = 16;
  EXPECT_EQ(pixel(renderer->draw(frame), 8, 8), kRed);
  renderer->set_slot(choice, {0});
  EXPECT_EQ(pixel(renderer->draw(frame), 8, 8), kGreen);
  EXPECT_TRUE(renderer->messages().empty());
}

TEST(ProjectedCoords, ShareTheirMemory) {
  SceneBuilder builder;
  builder.square(1);  // of 6 vertices
  const LoadedPackage loaded = builder.pack();
  const PackedMesh& mesh = *loaded.package->meshes()->Get(0);
  ProjectedCoordsPool pool;
  pool.bytes_left = 3 * 6 * 16;
  Messages messages;
  const ProjectedCoords* const first = find_projected_coords(pool, {0, 0}, mesh, 2, messages);
  EXPECT_NE(first, nullptr);
  EXPECT_TRUE(messages.list().empty());
  EXPECT_EQ(find_projected_coords(pool, {1, 0}, mesh, 2, messages), nullptr);
  EXPECT_EQ(find_projected_coords(pool, {1, 0}, mesh, 2, messages), nullptr) << "asked again";
  EXPECT_NE(find_projected_coords(pool, {2, 0}, mesh, 1, messages), nullptr) << "there is place for less";
  EXPECT_EQ(find_projected_coords(pool, {0, 0}, mesh, 2, messages), first);
  EXPECT_EQ(messages.list().size(), 1U);
}

}  // namespace
}  // namespace plugc

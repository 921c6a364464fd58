#pragma once
// Packages built by hand, and pictures to ask questions of.

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "package/package_file.h"
#include "runtime/render.h"

namespace plugc::test {

using Rgb = std::array<int, 3>;

/// A package of one scene. Each add function returns the index of what it added.
class SceneBuilder {
 public:
  SceneBuilder() { package.scenes.push_back(std::make_unique<PackedSceneT>()); }

  PackedSceneT& scene() { return *package.scenes[0]; }
  PackedShapeT& shape(std::uint32_t index) { return *scene().shapes[index]; }
  PackedLightT& light(std::uint32_t index) { return *scene().lights[index]; }
  PackedShadowMapT& shadow_map(std::uint32_t index) { return *scene().shadow_maps[index]; }

  std::uint32_t slot(PackedValueType type, const std::vector<double>& values) {
    const auto first = static_cast<std::uint32_t>(scene().slot_values.size());
    scene().slot_values.insert(scene().slot_values.end(), values.begin(), values.end());
    const auto count = static_cast<std::uint32_t>(values.size()) / component_count(type);
    scene().slots.emplace_back(first, count, type);
    return static_cast<std::uint32_t>(scene().slots.size() - 1);
  }
  std::uint32_t number(double value) { return slot(PackedValueType::float_, {value}); }
  std::uint32_t vec3(double x, double y, double z) { return slot(PackedValueType::vec3, {x, y, z}); }
  std::uint32_t rotation(double x, double y, double z, double angle) {
    return slot(PackedValueType::rotation, {x, y, z, angle});
  }

  /// Positions only. Every three make a triangle.
  std::uint32_t mesh(const std::vector<std::array<float, 3>>& positions) {
    auto packed = std::make_unique<PackedMeshT>();
    packed->vertex_count = static_cast<std::uint32_t>(positions.size());
    packed->stride = sizeof(positions[0]);
    packed->streams.emplace_back(PackedSemantic::position, 0, 3, 0);
    packed->vertices.resize(positions.size() * packed->stride);
    if (!positions.empty()) std::memcpy(packed->vertices.data(), positions.data(), packed->vertices.size());
    std::array<double, 3> low = {1, 1, 1};
    std::array<double, 3> high = {-1, -1, -1};
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
      packed->indices.push_back(i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = positions[i][axis];
        low[axis] = i == 0 ? value : std::min(low[axis], value);
        high[axis] = i == 0 ? value : std::max(high[axis], value);
      }
    }
    packed->bounds_min = std::make_unique<PackedVec3>(low[0], low[1], low[2]);
    packed->bounds_max = std::make_unique<PackedVec3>(high[0], high[1], high[2]);
    package.meshes.push_back(std::move(packed));
    return static_cast<std::uint32_t>(package.meshes.size() - 1);
  }
  /// A square in the plane z = 0, facing +z.
  std::uint32_t square(float half, float z = 0) {
    return mesh({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, -half, z}, {half, half, z}, {-half, half, z}});
  }

  struct Uniform {
    std::string name;
    PackedUniformType type;
  };
  std::uint32_t program(const std::string& vertex, const std::string& fragment, const std::vector<Uniform>& uniforms) {
    auto packed = std::make_unique<PackedProgramT>();
    packed->name = "program " + std::to_string(package.programs.size());
    packed->targets.push_back(std::make_unique<PackedTargetProgramT>());
    add_stage(*packed->targets[0], PackedStageKind::vertex, vertex);
    add_stage(*packed->targets[0], PackedStageKind::fragment, fragment);
    for (const Uniform& uniform : uniforms) add_uniform(*packed, uniform);
    packed->attributes.push_back(std::make_unique<PackedAttributeT>());
    packed->attributes[0]->name = "castle_Vertex";
    package.programs.push_back(std::move(packed));
    return static_cast<std::uint32_t>(package.programs.size() - 1);
  }

  static void add_uniform(PackedProgramT& program, const Uniform& uniform) {
    program.uniforms.push_back(std::make_unique<PackedUniformT>());
    program.uniforms.back()->name = uniform.name;
    program.uniforms.back()->type = uniform.type;
  }

  /// One colour, set by binding 1 of the shape.
  std::uint32_t flat_program() {
    return program(
        "#version 330 core\n"
        "in vec3 castle_Vertex;\n"
        "uniform mat4 to_clip;\n"
        "void main() { gl_Position = to_clip * vec4(castle_Vertex, 1.0); }\n",
        "#version 330 core\n"
        "uniform vec4 color;\n"
        "out vec4 castle_FragColor;\n"
        "void main() { castle_FragColor = color; }\n",
        {{"to_clip", PackedUniformType::mat4}, {"color", PackedUniformType::vec4}});
  }

  std::uint32_t depth_program() {
    return program(
        "#version 330 core\n"
        "in vec3 castle_Vertex;\n"
        "uniform mat4 to_clip;\n"
        "void main() { gl_Position = to_clip * vec4(castle_Vertex, 1.0); }\n",
        "#version 330 core\n"
        "void main() {}\n",
        {{"to_clip", PackedUniformType::mat4}});
  }

  /// White where shadow map 0 says lit, black in shadow, grey between: the hardware's 2x2 filter.
  std::uint32_t shadow_program() {
    return program(
        "#version 330 core\n"
        "in vec3 castle_Vertex;\n"
        "uniform mat4 to_eye, projection, projector;\n"
        "out vec4 coordinate;\n"
        "void main() {\n"
        "  vec4 eye = to_eye * vec4(castle_Vertex, 1.0);\n"
        "  coordinate = projector * eye;\n"
        "  gl_Position = projection * eye;\n"
        "}\n",
        "#version 330 core\n"
        "in vec4 coordinate;\n"
        "uniform sampler2DShadow map;\n"
        "out vec4 castle_FragColor;\n"
        "void main() { castle_FragColor = vec4(vec3(textureProj(map, coordinate)), 1.0); }\n",
        {{"to_eye", PackedUniformType::mat4},
         {"projection", PackedUniformType::mat4},
         {"projector", PackedUniformType::mat4},
         {"map", PackedUniformType::sampler2DShadow}});
  }

  std::uint32_t flat_shape(std::uint32_t mesh, std::uint32_t program, std::array<double, 4> color,
                           std::int32_t transform = -1) {
    PackedShapeT& added = add_shape(mesh, program, transform);
    const std::uint32_t color_slot = slot(PackedValueType::vec4, {color.begin(), color.end()});
    added.bindings.emplace_back(0, 0, 0, 1.0F, PackedSource::model_view_projection_matrix);
    added.bindings.emplace_back(1, color_slot, 0, 1.0F, PackedSource::slot);
    return static_cast<std::uint32_t>(scene().shapes.size() - 1);
  }

  std::uint32_t shadowed_shape(std::uint32_t mesh, std::uint32_t program, std::uint32_t map, std::int32_t transform = -1) {
    PackedShapeT& added = add_shape(mesh, program, transform);
    added.bindings.emplace_back(0, 0, 0, 1.0F, PackedSource::model_view_matrix);
    added.bindings.emplace_back(1, 0, 0, 1.0F, PackedSource::projection_matrix);
    added.bindings.emplace_back(2, map, 0, 1.0F, PackedSource::projector_matrix);
    added.bindings.emplace_back(3, map, 0, 1.0F, PackedSource::shadow_map);
    added.receives.push_back(map);
    return static_cast<std::uint32_t>(scene().shapes.size() - 1);
  }

  void make_caster(std::uint32_t index, std::uint32_t program) {
    shape(index).depth_program = static_cast<std::int32_t>(program);
    shape(index).depth_bindings.emplace_back(0, 0, 0, 1.0F, PackedSource::model_view_projection_matrix);
  }

  /// Gives the shape a second program, drawn while its only switch is off.
  void add_off_program(std::uint32_t index, PackedSwitch one, std::uint32_t program, std::vector<PackedBinding> bindings) {
    shape(index).switches = {one};
    shape(index).states = {1, 0};
    shape(index).variants.push_back(std::make_unique<PackedVariantT>());
    shape(index).variants.back()->program = program;
    shape(index).variants.back()->bindings = std::move(bindings);
  }
  void name_slot(std::uint32_t slot_index, const std::string& name, bool dynamic) {
    scene().slot_names.push_back(std::make_unique<PackedSlotNameT>());
    scene().slot_names.back()->slot = slot_index;
    scene().slot_names.back()->name = name;
    scene().slot_names.back()->dynamic = dynamic;
  }

  std::int32_t transform(std::int32_t parent, std::uint32_t translation, std::uint32_t rotation_slot = kNoSlot,
                         std::uint32_t scale = kNoSlot, std::uint32_t scale_orientation = kNoSlot,
                         std::uint32_t center = kNoSlot) {
    scene().transforms.emplace_back(parent, translation, rotation_slot, scale, scale_orientation, center, kNoSlot, 0);
    return static_cast<std::int32_t>(scene().transforms.size() - 1);
  }
  std::int32_t switch_child(std::int32_t parent, std::uint32_t which_choice, std::int32_t choice) {
    scene().transforms.emplace_back(parent, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kNoSlot, which_choice, choice);
    return static_cast<std::int32_t>(scene().transforms.size() - 1);
  }

  std::uint32_t add_light(PackedLightKind kind, const std::string& name) {
    scene().lights.push_back(std::make_unique<PackedLightT>());
    scene().lights.back()->kind = kind;
    scene().lights.back()->name = name;
    return static_cast<std::uint32_t>(scene().lights.size() - 1);
  }
  std::uint32_t add_shadow_map(std::uint32_t light_index, std::uint32_t size) {
    scene().shadow_maps.push_back(std::make_unique<PackedShadowMapT>());
    PackedShadowMapT& map = *scene().shadow_maps.back();
    map.light = light_index;
    map.size = size;
    map.update = PackedShadowUpdate::always;
    map.scale = number(0);
    map.bias = number(0);
    return static_cast<std::uint32_t>(scene().shadow_maps.size() - 1);
  }

  /// A texture that shows a scene of its own, drawn anew in each frame.
  std::uint32_t own_scene_texture(std::uint32_t side) {
    scene().rendered_textures.push_back(std::make_unique<PackedRenderedTextureT>());
    PackedRenderedTextureT& texture = *scene().rendered_textures.back();
    texture.width = texture.height = side;
    texture.update = PackedShadowUpdate::always;
    texture.own_scene = true;
    texture.minification = PackedFilter::nearest;
    return static_cast<std::uint32_t>(scene().rendered_textures.size() - 1);
  }

  /// Looks from +z at the square of that half side around the origin, so that pictures have no perspective.
  void orthographic_view(double half, double distance = 10) {
    scene().viewpoints.push_back(std::make_unique<PackedViewpointT>());
    PackedViewpointT& viewpoint = *scene().viewpoints.back();
    viewpoint.orthographic = true;
    viewpoint.position = vec3(0, 0, distance);
    viewpoint.field_of_view = slot(PackedValueType::vec4, {-half, -half, half, half});
  }

  /// The package as its verified bytes. Fails the test where the builder made none.
  LoadedPackage pack() const {
    std::string error;
    LoadedPackage loaded = load_package(write_package(package), error);
    EXPECT_EQ(error, "");
    return loaded;
  }

  PackageT package;

 private:
  static void add_stage(PackedTargetProgramT& target, PackedStageKind kind, const std::string& text) {
    target.stages.push_back(std::make_unique<PackedStageT>());
    target.stages.back()->kind = kind;
    target.stages.back()->text = text;
  }
  PackedShapeT& add_shape(std::uint32_t mesh, std::uint32_t program, std::int32_t transform) {
    scene().shapes.push_back(std::make_unique<PackedShapeT>());
    PackedShapeT& added = *scene().shapes.back();
    added.mesh = mesh;
    added.program = program;
    added.transform = transform;
    return added;
  }
};

inline RendererOptions quick_start() {
  return {true, PLUGC_BINARY_DIR "/shader_cache"};
}

/// A Renderer with the scene loaded.
inline std::unique_ptr<Renderer> make_renderer(const LoadedPackage& loaded) {
  std::string error;
  std::unique_ptr<Renderer> renderer = Renderer::make(quick_start(), error);
  EXPECT_TRUE(renderer != nullptr && renderer->load(*loaded.package, 0, error)) << error;
  return renderer;
}

/// x and y from the lower left corner.
inline Rgb pixel(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  const std::size_t at = (std::size_t{y} * picture.width + x) * 4;
  return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

inline const Rgb kBlack = {0, 0, 0};
inline const Rgb kWhite = {255, 255, 255};
inline const Rgb kRed = {255, 0, 0};
inline const Rgb kGreen = {0, 255, 0};
inline const Rgb kBlue = {0, 0, 255};

}  // namespace plugc::test

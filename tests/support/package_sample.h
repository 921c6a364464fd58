#pragma once
// A small package in which every list of the schema has an element, for tests and fuzzers that change one thing in it.

#include "package/package_file.h"

namespace plugc {

inline constexpr std::uint32_t kSampleColor = 0;  ///< Slots of sample_package()'s scene.
inline constexpr std::uint32_t kSampleScalar = 1;
inline constexpr std::uint32_t kSampleRotation = 2;

inline PackedStageT sample_stage(PackedStageKind kind) {
  PackedStageT stage;
  stage.kind = kind;
  stage.text = "#version 330 core\nvoid main() {}\n";
  stage.origins = {{0, 0}, {0, 2}};
  return stage;
}

inline PackedProgramT sample_program() {
  PackedProgramT program;
  program.name = "phong + Fresnel";
  program.recipe = "lit 1";
  auto target = std::make_unique<PackedTargetProgramT>();
  for (const PackedStageKind kind : {PackedStageKind::vertex, PackedStageKind::fragment}) {
    target->stages.push_back(std::make_unique<PackedStageT>(sample_stage(kind)));
  }
  program.targets.push_back(std::move(target));
  const auto add_uniform = [&](const char* name, PackedUniformType type, std::uint32_t count) {
    program.uniforms.push_back(std::make_unique<PackedUniformT>());
    program.uniforms.back()->name = name;
    program.uniforms.back()->type = type;
    program.uniforms.back()->count = count;
  };
  add_uniform("color", PackedUniformType::vec3, 1);
  add_uniform("weights", PackedUniformType::float_, 4);
  add_uniform("texture0", PackedUniformType::sampler2D, 1);
  program.attributes.push_back(std::make_unique<PackedAttributeT>());
  program.attributes.back()->name = "position";
  program.plugs_filled = {"texture_color"};
  program.plugs_empty = {"fragment_end", "light_scale"};
  return program;
}

inline PackedMeshT sample_mesh() {
  PackedMeshT mesh;
  mesh.vertex_count = 3;
  mesh.stride = 20;
  mesh.streams = {{PackedSemantic::position, 0, 3, 0}, {PackedSemantic::tex_coord, 0, 2, 12}};
  mesh.vertices.resize(60);
  mesh.indices = {0, 1, 2};
  mesh.bounds_min = std::make_unique<PackedVec3>(-1, -1, 0);
  mesh.bounds_max = std::make_unique<PackedVec3>(1, 0.5, 0);
  mesh.attributes.push_back(std::make_unique<PackedMeshAttributeT>());
  mesh.attributes.back()->name = "lift";
  mesh.attributes.back()->components = 1;
  mesh.attributes.back()->offset = 16;
  return mesh;
}

/// The second mesh: what a live one may follow.
inline PackedMeshT sample_moving_mesh() {
  PackedMeshT mesh;
  mesh.vertex_count = 3;
  mesh.stride = 48;
  mesh.streams = {{PackedSemantic::position, 0, 3, 0},
                  {PackedSemantic::normal, 0, 3, 12},
                  {PackedSemantic::tex_coord, 0, 2, 24},
                  {PackedSemantic::tangent, 0, 4, 32}};
  mesh.vertices.resize(144);
  mesh.indices = {0, 1, 2};
  mesh.bounds_min = std::make_unique<PackedVec3>(0, 0, 0);
  mesh.bounds_max = std::make_unique<PackedVec3>(1, 1, 1);
  return mesh;
}

/// Two of its vertices follow the one element of a slot.
inline PackedLiveMeshT sample_live_mesh() {
  PackedLiveMeshT live;
  live.mesh = 1;
  live.feeds.push_back(std::make_unique<PackedVertexFeedT>());
  live.feeds.back()->width = 3;
  live.feeds.back()->slot = kSampleColor;
  live.feeds.back()->elements = {0, 0, UINT32_MAX};
  live.normals = std::make_unique<PackedMadeNormalsT>();
  live.normals->face_ends = {3};
  live.normals->corners = {0, 1, 2};
  live.normals->vertex_faces = {0, 0, 0};
  live.normals->vertex_points = {0, 1, 1};
  live.normals->least_cosine = 0.5F;
  live.box_coords = {{0, PackedBoxLayout::longest_sides}};
  live.tangent_unit = 0;
  return live;
}

inline PackedImageT sample_image() {
  PackedImageT image;
  image.width = 2;
  image.height = 3;
  image.channels = 3;
  image.pixels.resize(18);
  return image;
}

inline PackedShapeT sample_shape() {
  PackedShapeT shape;
  shape.name = "Kettle";
  shape.transform = 1;
  shape.bindings = {{0, kSampleColor, 0, 1, PackedSource::slot}, {2, 0, 0, 1, PackedSource::texture}};
  shape.line_width = kSampleScalar;
  shape.depth_program = 1;
  shape.depth_bindings = {{0, kSampleColor, 0, 1, PackedSource::slot}};
  shape.cull_back = true;
  shape.receives = {0};
  shape.switches = {{kSampleScalar, PackedSwitchKind::slot}, {0, PackedSwitchKind::light}};
  shape.states = {1, 0, 1, 0};
  shape.variants.push_back(std::make_unique<PackedVariantT>());
  shape.variants.back()->program = 1;
  shape.variants.back()->bindings = {{0, kSampleColor, 0, 1, PackedSource::slot}};
  return shape;
}

inline PackedRenderedTextureT sample_rendered_texture() {
  PackedRenderedTextureT texture;
  texture.width = 64;
  texture.height = 32;
  texture.update = PackedShadowUpdate::always;
  texture.background_color = kSampleColor;
  texture.rendering_slots = {kSampleScalar};
  texture.border = std::make_unique<PackedBorder>(1, 0, 0, 1);
  texture.distance_from_shape = kSampleScalar;
  texture.own_backdrop = true;
  texture.loans = {{kSampleColor, kSampleColor}};
  return texture;
}

inline PackedScreenEffectT sample_screen_effect() {
  PackedScreenEffectT effect;
  effect.name = "Grey";
  effect.program = 1;
  effect.bindings = {{2, 0, 0, 1, PackedSource::screen_color}, {0, kSampleColor, 0, 1, PackedSource::slot}};
  effect.enabled = kSampleScalar;
  effect.needs_depth = true;
  effect.transform = 1;
  return effect;
}

/// `function power(value, time) color := value * 2`, of a Script with the fields power and color.
inline std::unique_ptr<PackedEventNodeT> sample_script() {
  auto node = std::make_unique<PackedEventNodeT>();
  node->kind = PackedEventKind::script;
  node->inputs = {kSampleScalar, kNoSlot};
  node->outputs = {kNoSlot, kSampleColor};
  node->script = std::make_unique<PackedScriptT>();
  node->script->origin = std::make_unique<PackedLineOrigin>(1, 9);
  node->script->values = {0, 0, 0, 2};
  node->script->variables = {{0, 3, 1}, {3, 0, -1}, {3, 1, -1}};
  node->script->functions = {{0, 1, kNoSlot, 0, 5}};
  node->script->steps = {{1, 10, PackedScriptOp::load},
                         {2, 10, PackedScriptOp::load},
                         {0, 10, PackedScriptOp::multiply},
                         {0, 10, PackedScriptOp::store},
                         {0, 10, PackedScriptOp::drop}};
  return node;
}

inline PackedSceneT sample_scene() {
  PackedSceneT scene;
  scene.name = "kettle.x3dv";
  scene.slots = {{0, 1, PackedValueType::vec3}, {3, 1, PackedValueType::float_}, {4, 1, PackedValueType::rotation}};
  scene.slot_values = {1, 0.5, 0, 0.25, 0, 1, 0, 1.5707963267948966};
  scene.slot_names.push_back(std::make_unique<PackedSlotNameT>());
  scene.slot_names.back()->name = "Paint.diffuseColor";
  scene.slot_names.back()->dynamic = true;
  scene.transforms = {{-1, kSampleColor, kSampleRotation, kNoSlot, kNoSlot, kNoSlot, kNoSlot, 0},
                      {0, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kSampleScalar, 2}};
  scene.lod_levels = {{1, kSampleColor, 0, 2.5}};
  scene.lights.push_back(std::make_unique<PackedLightT>());
  scene.lights.back()->name = "Lamp";
  scene.lights.back()->kind = PackedLightKind::spot;
  scene.lights.back()->color = kSampleColor;
  scene.shadow_maps.push_back(std::make_unique<PackedShadowMapT>());
  scene.shadow_maps.back()->size = 512;
  scene.shadow_maps.back()->update = PackedShadowUpdate::always;
  scene.clip_planes = {{1, kSampleRotation, kSampleScalar}};
  scene.fog_planes = {{1, kSampleColor, kSampleScalar}};
  scene.texture_transforms = {{kNoSlot, kSampleScalar, kNoSlot, kNoSlot}};
  scene.shapes.push_back(std::make_unique<PackedShapeT>(sample_shape()));
  scene.viewpoints.push_back(std::make_unique<PackedViewpointT>());
  scene.viewpoints.back()->name = "Front";
  scene.viewpoints.back()->description = "from the front";
  scene.viewpoints.back()->field_of_view = kSampleScalar;
  scene.bound_viewpoint = -1;
  scene.event_nodes.push_back(std::make_unique<PackedEventNodeT>());
  scene.event_nodes.back()->kind = PackedEventKind::interpolate;
  scene.event_nodes.back()->inputs = {kSampleScalar, kSampleScalar, kSampleColor};
  scene.event_nodes.back()->outputs = {kSampleColor};
  scene.event_nodes.push_back(std::make_unique<PackedEventNodeT>());
  scene.event_nodes.back()->kind = PackedEventKind::bind_stack;
  scene.event_nodes.back()->inputs = {kSampleScalar};
  scene.event_nodes.back()->outputs = {kNoSlot, kNoSlot, kNoSlot};
  scene.event_nodes.back()->subject = 0;
  scene.event_nodes.push_back(std::make_unique<PackedEventNodeT>());
  scene.event_nodes.back()->kind = PackedEventKind::choose;
  scene.event_nodes.back()->inputs = {kSampleScalar, kSampleColor, kSampleColor};
  scene.event_nodes.back()->outputs = {kSampleColor};
  scene.event_nodes.push_back(sample_script());
  scene.routes = {{kSampleColor, kSampleColor}};
  scene.live_meshes.push_back(std::make_unique<PackedLiveMeshT>(sample_live_mesh()));
  scene.bound_viewpoint_now = kSampleScalar;
  scene.bound_background = kSampleScalar;
  scene.rendered_textures.push_back(std::make_unique<PackedRenderedTextureT>(sample_rendered_texture()));
  scene.screen_effects.push_back(std::make_unique<PackedScreenEffectT>(sample_screen_effect()));
  return scene;
}

inline PackedEffectT sample_effect() {
  PackedEffectT effect;
  effect.name = "Fresnel";
  effect.origin = std::make_unique<PackedLineOrigin>(1, 7);
  effect.needs = {"fragment_modify"};
  effect.offers = {"fresnel_change"};
  effect.fields.push_back(std::make_unique<PackedEffectFieldT>());
  effect.fields.back()->name = "power";
  effect.fields.back()->slot = kSampleScalar;
  effect.kinds.push_back(std::make_unique<PackedEffectKindT>());
  effect.kinds.back()->name = "phong";
  return effect;
}

inline PackageT sample_package() {
  PackageT package;
  package.generator = "plugc";
  package.sources = {"", "kettle.x3dv"};
  package.programs.push_back(std::make_unique<PackedProgramT>(sample_program()));
  package.programs.push_back(std::make_unique<PackedProgramT>(sample_program()));
  package.meshes.push_back(std::make_unique<PackedMeshT>(sample_mesh()));
  package.meshes.push_back(std::make_unique<PackedMeshT>(sample_moving_mesh()));
  package.images.push_back(std::make_unique<PackedImageT>(sample_image()));
  package.textures.push_back(std::make_unique<PackedTextureT>());
  package.scenes.push_back(std::make_unique<PackedSceneT>(sample_scene()));
  package.effects.push_back(std::make_unique<PackedEffectT>(sample_effect()));
  return package;
}

}  // namespace plugc

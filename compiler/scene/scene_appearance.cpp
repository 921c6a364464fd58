// Appearance, materials, effects and shader nodes as plain data. A node is turned once, however often it is USEd.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene/scene_context.h"
#include "scene/shader_url.h"

namespace plugc {
namespace {

constexpr std::array<std::string_view, 4> kPartTypes = {"VERTEX", "GEOMETRY", "FRAGMENT", "LIGHT"};

/// A part's stage; nullopt (with a message) for a type that names none. ShaderPart knows no LIGHT, but no harm is done.
std::optional<PartStage> part_stage(SceneContext& context, NodeId part) {
  const std::string_view type = context.graph.string(part, "type");
  const auto found = std::find(kPartTypes.begin(), kPartTypes.end(), type);
  if (found != kPartTypes.end()) return static_cast<PartStage>(found - kPartTypes.begin());
  context.diagnostics.report(DiagnosticId::effect_unknown_type, context.graph.field_span(part, "type"),
                             fmt::format("`{}` is no shader stage; `type` takes `VERTEX`, `GEOMETRY`, `FRAGMENT` or `LIGHT`{}",
                                         type, did_you_mean(type, kPartTypes)));
  return std::nullopt;
}

std::vector<ShaderSource> read_parts(SceneContext& context, NodeId node) {
  std::vector<ShaderSource> parts;
  for (const NodeId part : context.graph.children(node, "parts")) {
    if (!context.graph.is(part, "EffectPart") && !context.graph.is(part, "ShaderPart")) continue;
    const auto stage = part_stage(context, part);
    if (!stage) continue;
    auto code = read_shader_code(context.graph, part, context.code_files, context.diagnostics);
    if (code) parts.push_back({*stage, std::move(code->text), code->span, part});
  }
  return parts;
}

std::vector<ShaderField> read_fields(SceneContext& context, NodeId node) {
  std::vector<ShaderField> fields;
  for (const InterfaceField& written : context.graph[node].interface()) {
    if (written.access == AccessType::output_only) continue;
    ShaderField field{written.name, written.type, written.name_span, kSceneNoSlot, {}};
    if (is_node(written.type)) {
      for (const NodeId texture : written.value.nodes) field.textures.push_back(texture_index(context, texture));
    } else {
      field.slot = context.slots.interface_slot(node, written);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

bool is_glsl(SceneContext& context, NodeId node, std::string_view what) {
  const std::string_view language = context.graph.string(node, "language");
  if (language.empty() || language == "GLSL") return true;
  constexpr std::array<std::string_view, 3> kLanguages = {"GLSL", "HLSL", "CG"};  // X3D 4.1, 31.2.1
  const bool is_known = std::find(kLanguages.begin(), kLanguages.end(), language) != kLanguages.end();
  context.diagnostics.report(DiagnosticId::effect_unknown_language, context.graph.field_span(node, "language"),
                             fmt::format("{} in language `{}` is passed over; plugc compiles `GLSL`{}", what, language,
                                         is_known ? "" : did_you_mean(language, kLanguages)));
  return false;
}

SceneEffect read_shader_node(SceneContext& context, NodeId node) {
  SceneEffect effect;
  const GraphNode& written = context.graph[node];
  effect.node = node;
  effect.span = written.type_span;
  const auto line = context.sources.position(written.span.source, written.span.begin).line;
  effect.label = written.def.empty() ? fmt::format("{} at line {}", written.info->name, line) : std::string(written.def);
  effect.parts = read_parts(context, node);
  effect.fields = read_fields(context, node);
  return effect;
}

/// The libraries that plugc brings along; each is a template (compose/place_units.cpp).
constexpr std::array<std::string_view, 1> kLibraries = {"castle-shader:/EyeWorldSpace.glsl"};

std::vector<std::string> read_libraries(SceneContext& context, NodeId effect) {
  std::vector<std::string> libraries;
  for (const MappedText& url : context.graph.field(effect, "shaderLibraries").strings) {
    if (std::find(kLibraries.begin(), kLibraries.end(), url.text()) != kLibraries.end()) {
      libraries.emplace_back(url.text());
      continue;
    }
    context.diagnostics.report(
        DiagnosticId::effect_unknown_library, url.locate(0, url.size()),
        fmt::format("there is no library `{}`; plugc has `{}`", url.text(), fmt::join(kLibraries, "`, `")));
  }
  return libraries;
}

/// The field of a material that the main texture multiplies (X3D 4.1, clause 12.4).
NodeId material_texture(const NodeGraph& graph, NodeId material) {
  if (graph.is(material, "Material") || graph.is(material, "CommonSurfaceShader"))
    return graph.child(material, "diffuseTexture");
  if (graph.is(material, "UnlitMaterial")) return graph.child(material, "emissiveTexture");
  if (graph.is(material, "PhysicalMaterial")) return graph.child(material, "baseTexture");
  return {};
}

/// Of a CommonSurfaceShader, which is a Material under other names (its maps that X3D has none for are not drawn).
SceneMaterial read_surface_shader(SceneContext& context, NodeId node) {
  SlotTable& slots = context.slots;
  SceneMaterial material;
  material.lighting = Lighting::phong;
  material.diffuse = slots.slot(node, "diffuseFactor");
  material.ambient_color = slots.slot(node, "ambientFactor");
  material.ambient = slots.constant(SlotType::float_, {1});
  material.specular = slots.slot(node, "specularFactor");
  material.emissive = slots.slot(node, "emissiveFactor");
  material.shininess = slots.slot(node, "shininessFactor");
  material.normal_scale = slots.constant(SlotType::float_, {1});
  material.transparency = slots.constant(SlotType::float_, {1 - context.graph.number(node, "alphaFactor")});
  return material;
}

/// What the further textures of Material and PhysicalMaterial are scaled by; a TwoSidedMaterial has none.
void read_surface(SceneContext& context, NodeId node, SceneMaterial& material) {
  if (context.graph.is(node, "TwoSidedMaterial")) return;
  material.normal_scale = context.slots.slot(node, "normalScale");
  material.occlusion_strength = context.slots.slot(node, "occlusionStrength");
}

SceneMaterial read_material(SceneContext& context, NodeId node) {
  if (context.graph.is(node, "CommonSurfaceShader")) return read_surface_shader(context, node);
  SlotTable& slots = context.slots;
  SceneMaterial material;
  material.transparency = slots.slot(node, "transparency");
  if (context.graph.is(node, "Material") || context.graph.is(node, "TwoSidedMaterial")) {
    material.lighting = Lighting::phong;
    material.diffuse = slots.slot(node, "diffuseColor");
    material.ambient_color = material.diffuse;
    material.ambient = slots.slot(node, "ambientIntensity");
    material.specular = slots.slot(node, "specularColor");
    material.emissive = slots.slot(node, "emissiveColor");
    material.shininess = slots.slot(node, "shininess");
    read_surface(context, node, material);
  } else if (context.graph.is(node, "PhysicalMaterial")) {
    material.lighting = Lighting::physical;
    material.diffuse = slots.slot(node, "baseColor");
    material.emissive = slots.slot(node, "emissiveColor");
    material.metallic = slots.slot(node, "metallic");
    material.roughness = slots.slot(node, "roughness");
    read_surface(context, node, material);
  } else {
    material.emissive = slots.slot(node, "emissiveColor");
  }
  return material;
}

int material_index(SceneContext& context, NodeId node) {
  constexpr std::string_view kTypes[] = {"Material", "TwoSidedMaterial", "UnlitMaterial", "PhysicalMaterial",
                                         "CommonSurfaceShader"};
  if (std::none_of(std::begin(kTypes), std::end(kTypes), [&](std::string_view type) { return context.graph.is(node, type); }))
    return -1;
  const auto [found, added] = context.materials.try_emplace(node, static_cast<int>(context.scene.materials.size()));
  if (added) context.scene.materials.push_back(read_material(context, node));
  return found->second;
}

BlendFactor read_factor(SceneContext& context, NodeId blend, std::string_view field, BlendFactor fallback) {
  constexpr std::array<std::string_view, 15> kNames = {"ZERO",
                                                       "ONE",
                                                       "SRC_COLOR",
                                                       "ONE_MINUS_SRC_COLOR",
                                                       "DST_COLOR",
                                                       "ONE_MINUS_DST_COLOR",
                                                       "SRC_ALPHA",
                                                       "ONE_MINUS_SRC_ALPHA",
                                                       "DST_ALPHA",
                                                       "ONE_MINUS_DST_ALPHA",
                                                       "SRC_ALPHA_SATURATE",
                                                       "CONSTANT_COLOR",
                                                       "ONE_MINUS_CONSTANT_COLOR",
                                                       "CONSTANT_ALPHA",
                                                       "ONE_MINUS_CONSTANT_ALPHA"};
  const std::string_view name = context.graph.string(blend, field);
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end() ? fallback : static_cast<BlendFactor>(found - kNames.begin());
}

/// The material, in whose place a CommonSurfaceShader stands where the first shader is one.
NodeId appearance_material(const NodeGraph& graph, NodeId appearance) {
  const auto shaders = graph.children(appearance, "shaders");
  const bool replaced = !shaders.empty() && graph.is(shaders.front(), "CommonSurfaceShader");
  return replaced ? shaders.front() : graph.child(appearance, "material");
}

/// What a TwoSidedMaterial with `separateBackColor` says of back faces (X3D 3.3, 12.4.7).
int two_sided_back(SceneContext& context, NodeId node) {
  const auto [found, added] = context.back_materials.try_emplace(node, static_cast<int>(context.scene.materials.size()));
  if (!added) return found->second;
  SlotTable& slots = context.slots;
  SceneMaterial material;
  material.lighting = Lighting::phong;
  material.diffuse = material.ambient_color = slots.slot(node, "backDiffuseColor");
  material.ambient = slots.slot(node, "backAmbientIntensity");
  material.specular = slots.slot(node, "backSpecularColor");
  material.emissive = slots.slot(node, "backEmissiveColor");
  material.shininess = slots.slot(node, "backShininess");
  material.transparency = slots.slot(node, "backTransparency");
  context.scene.materials.push_back(material);
  return found->second;
}

/// The material of back faces; -1 where it is the front's. Both sides are lit by one model: a material of another one is
/// reported.
int back_material_index(SceneContext& context, NodeId appearance, NodeId material, const SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  if (graph.is(material, "TwoSidedMaterial"))
    return graph.boolean(material, "separateBackColor") ? two_sided_back(context, material) : -1;
  const NodeId node = graph.child(appearance, "backMaterial");
  const int back = node.valid() ? material_index(context, node) : -1;
  if (back < 0) return -1;
  const auto& materials = context.scene.materials;
  const Lighting front = shape.material < 0 ? Lighting::unlit : materials[static_cast<std::size_t>(shape.material)].lighting;
  if (shape.material >= 0 && materials[static_cast<std::size_t>(back)].lighting == front) return back;
  context.diagnostics.report(DiagnosticId::not_drawn, graph[node].type_span,
                             "`backMaterial` is of another type than `material`; back faces are drawn with the front's");
  return -1;
}

int shader_index(SceneContext& context, NodeId node) {
  if (!context.graph.is(node, "ComposedShader")) return -1;
  if (const auto found = context.shaders.find(node); found != context.shaders.end()) return found->second;
  int& index = context.shaders[node] = -1;
  if (!is_glsl(context, node, "a shader")) return -1;
  context.scene.shaders.push_back(read_shader_node(context, node));
  return index = static_cast<int>(context.scene.shaders.size() - 1);
}

}  // namespace

std::string node_label(const NodeGraph& graph, NodeId node) {
  return std::string(graph[node].def.empty() ? graph[node].info->name : graph[node].def);
}

int effect_index(SceneContext& context, NodeId node) {
  if (!context.graph.is(node, "Effect")) return -1;
  if (const auto found = context.effects.find(node); found != context.effects.end()) return found->second;
  int& index = context.effects[node] = -1;
  const bool switchable = context.slots.may_change(node, "enabled");
  if (!switchable && !context.options.all_branches && !context.options.alone.valid() && !context.graph.boolean(node, "enabled"))
    return -1;
  if (!is_glsl(context, node, "an effect")) return -1;
  SceneEffect effect = read_shader_node(context, node);
  effect.warn_missing_uniforms = context.graph.string(node, "uniformMissing") != "IGNORE";
  effect.libraries = read_libraries(context, node);
  if (switchable) effect.enabled = context.slots.slot(node, "enabled");
  context.scene.effects.push_back(std::move(effect));
  return index = static_cast<int>(context.scene.effects.size() - 1);
}

std::vector<int> effect_list(SceneContext& context, NodeId owner) {
  std::vector<int> list;
  for (const NodeId effect : context.graph.children(owner, "effects")) {
    if (const int index = effect_index(context, effect); index >= 0) list.push_back(index);
  }
  return list;
}

int usable_shader(SceneContext& context, NodeId owner) {
  for (const NodeId shader : context.graph.children(owner, "shaders")) {
    if (const int index = shader_index(context, shader); index >= 0) return index;
  }
  return -1;
}

void read_appearance(SceneContext& context, NodeId appearance, SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  if (!graph.is(appearance, "Appearance")) return;
  const NodeId material = appearance_material(graph, appearance);
  shape.material = material_index(context, material);
  shape.back_material = back_material_index(context, appearance, material, shape);
  read_style(context, appearance, shape);
  const NodeId own_texture = material_texture(graph, material);
  read_textures(context, own_texture.valid() ? own_texture : graph.child(appearance, "texture"),
                graph.child(appearance, "textureTransform"), shape);
  read_material_textures(context, material, graph.child(appearance, "textureTransform"), shape);
  read_normal_map(context, appearance, shape);
  shape.effects = effect_list(context, appearance);
  shape.shader = usable_shader(context, appearance);
  shape.casts_shadow = graph.boolean(appearance, "shadowCaster");
  if (const NodeId blend = graph.child(appearance, "blendMode"); graph.is(blend, "BlendMode")) {
    shape.has_blend_mode = true;
    shape.blend = {read_factor(context, blend, "srcFactor", BlendFactor::src_alpha),
                   read_factor(context, blend, "destFactor", BlendFactor::one_minus_src_alpha),
                   context.slots.slot(blend, "color"), context.slots.slot(blend, "colorTransparency")};
  }
}

}  // namespace plugc

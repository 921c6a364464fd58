#pragma once
// What a scene means to a renderer: shapes with the lights, textures, effects and shadow maps that reach them, on a tree
// of transforms. Everything that a ROUTE or a host may change is a slot; everything else refers to slots by number.
// Plain data: indices into the lists of one Scene, -1 for none.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "scene/node_graph.h"

namespace plugc {

inline constexpr std::uint32_t kSceneNoSlot = UINT32_MAX;  ///< "None: the default".

enum class SlotType : std::uint8_t { bool_, int_, float_, vec2, vec3, vec4, mat3, mat4, rotation };
std::uint32_t component_count(SlotType type);
/// The slot type that holds one element of a field; nullopt for strings, nodes and images.
std::optional<SlotType> slot_type(FieldType type);

/// A value that may change while the scene is drawn.
struct Slot {
  SlotType type = SlotType::float_;
  std::uint32_t count = 1;  ///< Elements; more than 1 for arrays.
  std::vector<double> values;
  std::string name;      ///< `DEF.field`, or empty.
  bool routed = false;   ///< Some ROUTE writes it, or the host may.
  bool dynamic = false;  ///< The host may write it by its name.
  /// An earlier slot that always holds the same: it starts alike, and the same events reach both.
  std::uint32_t mirrors = kSceneNoSlot;
};

/// Object to parent space, X3D 4.1 clause 10.4.4. Fields are slots.
struct SceneTransform {
  int parent = -1;
  std::uint32_t translation = kSceneNoSlot, rotation = kSceneNoSlot, scale = kSceneNoSlot;
  std::uint32_t scale_orientation = kSceneNoSlot, center = kSceneNoSlot;
  std::uint32_t switch_slot = kSceneNoSlot;  ///< With it: drawn only while the slot equals `choice`.
  int choice = 0;
};

/// Where an effect part is plugged; LIGHT means the stage that computes the shape's lighting.
enum class PartStage : std::uint8_t { vertex, geometry, fragment, light };

/// Shader code of one EffectPart or ShaderPart, as the author wrote it.
struct ShaderSource {
  PartStage stage = PartStage::vertex;
  MappedText text;
  Span span;    ///< The url or CDATA that it was read from.
  NodeId node;  ///< The part: USEd twice in one effect, it is one definition.
};

/// An interface field of an Effect or ComposedShader: what feeds the uniform of its name.
struct ShaderField {
  std::string_view name;
  FieldType type = FieldType::unknown;
  Span span;
  std::uint32_t slot = kSceneNoSlot;  ///< For values.
  std::vector<int> textures;          ///< For SFNode and MFNode.
};

struct SceneEffect {
  NodeId node;
  std::string label;  ///< DEF name, or `Effect` with its line.
  Span span;
  std::vector<ShaderSource> parts;
  std::vector<ShaderField> fields;
  std::vector<std::string> libraries;
  bool warn_missing_uniforms = true;
  std::uint32_t enabled = kSceneNoSlot;  ///< None: it is on for good. One that is off for good is in no scene.
};

/// A ComposedShader; the same shape as an effect, but it replaces the base shader.
using SceneShader = SceneEffect;

enum class TextureKind : std::uint8_t { image_2d };
enum class TextureMode : std::uint8_t { modulate, replace, add };
enum class Wrap : std::uint8_t { repeat, clamp_to_edge };

struct SceneTexture {
  TextureKind kind = TextureKind::image_2d;
  NodeId node;
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
  std::vector<int> effects;
};

/// Texture coordinates of one unit: X3D 4.1 clause 18.4.8. Slots.
struct SceneTextureTransform {
  std::uint32_t translation = kSceneNoSlot, rotation = kSceneNoSlot, scale = kSceneNoSlot, center = kSceneNoSlot;
};

/// What a material does with a texture (X3D 4.1, 12.4). The main ones make the diffuse, base or emissive colour; each other
/// multiplies the parameter that it is named after, or bends the surface (`normal`).
enum class TextureRole : std::uint8_t {
  main,
  ambient,
  specular,
  shininess,
  emissive,
  occlusion,
  metallic_roughness,
  normal,
  unused  ///< Keeps its number and has no code.
};

/// One texture as a shape's material uses it. Its number is its place in the shape's list.
struct TextureUse {
  int texture = -1;
  TextureMode mode = TextureMode::modulate;
  int transform = -1;  ///< Into texture_transforms.
  int unit = 0;        ///< Texture coordinate unit of the geometry.
  TextureRole role = TextureRole::main;
};

enum class LightKind : std::uint8_t { directional, point, spot };

struct SceneLight {
  LightKind kind = LightKind::directional;
  NodeId node;  ///< Not valid for a default headlight.
  std::string label;
  bool headlight = false;  ///< Hangs on the camera.
  int transform = -1;
  std::uint32_t on = kSceneNoSlot, color = kSceneNoSlot, intensity = kSceneNoSlot, ambient_intensity = kSceneNoSlot;
  std::uint32_t location = kSceneNoSlot, direction = kSceneNoSlot, attenuation = kSceneNoSlot, radius = kSceneNoSlot;
  std::uint32_t cut_off_angle = kSceneNoSlot, beam_width = kSceneNoSlot;
  std::vector<int> effects;
  bool casts_on_all = false;  ///< `shadows TRUE`.
  int shadow_map = -1;        ///< Made when some shape looks into it.
  std::uint32_t shadow_intensity = kSceneNoSlot;
};

enum class ShadowUpdate : std::uint8_t { none, next_frame_only, always };

/// A depth map; fields as PackedShadowMap has them.
struct SceneShadowMap {
  int light = -1;
  std::uint32_t size = 256;
  ShadowUpdate update = ShadowUpdate::always;
  std::uint32_t scale = kSceneNoSlot, bias = kSceneNoSlot, near = kSceneNoSlot, far = kSceneNoSlot, up = kSceneNoSlot;
  std::uint32_t angle = kSceneNoSlot, rectangle = kSceneNoSlot, location = kSceneNoSlot;
};

enum class Lighting : std::uint8_t { unlit, phong, physical };

struct SceneMaterial {
  Lighting lighting = Lighting::unlit;
  std::uint32_t diffuse = kSceneNoSlot;                                ///< Or baseColor.
  std::uint32_t ambient_color = kSceneNoSlot, ambient = kSceneNoSlot;  ///< diffuseColor and ambientIntensity, which scales it.
  std::uint32_t metallic = kSceneNoSlot, roughness = kSceneNoSlot;
  std::uint32_t normal_scale = kSceneNoSlot, occlusion_strength = kSceneNoSlot;
  std::uint32_t specular = kSceneNoSlot, emissive = kSceneNoSlot, shininess = kSceneNoSlot, transparency = kSceneNoSlot;
};

/// X3D 4.1, clause 24: how colours change into the fog's with their distance.
enum class FogKind : std::uint8_t { none, linear, exponential };

struct SceneFog {
  FogKind kind = FogKind::linear;
  int transform = -1;  ///< In whose units the visibility range is.
  std::uint32_t color = kSceneNoSlot, visibility_range = kSceneNoSlot;
};

enum class BlendFactor : std::uint8_t {
  zero,
  one,
  src_color,
  one_minus_src_color,
  dst_color,
  one_minus_dst_color,
  src_alpha,
  one_minus_src_alpha,
  dst_alpha,
  one_minus_dst_alpha,
  src_alpha_saturate,
  constant_color,
  one_minus_constant_color,
  constant_alpha,
  one_minus_constant_alpha
};

struct SceneBlend {
  BlendFactor source = BlendFactor::src_alpha;
  BlendFactor destination = BlendFactor::one_minus_src_alpha;
};

enum class Shading : std::uint8_t { phong, gouraud, wireframe };

struct SceneShape {
  std::string name;  ///< DEF of the shape or its geometry's type, for people.
  NodeId node, geometry;
  int transform = -1;
  int material = -1;  ///< -1: unlit white.
  std::vector<TextureUse> textures;
  std::vector<int> lights;    ///< In document order of the scene's light list.
  std::vector<int> receives;  ///< Lights whose shadow this shape shows.
  std::vector<int> effects;   ///< Of the Appearance, then of the groups from the outermost in.
  int shader = -1;            ///< A ComposedShader.
  int fog = -1;
  Shading shading = Shading::phong;
  bool casts_shadow = true;
  bool has_blend_mode = false;
  SceneBlend blend;
};

struct SceneViewpoint {
  std::string name, description;
  int transform = -1;
  bool orthographic = false;
  std::uint32_t position = kSceneNoSlot, orientation = kSceneNoSlot, field_of_view = kSceneNoSlot;
};

struct Scene {
  std::string name;
  std::vector<Slot> slots;
  std::vector<SceneTransform> transforms;
  std::vector<SceneEffect> effects;
  std::vector<SceneShader> shaders;
  std::vector<SceneTexture> textures;
  std::vector<SceneTextureTransform> texture_transforms;
  std::vector<SceneLight> lights;  ///< In the order that effects number them by (effects.md): headlight, directional, others.
  std::vector<SceneShadowMap> shadow_maps;
  std::vector<SceneMaterial> materials;
  std::vector<SceneFog> fogs;
  std::vector<SceneShape> shapes;
  std::vector<SceneViewpoint> viewpoints;
  std::vector<std::string> known_dynamic;  ///< Of SceneOptions::dynamic: what names a node of this scene.
  std::uint32_t background_color = kSceneNoSlot;
  std::uint32_t global_ambient = kSceneNoSlot;  ///< Light that is everywhere; times each material's ambient colour.
};

/// The shapes of a graph. With `all_branches` (lint), every child of a Switch and every disabled effect is taken too.
struct SceneOptions {
  bool all_branches = false;
  NodeId alone = {};  ///< Only this effect, on the appended stage of library_stage.h; the rest of the graph takes no part.
  std::vector<std::string> dynamic = {};  ///< `DEF.field`: fields that the host may change, besides those that a ROUTE writes.
};
Scene build_scene(const NodeGraph& graph, SourceSet& sources, FileAccess& files, const SceneOptions& options,
                  Diagnostics& diagnostics);

/// `plugc inspect --dump scene`.
std::string dump_scene(const Scene& scene);

}  // namespace plugc

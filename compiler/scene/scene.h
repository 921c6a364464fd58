#pragma once
// What a scene means to a renderer: shapes with the lights, textures, effects and shadow maps that reach them, on a tree
// of transforms. Everything that a ROUTE or a host may change is a slot; everything else refers to slots by number.
// Plain data: indices into the lists of one Scene, -1 for none.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/box.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "scene/node_graph.h"
#include "scene/shadow_choice.h"
#include "scene/shadow_method.h"
#include "scene/vertex_field.h"
#include "script/script.h"

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
  std::uint32_t billboard_axis = kSceneNoSlot;  ///< With it: turned to the viewer about that axis (X3D 4.1, 23.4.1).
  std::uint32_t switch_slot = kSceneNoSlot;     ///< With it: drawn only while the slot equals `choice`.
  int choice = 0;
  /// With it: drawn only while the eye is at least `lod_from` and less than `lod_to` away from that point (X3D 4.1, 23.4.3).
  std::uint32_t lod_center = kSceneNoSlot;
  double lod_from = 0, lod_to = 0;
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

/// What reads a texture in GLSL: a sampler of that kind. A ShaderTexture is code alone and has none.
enum class TextureKind : std::uint8_t { image_2d, image_3d, cube, shadow_2d, shader, shadow_cube };
enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat, clamp_to_border };

enum class TextureFilter : std::uint8_t { nearest, linear, linear_mipmap_linear, nearest_mipmap_nearest };

/// Texture coordinates that a mesh can hold: its own (as written, or its type's default), or a picture laid over the
/// object's box, along its two longest sides or along all three.
enum class VertexCoord : std::uint8_t { own, bounds_2d, bounds_3d };

/// When a map's texel counts as lit: the reference depth is at most, or at least, what the map holds (`compareMode`).
enum class DepthCompare : std::uint8_t { less_equal, greater_equal };

struct SceneTexture {
  TextureKind kind = TextureKind::image_2d;
  NodeId node;
  bool has_pixels = true;  ///< False: no image feeds its sampler (ShaderTexture, or a node that is not drawn yet).
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat, wrap_r = Wrap::repeat;
  TextureFilter minification = TextureFilter::linear_mipmap_linear, magnification = TextureFilter::linear;
  VertexCoord default_coord = VertexCoord::own;  ///< Where the geometry says nothing.
  int shadow_map = -1;                           ///< Of a GeneratedShadowMap: what it reads.
  bool moments = false;                          ///< Of the same: the moments of depth, as a picture.
  DepthCompare compare = DepthCompare::less_equal;
  std::vector<int> effects;
  int rendered = -1;                     ///< Into rendered_textures: the renderer draws it.
  std::string_view url_field = "url";    ///< Of the node: where its file is named. A Background has one for each side.
  std::array<double, 4> border_color{};  ///< Beyond the edges of one that is clamped to its border: RGBA.
};

/// Texture coordinates of one unit: X3D 4.1 clauses 18.4.8 and 33.4. Slots; `matrix` stands for all others.
struct SceneTextureTransform {
  std::uint32_t translation = kSceneNoSlot, rotation = kSceneNoSlot, scale = kSceneNoSlot, center = kSceneNoSlot;
  std::uint32_t matrix = kSceneNoSlot;
};

/// What MultiTexture makes of a texture (Arg1) and the colour so far (Arg2): X3D 4.1, table 18.3. SELECTARG1 is `replace`;
/// a texture that is OFF is in no list.
enum class TextureMode : std::uint8_t {
  modulate,
  replace,
  modulate_2x,
  modulate_4x,
  add,
  add_signed,
  add_signed_2x,
  subtract,
  add_smooth,
  blend_diffuse_alpha,
  blend_texture_alpha,
  blend_factor_alpha,
  blend_current_alpha,
  modulate_alpha_add_color,
  modulate_inv_alpha_add_color,
  modulate_inv_color_add_alpha,
  select_arg2,
  dot_product_3
};
/// What stands for Arg2 (table 18.4), and what is done with the result (table 18.5).
enum class TextureSource : std::uint8_t { previous, diffuse, specular, factor };
enum class TextureFunction : std::uint8_t { none, complement, alpha_replicate };

struct TextureCombination {
  TextureMode mode = TextureMode::modulate, alpha_mode = TextureMode::modulate;
  TextureSource source = TextureSource::previous;
  TextureFunction function = TextureFunction::none;
  auto operator<=>(const TextureCombination&) const = default;
};

/// Texture coordinates that the vertex stage computes: X3D 4.1, table 18.6, and the engine's modes beside it.
enum class CoordGenerator : std::uint8_t {
  none,
  sphere,
  camera_space_normal,
  camera_space_position,
  camera_space_reflection,
  sphere_local,
  coord,
  sphere_reflect,
  sphere_reflect_local,
  world_space_normal,
  world_space_reflection,
  projection,
  noise,
  noise_eye,
  mirror_plane  ///< Where the vertex is in a picture that the shape, as a flat mirror, shows the viewer.
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
  TextureCombination combination;
  int transform = -1;                    ///< Into texture_transforms.
  int unit = 0;                          ///< Texture coordinate unit of the geometry.
  VertexCoord coord = VertexCoord::own;  ///< What the mesh holds for it.
  CoordGenerator generator = CoordGenerator::none;
  std::uint32_t parameter = kSceneNoSlot;  ///< Of the generator: index of refraction, eye point (vec4).
  int projector = -1;                      ///< Of `projection`: into projectors.
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
  int shadow_map = -1;        ///< Of its defaultShadowMap; made when some shape looks into it.
  std::uint32_t shadow_intensity = kSceneNoSlot;
};

enum class ShadowUpdate : std::uint8_t { none, next_frame_only, always };

/// A depth map; fields as PackedShadowMap has them.
struct SceneShadowMap {
  int light = -1;
  std::uint32_t size = 256;
  ShadowUpdate update = ShadowUpdate::always;
  ShadowMethod method = kDefaultShadowMethod;
  bool method_written = false, size_written = false;  ///< By the scene.
  bool scale_written = false, bias_written = false;   ///< By the scene or a ROUTE; else they follow the method.
  std::uint32_t scale = kSceneNoSlot, bias = kSceneNoSlot, near = kSceneNoSlot, far = kSceneNoSlot, up = kSceneNoSlot;
  std::uint32_t angle = kSceneNoSlot, rectangle = kSceneNoSlot, location = kSceneNoSlot;
  bool author_visible = false;  ///< Not only the renderer's own code sees its depths or its projection.
  bool other_light = false;     ///< Effects may bring light to what it shadows where its light's own colours are black.
  std::optional<ShadowChoice> choice;
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

/// X3D 4.1, clause 24: how colours change into the fog's with their distance. `either`: as a slot of the fog says.
enum class FogKind : std::uint8_t { none, linear, exponential, either };

struct SceneFog {
  FogKind kind = FogKind::linear;
  int transform = -1;  ///< In whose units the visibility range is.
  std::uint32_t color = kSceneNoSlot, visibility_range = kSceneNoSlot;
  std::uint32_t exponential = kSceneNoSlot;  ///< Of `either`: not 0 for an exponential one.
  /// Of one that lies in layers (the reference engine's `volumetric`): along what it thickens, and from where on.
  bool volumetric = false;
  std::uint32_t direction = kSceneNoSlot, start = kSceneNoSlot;
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
  std::uint32_t color = kSceneNoSlot, transparency = kSceneNoSlot;  ///< What the `constant_` factors mean.
};

enum class Shading : std::uint8_t { phong, gouraud, wireframe };

/// A half of space that is cut away: X3D 4.1, clause 11.4.1. Fields are slots.
struct SceneClipPlane {
  int transform = -1;
  std::uint32_t plane = kSceneNoSlot, enabled = kSceneNoSlot;
};

/// What alpha means (X3D 4.1, 12.2.3, Appearance.alphaMode): `automatic` goes by the material and the textures.
enum class AlphaMode : std::uint8_t { automatic, opaque, mask, blend };

/// How lines, points and faces are drawn beside their colour: X3D 4.1, clauses 12.4.3, 12.4.4 and 12.4.9. Slots; none: the
/// default.
struct SceneStyle {
  std::uint32_t line_width = kSceneNoSlot;  ///< Pixels.
  int line_type = 1;                        ///< Solid; others are dashed (table 12.2).
  /// Of PointProperties: what the size is, what it lies between, how it falls with the distance (vec3).
  std::uint32_t point_size = kSceneNoSlot, point_least = kSceneNoSlot, point_most = kSceneNoSlot, point_falloff = kSceneNoSlot;
  bool filled = true;
  int hatch = 0;  ///< Style of the hatches (table 12.3); 0: none.
  std::uint32_t hatch_color = kSceneNoSlot;
};

/// The shadow of a light as a shape shows it.
struct ReceivedShadow {
  int light = -1;
  int shadow_map = -1;
  DepthCompare compare = DepthCompare::less_equal;
};

/// What a shape is part of. The backdrop is all parts of the bound Background but `world`: the gradients of sky and ground, and
/// the sides of a cube with a picture each, seen from within (X3D 4.1, 24.2.1).
enum class ScenePart : std::uint8_t { world, gradient, back, bottom, front, left, right, top };

struct SceneShape {
  std::string name;  ///< DEF of the shape or its geometry's type, for people.
  NodeId node, geometry;
  int transform = -1;
  int material = -1;       ///< -1: unlit white.
  int back_material = -1;  ///< Of back faces; -1: the same.
  std::vector<TextureUse> textures;
  std::uint32_t multi_color = kSceneNoSlot, multi_alpha = kSceneNoSlot;  ///< Of its MultiTexture: the source FACTOR.
  std::vector<int> lights;                                               ///< In document order of the scene's light list.
  std::vector<ReceivedShadow> receives;                                  ///< At most one a light.
  std::vector<int> effects;  ///< Of the Appearance, then of the groups from the outermost in.
  int shader = -1;           ///< A ComposedShader.
  int fog = -1;
  Shading shading = Shading::phong;
  bool casts_shadow = true;
  bool has_blend_mode = false;
  SceneBlend blend;
  std::optional<Box> bounds;          ///< bboxSize and bboxCenter, where they are written.
  int own_scene_of = -1;              ///< It stands in the scene that this rendered texture has of its own; -1: in the world.
  ScenePart part = ScenePart::world;  ///< Of the backdrop: `node` and `geometry` are the Background.
  int background = -1;                ///< Of the backdrop, where another may be bound: the number of its Background.
  AlphaMode alpha_mode = AlphaMode::automatic;
  std::uint32_t alpha_cutoff = kSceneNoSlot;
  std::vector<int> clip_planes;  ///< From the outermost in.
  SceneStyle style;
};

struct SceneViewpoint {
  NodeId node;
  std::string name, description;
  int transform = -1;
  bool orthographic = false;
  std::uint32_t position = kSceneNoSlot, orientation = kSceneNoSlot, field_of_view = kSceneNoSlot;
  std::uint32_t direction = kSceneNoSlot, up = kSceneNoSlot;  ///< In place of the orientation, where direction is not 0.
  bool field_is_vertical = false;                             ///< The reference engine's `fieldOfViewForceVertical`.
};

/// What projects texture coordinates: a viewpoint, which need not stand among those to look through, or a light.
struct SceneProjector {
  SceneViewpoint viewpoint;
  int shadow_map = -1;  ///< Of a light: the map whose projection it is; such a map may have no texels (update none).
};

/// What a rendered texture holds: colours, the depths of a view as grey, or what is seen all around a shape.
enum class RenderedKind : std::uint8_t { color, depth, cube };

/// While a rendered texture is drawn, the slot `to` holds what `from` holds.
struct SlotLoan {
  std::uint32_t from = kSceneNoSlot, to = kSceneNoSlot;
};

/// A RenderedTexture or GeneratedCubeMapTexture; fields as PackedRenderedTexture has them.
struct SceneRenderedTexture {
  NodeId node;
  RenderedKind kind = RenderedKind::color;
  std::uint32_t width = 128, height = 128;
  ShadowUpdate update = ShadowUpdate::none;
  int viewpoint = -1;  ///< Into projectors.
  bool own_scene = false;
  std::uint32_t background_color = kSceneNoSlot;
  std::vector<std::uint32_t> rendering_slots;                  ///< That ROUTEs from its `rendering` write.
  std::vector<std::uint32_t> viewing_slots, projection_slots;  ///< Likewise.
  bool in_mirror = false;                            ///< Seen from the viewer's place behind the shape, as in a mirror.
  std::uint32_t distance_from_shape = kSceneNoSlot;  ///< Of such a one: what is nearer to the mirror is not seen.
  bool own_backdrop = false;    ///< Around it are the backdrop shapes whose `own_scene_of` it is, not the world's.
  std::vector<SlotLoan> loans;  ///< Its own fog, in place of the world's.
};

/// A ScreenEffect with the shader that it uses.
struct SceneScreenEffect {
  NodeId node;
  std::string label;
  int shader = -1;                       ///< Into shaders.
  std::uint32_t enabled = kSceneNoSlot;  ///< As of an effect.
  bool needs_depth = false;
  int transform = -1;  ///< It acts while no Switch above has chosen another child.
};

/// As PackedEventKind, where the slots of each kind are listed.
enum class EventKind : std::uint8_t {
  time_sensor,
  proximity_sensor,
  camera,
  interpolate,
  interpolate_color,
  interpolate_normal,
  interpolate_rotation,
  spline,
  squad,
  ease,
  sequence,
  boolean_filter,
  boolean_toggle,
  boolean_trigger,
  integer_trigger,
  time_trigger,
  bind_stack,
  choose,
  script
};

/// A node whose events reach something that is drawn, or one of the renderer's own that says what is bound.
struct SceneEventNode {
  EventKind kind = EventKind::time_sensor;
  NodeId node;                                 ///< Not valid for one of the renderer's own.
  std::vector<std::uint32_t> inputs, outputs;  ///< Slots; none where nothing of the scene is different from the default.
  int subject = -1;  ///< The transform of a proximity sensor, the viewpoint of a camera, the first that a stack binds.
  std::optional<ScriptProgram> script;  ///< Of a Script, whose inputs and outputs are its fields in order.
};

/// An event at the slot `from` is one at `to`.
struct SceneRoute {
  std::uint32_t from = kSceneNoSlot, to = kSceneNoSlot;
  auto operator<=>(const SceneRoute&) const = default;
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
  std::vector<SceneClipPlane> clip_planes;
  std::vector<SceneShape> shapes;
  std::vector<SceneViewpoint> viewpoints;  ///< Those of Inlines too, which are not bound at the start (X3D 4.1, 7.2.2).
  int bound_viewpoint = -1;                ///< At the start.
  std::vector<SceneProjector> projectors;
  std::vector<SceneRenderedTexture> rendered_textures;  ///< One that another's own scene shows comes before that other.
  std::vector<SceneScreenEffect> screen_effects;        ///< In document order, in which they act.
  std::vector<SceneEventNode> event_nodes;              ///< In the order in which they are evaluated.
  std::vector<SceneRoute> routes;                       ///< In order.
  std::vector<std::string> known_dynamic;               ///< Of SceneOptions::dynamic: what names a node of this scene.
  std::vector<VertexField> vertex_fields;               ///< In order.
  /// What is bound now, where events may change that; as PackedScene has them.
  std::uint32_t bound_viewpoint_now = kSceneNoSlot, bound_background = kSceneNoSlot;
  std::uint32_t background_color = kSceneNoSlot;
  std::uint32_t global_ambient = kSceneNoSlot;    ///< Light that is everywhere; times each material's ambient colour.
  std::uint32_t visibility_limit = kSceneNoSlot;  ///< Of the bound NavigationInfo: nothing farther is drawn; 0: no limit.
};

/// Whether some shape stands in the world; a backdrop alone shows no effect.
bool has_world_shapes(const Scene& scene);

/// The shapes of a graph. With `all_branches` (lint), every child of a Switch and every disabled effect is taken too.
struct SceneOptions {
  bool all_branches = false;
  NodeId alone = {};  ///< Only this effect, on the appended stage of library_stage.h; the rest of the graph takes no part.
  std::vector<std::string> dynamic = {};  ///< `DEF.field`: fields that the host may change, besides those that a ROUTE writes.
  ShadowDefaults shadows = {};
  std::vector<ShadowChoice> choices = {};  ///< For shadow maps of this scene, instead of `shadows`.
};
Scene build_scene(const NodeGraph& graph, SourceSet& sources, FileAccess& files, const SceneOptions& options,
                  Diagnostics& diagnostics);

/// `plugc inspect --dump scene`.
std::string dump_scene(const Scene& scene);

}  // namespace plugc

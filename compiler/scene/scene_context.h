#pragma once
// What the passes that build a Scene share. Internal to the scene room: build_scene.cpp walks the tree, scene_lights.cpp,
// scene_appearance.cpp and scene_textures.cpp turn single nodes into plain data.

#include <array>
#include <map>
#include <set>
#include <vector>

#include "scene/event_flow.h"
#include "scene/scene.h"
#include "scene/scene_values.h"

namespace plugc {

/// A Background and where it stands.
struct BoundBackground {
  NodeId node;
  int transform = -1;
};

/// The nodes of one kind that may be bound.
struct BindStack {
  bool changes = false;                ///< Events may bind another than the first, or none.
  std::vector<NodeId> nodes;           ///< In the order of the document; without changes the first alone. Viewpoints are those
                                       ///< of the scene one by one; the second place of one is not valid.
  std::set<NodeId> known;              ///< Those nodes.
  std::vector<int> transforms;         ///< Where they stand.
  int first = -1;                      ///< The one that is bound at the start; -1: none.
  std::uint32_t index = kSceneNoSlot;  ///< The slot of the one that is bound now, where somebody asks.
};

struct SceneContext {
  SceneContext(const NodeGraph& node_graph, SourceSet& source_set, FileAccess& file_access, const SceneOptions& scene_options,
               Diagnostics& sink)
      : graph(node_graph),
        sources(source_set),
        files(file_access),
        options(scene_options),
        diagnostics(sink),
        dynamic(find_dynamic_fields(node_graph, scene_options.dynamic, scene.known_dynamic, sink)),
        code_files{source_set, file_access, sink},
        scripts(read_scripts(node_graph, code_files, sink)),
        live(find_live_fields(node_graph, scripts, dynamic)),
        slots(node_graph, scene.slots, dynamic) {}

  const NodeGraph& graph;
  SourceSet& sources;
  FileAccess& files;
  const SceneOptions& options;
  Diagnostics& diagnostics;
  Scene scene;
  std::vector<DynamicField> dynamic;
  CodeFiles code_files;
  Scripts scripts;
  std::set<EventField> live;  ///< Where events can happen while nobody touches the scene.
  SlotTable slots;
  std::array<BindStack, kBindKinds> stacks;     ///< By BindKind.
  std::map<NodeId, VertexField> vertex_fields;  ///< Those of the scene, until all are found.
  std::vector<SceneEventNode> chooses;          ///< What follows from what is bound; evaluated last.
  std::map<NodeId, int> effects, shaders, textures, texture_transforms, materials, projectors;  ///< -1: takes no part.
  std::map<NodeId, int> back_materials;               ///< Of TwoSidedMaterial: what it says of back faces.
  std::map<NodeId, int> sensor_transforms;            ///< Where each ProximitySensor stands first.
  std::set<NodeId> gradients;                         ///< Backgrounds that are more than one colour.
  std::set<NodeId> screen_effects;                    ///< That were met.
  std::map<NodeId, int> own_viewpoints;               ///< Transforms of those in the scenes of rendered textures.
  std::map<int, BoundBackground> own_backgrounds;     ///< By rendered texture.
  std::map<std::pair<NodeId, int>, int> shadow_maps;  ///< By GeneratedShadowMap and light; -1: never drawn.
};

/// A node's DEF name, or its type.
std::string node_label(const NodeGraph& graph, NodeId node);

/// The effect's index; -1 when it is off, in an unknown language, or NULL.
int effect_index(SceneContext& context, NodeId effect);
/// The `effects` field of an Appearance, a light or a texture.
std::vector<int> effect_list(SceneContext& context, NodeId owner);
/// Of the node's `shaders`, the first that can be used (X3D 4.1, 31.4.1); -1: none.
int usable_shader(SceneContext& context, NodeId owner);
/// A texture that a sampler reads or that is code; -1 for NULL, MultiTexture and what is no texture (reported).
int texture_index(SceneContext& context, NodeId texture);
/// The transform of a unit's coordinates: a single one serves the first unit, MultiTextureTransform each its own; -1 for none.
int unit_transform(SceneContext& context, NodeId transform, std::size_t unit);
/// The unit of a geometry's coordinates that a material's `...TextureMapping` names (X3D 4.1, 12.4.2); the first without one.
int coordinate_unit(const NodeGraph& graph, NodeId geometry, std::string_view mapping);
/// Adds the material's textures beside its main ones.
void read_material_textures(SceneContext& context, NodeId material, NodeId transform, SceneShape& shape);
/// Adds the engine's `normalMap` of an Appearance, where the material has no normal map of its own.
void read_normal_map(SceneContext& context, NodeId appearance, SceneShape& shape);
/// What a MultiTexture says of its texture of that index; nullopt for one that is OFF.
std::optional<TextureCombination> read_combination(const NodeGraph& graph, NodeId multi_texture, std::size_t index);
/// The textures of a shape's material: `texture` may be a MultiTexture, `transform` a MultiTextureTransform.
void read_textures(SceneContext& context, NodeId texture, NodeId transform, SceneShape& shape);
/// Where the coordinates of the shape's textures come from; after its textures and geometry are known.
void read_texture_coordinates(SceneContext& context, SceneShape& shape);

/// Makes slots of the lists below the geometry that events may change, in context.vertex_fields.
void read_vertex_fields(SceneContext& context, NodeId geometry);

/// Fills what the Appearance says: material, textures, effects, shader, blending.
void read_appearance(SceneContext& context, NodeId appearance, SceneShape& shape);

/// A MatrixTransform where it stands, as a Transform that does the same.
SceneTransform read_matrix_transform(SceneContext& context, NodeId node, int parent);

/// Fills what the Appearance says of alpha, lines, points and the filling of faces.
void read_style(SceneContext& context, NodeId appearance, SceneShape& shape);
/// A ClipPlane where it stands; -1 for one that is off for good.
int add_clip_plane(SceneContext& context, NodeId plane, int transform);

/// A Fog or LocalFog where it stands; -1 when its visibilityRange says that there is none.
int add_fog(SceneContext& context, NodeId fog, int transform);
/// Lets the rendered textures that show the world with a fog of their own lend it to the world's, which is added where there is
/// none. `bound` is the world's: none yet, or -1 for one that hides nothing.
void lend_own_fogs(SceneContext& context, std::optional<int>& bound);

/// The shapes of the bound Background: its gradients and pictures.
void add_backdrop(SceneContext& context, NodeId background, int transform);
/// Says that events do not change a gradient, which is a mesh. (One colour alone is a slot, which they do reach.) After all
/// backdrops are added.
void report_events_to_gradients(const SceneContext& context);

/// What a RenderedTexture or GeneratedCubeMapTexture draws, into context.scene.rendered_textures; -1 for another node.
int rendered_texture_index(SceneContext& context, NodeId texture);

/// Takes what a rendered texture's own scene is seen through: the first Viewpoint and Background there. False for another node.
bool bind_in_own_scene(SceneContext& context, NodeId node, int transform, int texture);
/// Gives each of the shapes that mirror through one texture a texture of its own.
void separate_mirrors(Scene& scene, std::map<int, BoundBackground>& own_backgrounds);
/// Puts the textures of a texture's own scene before it.
void sort_rendered_textures(SceneContext& context);

/// A ScreenEffect where it stands, unless it is off for good or has no shader (reported).
void add_screen_effect(SceneContext& context, NodeId effect, int transform);

/// A viewpoint where it stands.
SceneViewpoint read_viewpoint(SceneContext& context, NodeId viewpoint, int transform);

/// What ProjectedTextureCoordinate names, or the point light of a map; -1 for a node that cannot project. Filled by
/// finish_projections().
int projector_index(SceneContext& context, NodeId projector);
/// Once the lights are finished: finds where projectors stand and which maps GeneratedShadowMap textures read. A texture whose
/// light shines on its shape becomes that light's shadow there.
void finish_projections(SceneContext& context);

/// A light where it stands; its index in context.scene.lights.
int add_light(SceneContext& context, NodeId light, int transform);
/// The light that NavigationInfo puts on the camera, if any.
void add_headlight(SceneContext& context, NodeId navigation_info);
/// The projection of a light's map, made if it has none yet; -1 for a light that cannot have one (reported).
int projection_of_light(SceneContext& context, int light);
/// The map of that light as a GeneratedShadowMap node describes it; -1 when it is never drawn (reported once).
int shadow_map_of_node(SceneContext& context, NodeId map, int light);
/// Numbers lights as effects do, resolves who shadows whom, and makes the shadow maps that some shape looks into.
/// `appearances` holds that of each shape, whose receiveShadows counts; not valid for none.
void finish_lights(SceneContext& context, const std::vector<NodeId>& appearances);

}  // namespace plugc

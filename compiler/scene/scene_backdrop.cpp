// The bound Background (X3D 4.1, clause 24). One colour alone is what the picture is cleared with. Anything more becomes shapes
// around the eye: the gradients, and over them each side of the cube that has a picture. They are drawn as any other shape is,
// by programs that other unlit shapes may share.

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "scene/scene_context.h"
#include "scene/scene_events.h"

namespace plugc {
namespace {

struct Side {
  ScenePart part;
  std::string_view url, texture;  // the fields of a Background and of a TextureBackground
};

constexpr std::array<Side, 6> kSides = {{{ScenePart::back, "backUrl", "backTexture"},
                                         {ScenePart::bottom, "bottomUrl", "bottomTexture"},
                                         {ScenePart::front, "frontUrl", "frontTexture"},
                                         {ScenePart::left, "leftUrl", "leftTexture"},
                                         {ScenePart::right, "rightUrl", "rightTexture"},
                                         {ScenePart::top, "topUrl", "topTexture"}}};

/// The first colour fills the whole sphere where no angle says how far it goes.
bool has_gradient(const NodeGraph& graph, NodeId background) {
  const auto is_divided = [&](std::string_view colors, std::string_view angles) {
    return !graph.field(background, angles).numbers.empty() && !graph.field(background, colors).numbers.empty();
  };
  return is_divided("skyColor", "skyAngle") || is_divided("groundColor", "groundAngle");
}

SceneShape backdrop_shape(const SceneContext& context, NodeId background, int transform, ScenePart part) {
  SceneShape shape;
  shape.name = node_label(context.graph, background);
  shape.node = background;
  shape.geometry = background;
  shape.transform = transform;
  shape.casts_shadow = false;
  shape.part = part;
  return shape;
}

int add_picture(SceneContext& context, NodeId background, std::string_view url_field) {
  SceneTexture texture;
  texture.node = background;
  texture.url_field = url_field;
  texture.wrap_s = texture.wrap_t = Wrap::clamp_to_edge;
  context.scene.textures.push_back(std::move(texture));
  return static_cast<int>(context.scene.textures.size() - 1);
}

/// The same texture, but filtering at an edge of the cube does not reach over to the opposite edge.
int without_repeat(SceneContext& context, int texture) {
  SceneTexture copy = context.scene.textures[static_cast<std::size_t>(texture)];
  if (copy.kind != TextureKind::image_2d) return texture;
  copy.wrap_s = copy.wrap_t = Wrap::clamp_to_edge;
  context.scene.textures.push_back(std::move(copy));
  return static_cast<int>(context.scene.textures.size() - 1);
}

void read_side_textures(SceneContext& context, const Side& side, SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  if (graph.is(shape.node, "TextureBackground")) {
    read_textures(context, graph.child(shape.node, side.texture), NodeId(), shape);
    for (TextureUse& use : shape.textures) use.texture = without_repeat(context, use.texture);
  } else if (!graph.field(shape.node, side.url).strings.empty()) {
    TextureUse use;
    use.texture = add_picture(context, shape.node, side.url);
    shape.textures.push_back(use);
  }
}

/// The engine whose extension they are gives a Background's effects and shaders to its pictures alone.
void read_side_shaders(SceneContext& context, SceneShape& shape) {
  shape.effects = effect_list(context, shape.node);
  shape.shader = usable_shader(context, shape.node);
}

/// Of an ImageBackground: where on its picture a place of the whole picture is, from the corners' texture coordinates (from the
/// lower left one on, counter-clockwise).
int picture_transform(SceneContext& context, NodeId background) {
  constexpr std::array<double, 8> kWhole = {0, 0, 1, 0, 1, 1, 0, 1};
  const std::span<const double> written = context.graph.field(background, "texCoords").numbers;
  const std::span<const double> at = written.size() == kWhole.size() ? written : std::span<const double>(kWhole);
  SceneTextureTransform transform;
  transform.matrix = context.slots.constant(SlotType::mat4, {at[2] - at[0], at[3] - at[1], 0, 0,  //
                                                             at[6] - at[0], at[7] - at[1], 0, 0,  //
                                                             0, 0, 1, 0,                          //
                                                             at[0], at[1], 0, 1});
  context.scene.texture_transforms.push_back(transform);
  return static_cast<int>(context.scene.texture_transforms.size() - 1);
}

int picture_material(SceneContext& context, NodeId background) {
  const auto color = context.graph.field(background, "color").numbers;
  SceneMaterial material;
  material.emissive = context.slots.slot(background, "color");
  material.transparency = context.slots.constant(SlotType::float_, {color.size() > 3 ? 1 - color[3] : 0});
  context.scene.materials.push_back(material);
  return static_cast<int>(context.scene.materials.size() - 1);
}

/// An ImageBackground (the engine's) lies over the whole picture, whatever the camera: on the cube around the eye, each place
/// of which shows what of the image is where it is in the picture.
void add_image(SceneContext& context, NodeId background) {
  const NodeId texture = context.graph.child(background, "texture");
  if (!texture.valid()) return;
  const int transform = picture_transform(context, background), material = picture_material(context, background);
  for (const Side& side : kSides) {
    SceneShape shape = backdrop_shape(context, background, -1, side.part);
    shape.material = material;
    read_textures(context, texture, NodeId(), shape);
    for (TextureUse& use : shape.textures) {
      use.generator = CoordGenerator::mirror_plane;
      use.transform = transform;
    }
    context.scene.shapes.push_back(std::move(shape));
  }
}

}  // namespace

void add_backdrop(SceneContext& context, NodeId background, int transform) {
  Scene& scene = context.scene;
  if (has_gradient(context.graph, background)) {
    context.gradients.insert(background);
    scene.shapes.push_back(backdrop_shape(context, background, transform, ScenePart::gradient));
  }
  if (context.graph.is(background, "ImageBackground")) return add_image(context, background);
  for (const Side& side : kSides) {
    SceneShape shape = backdrop_shape(context, background, transform, side.part);
    read_side_textures(context, side, shape);
    if (shape.textures.empty()) continue;
    read_texture_coordinates(context, shape);
    read_side_shaders(context, shape);
    scene.shapes.push_back(std::move(shape));
  }
}

/// What is sent there by a node whose events are not made is told of with the other events.
void report_events_to_gradients(const SceneContext& context) {
  constexpr std::string_view kFields[] = {"skyColor", "skyAngle", "groundColor", "groundAngle"};
  if (context.gradients.empty()) return;
  for (const GraphRoute& route : context.graph.routes()) {
    if (!context.gradients.contains(route.to) || std::ranges::find(kFields, route.to_field) == std::end(kFields)) continue;
    if (context.slots.find(route.to, route.to_field) &&
        is_unmade(context.graph, context.scripts, {route.from, route.from_field}))
      continue;
    context.diagnostics.report(DiagnosticId::event_ignored, route.span,
                               fmt::format("events to `{}.{}` are not followed where there is a gradient: it keeps its first "
                                           "colours",
                                           context.graph[route.to].info->name, route.to_field));
  }
}

bool has_world_shapes(const Scene& scene) {
  return std::ranges::any_of(scene.shapes, [](const SceneShape& shape) { return shape.part == ScenePart::world; });
}

}  // namespace plugc

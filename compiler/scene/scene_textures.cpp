// Texture nodes as plain data: which sampler reads each, how the textures of a shape are combined, and where their
// coordinates come from. A node is turned once, however often it is USEd.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene/movie_url.h"
#include "scene/scene_context.h"

namespace plugc {
namespace {

/// What plugc knows of a type of texture node. Types that it does not draw yet are read by their sampler all the same, so
/// that the programs of their shapes are the ones that they will be drawn with.
struct TextureType {
  std::string_view name;
  TextureKind kind;
  bool has_pixels;
  bool drawn;
};

constexpr TextureType kTextureTypes[] = {
    {"ImageTexture", TextureKind::image_2d, true, true},         {"PixelTexture", TextureKind::image_2d, true, true},
    {"ImageTexture3D", TextureKind::image_3d, true, true},       {"PixelTexture3D", TextureKind::image_3d, true, true},
    {"ComposedTexture3D", TextureKind::image_3d, true, true},    {"ImageCubeMapTexture", TextureKind::cube, true, true},
    {"ComposedCubeMapTexture", TextureKind::cube, true, true},   {"ShaderTexture", TextureKind::shader, false, true},
    {"MovieTexture", TextureKind::image_2d, true, true},         {"RenderedTexture", TextureKind::image_2d, false, true},
    {"GeneratedCubeMapTexture", TextureKind::cube, false, true}, {"GeneratedShadowMap", TextureKind::shadow_2d, false, true},
};

const TextureType* find_type(const NodeGraph& graph, NodeId node) {
  const auto* found = std::ranges::find(kTextureTypes, graph[node].info->name, &TextureType::name);
  return found == std::end(kTextureTypes) ? nullptr : found;
}

/// The texture's TextureProperties; not valid without any.
NodeId properties_of(const NodeGraph& graph, NodeId texture) {
  if (!graph.has_field(texture, "textureProperties")) return {};
  const NodeId properties = graph.child(texture, "textureProperties");
  return graph.is(properties, "TextureProperties") ? properties : NodeId();
}

/// Its border would be transparent black where nobody wrote one. The reference engine continues the edge, measured.
bool has_border(const NodeGraph& graph, NodeId properties) {
  return graph.is_written(properties, "borderColor") || graph.integer(properties, "borderWidth") > 0;
}

/// `repeatS` and its like, unless TextureProperties say more (X3D 4.1, 18.4.7).
Wrap read_wrap(const NodeGraph& graph, NodeId texture, std::string_view repeat, std::string_view boundary_mode) {
  if (const NodeId properties = properties_of(graph, texture); properties.valid()) {
    const std::string_view mode = graph.string(properties, boundary_mode);
    if (mode == "MIRRORED_REPEAT") return Wrap::mirrored_repeat;
    if (mode == "CLAMP_TO_BOUNDARY" && has_border(graph, properties)) return Wrap::clamp_to_border;
    return mode == "REPEAT" ? Wrap::repeat : Wrap::clamp_to_edge;
  }
  const bool repeats = !graph.has_field(texture, repeat) || graph.boolean(texture, repeat);
  return repeats ? Wrap::repeat : Wrap::clamp_to_edge;
}

VertexCoord default_coord(const NodeGraph& graph, NodeId texture, TextureKind kind) {
  if (kind == TextureKind::image_3d || kind == TextureKind::cube) return VertexCoord::bounds_3d;  // X3D 4.1, 33.2.4
  const bool in_3d = kind == TextureKind::shader && graph.string(texture, "defaultTexCoord") == "BOUNDS3D";
  return in_3d ? VertexCoord::bounds_3d : VertexCoord::own;
}

/// TextureProperties' filters (X3D 4.1, tables 18.7 and 18.8); what only says how fast or nice is plugc's choice.
TextureFilter read_minification(std::string_view name) {
  if (name == "AVG_PIXEL" || name == "LINEAR") return TextureFilter::linear;
  if (name == "NEAREST_PIXEL" || name == "NEAREST") return TextureFilter::nearest;
  if (name == "NEAREST_PIXEL_NEAREST_MIPMAP" || name == "NEAREST_MIPMAP_NEAREST") return TextureFilter::nearest_mipmap_nearest;
  return TextureFilter::linear_mipmap_linear;
}

TextureFilter read_magnification(std::string_view name) {
  return name == "NEAREST_PIXEL" || name == "NEAREST" ? TextureFilter::nearest : TextureFilter::linear;
}

void read_properties(const NodeGraph& graph, NodeId node, SceneTexture& texture) {
  const NodeId properties = properties_of(graph, node);
  if (!properties.valid()) return;
  const auto border = graph.field(properties, "borderColor").numbers;
  std::copy_n(border.begin(), std::min(border.size(), texture.border_color.size()), texture.border_color.begin());
  texture.minification = read_minification(graph.string(properties, "minificationFilter"));
  texture.magnification = read_magnification(graph.string(properties, "magnificationFilter"));
}

/// A point light's map is a cube; one that is not to compare is a grey picture.
void read_comparison(const NodeGraph& graph, NodeId node, SceneTexture& texture) {
  const std::string_view mode = graph.string(node, "compareMode");
  const bool cube = graph.is(graph.child(node, "light"), "PointLight");
  texture.kind = mode == "NONE" ? (cube ? TextureKind::cube : TextureKind::image_2d)
                                : (cube ? TextureKind::shadow_cube : TextureKind::shadow_2d);
  if (mode == "COMPARE_R_GEQUAL") texture.compare = DepthCompare::greater_equal;
}

/// Of a MovieTexture its first picture is drawn, where a picture is what its url names.
bool has_first_picture(SceneContext& context, NodeId node) {
  if (has_picture_url(context.graph, node)) return true;
  context.diagnostics.report(DiagnosticId::not_drawn, context.graph[node].type_span,
                             "a white texel stands for this `MovieTexture`: none of its urls names a picture, and movie files "
                             "are not decoded; a series of pictures is written `fire@counter(4).png`");
  return false;
}

SceneTexture read_texture(SceneContext& context, NodeId node, const TextureType& type) {
  const NodeGraph& graph = context.graph;
  SceneTexture texture;
  texture.kind = type.kind;
  texture.node = node;
  if (type.kind == TextureKind::shadow_2d) read_comparison(graph, node, texture);
  texture.has_pixels = type.has_pixels && (type.name != "MovieTexture" || has_first_picture(context, node));
  texture.wrap_s = read_wrap(graph, node, "repeatS", "boundaryModeS");
  texture.wrap_t = read_wrap(graph, node, "repeatT", "boundaryModeT");
  texture.wrap_r = read_wrap(graph, node, "repeatR", "boundaryModeR");
  read_properties(graph, node, texture);
  texture.default_coord = default_coord(graph, node, type.kind);
  texture.effects = effect_list(context, node);
  texture.rendered = rendered_texture_index(context, node);
  return texture;
}

SceneTextureTransform read_transform(SlotTable& slots, const NodeGraph& graph, NodeId node) {
  SceneTextureTransform transform;
  if (graph.is(node, "TextureTransformMatrix3D")) {
    transform.matrix = slots.slot(node, "matrix");
    return transform;
  }
  transform.translation = slots.slot(node, "translation");
  transform.rotation = slots.slot(node, "rotation");
  transform.scale = slots.slot(node, "scale");
  transform.center = slots.slot(node, "center");
  return transform;
}

int texture_transform_index(SceneContext& context, NodeId node) {
  const bool known = context.graph.is(node, "TextureTransform") || context.graph.is(node, "TextureTransform3D") ||
                     context.graph.is(node, "TextureTransformMatrix3D");
  if (!known) return -1;
  const auto [found, added] =
      context.texture_transforms.try_emplace(node, static_cast<int>(context.scene.texture_transforms.size()));
  if (added) context.scene.texture_transforms.push_back(read_transform(context.slots, context.graph, node));
  return found->second;
}

struct GeneratorMode {
  std::string_view name;
  CoordGenerator generator;
};

/// COORD-EYE and CAMERASPACEPOSITION are one; of any other name, the geometry's own coordinates are used.
constexpr GeneratorMode kGeneratorModes[] = {
    {"SPHERE", CoordGenerator::sphere},
    {"CAMERASPACENORMAL", CoordGenerator::camera_space_normal},
    {"CAMERASPACEPOSITION", CoordGenerator::camera_space_position},
    {"CAMERASPACEREFLECTIONVECTOR", CoordGenerator::camera_space_reflection},
    {"SPHERE-LOCAL", CoordGenerator::sphere_local},
    {"COORD", CoordGenerator::coord},
    {"COORD-EYE", CoordGenerator::camera_space_position},
    {"NOISE", CoordGenerator::noise},
    {"NOISE-EYE", CoordGenerator::noise_eye},
    {"SPHERE-REFLECT", CoordGenerator::sphere_reflect},
    {"SPHERE-REFLECT-LOCAL", CoordGenerator::sphere_reflect_local},
    {"WORLDSPACENORMAL", CoordGenerator::world_space_normal},
    {"WORLDSPACEREFLECTIONVECTOR", CoordGenerator::world_space_reflection},
    {"MIRROR-PLANE", CoordGenerator::mirror_plane},
};

/// parameter[0] is an index of refraction, parameter[1] to [3] an eye point; 1 0 0 0 where nothing is said.
std::uint32_t generator_parameter(SceneContext& context, NodeId generator) {
  std::vector<double> values = {1, 0, 0, 0};
  const auto written = context.graph.field(generator, "parameter").numbers;
  std::copy_n(written.begin(), std::min(written.size(), values.size()), values.begin());
  return context.slots.constant(SlotType::vec4, std::move(values));
}

/// Coordinates as the light or viewpoint in that field sees the vertex; without one, the mesh's own.
void project_from(SceneContext& context, NodeId node, std::string_view field, TextureUse& use) {
  use.projector = projector_index(context, context.graph.child(node, field));
  if (use.projector >= 0) use.generator = CoordGenerator::projection;
}

void read_generator(SceneContext& context, NodeId node, const SceneTexture& texture, TextureUse& use) {
  const std::string_view mode = context.graph.string(node, "mode");
  if (mode == "PROJECTION") return project_from(context, node, "projectedLight", use);
  if (mode == "BOUNDS" || mode == "BOUNDS2D" || mode == "BOUNDS3D") {
    const bool in_3d = mode == "BOUNDS3D" || (mode == "BOUNDS" && texture.default_coord == VertexCoord::bounds_3d);
    use.coord = in_3d ? VertexCoord::bounds_3d : VertexCoord::bounds_2d;
    return;
  }
  const auto* found = std::ranges::find(kGeneratorModes, mode, &GeneratorMode::name);
  if (found == std::end(kGeneratorModes)) return;  // no mode at all, which is told
  use.generator = found->generator;
  const bool reflects =
      use.generator == CoordGenerator::sphere_reflect || use.generator == CoordGenerator::sphere_reflect_local;
  if (reflects) use.parameter = generator_parameter(context, node);
}

/// No texture coordinate node knows where a vertex lies in the map of a point light: such a map brings its own.
bool is_point_light_map(const NodeGraph& graph, NodeId texture) {
  return graph.is(texture, "GeneratedShadowMap") && graph.is(graph.child(texture, "light"), "PointLight");
}

/// The node that gives the coordinates of a unit: of too few, the last serves all others (X3D 4.1, 18.4.5).
NodeId unit_coordinates(const NodeGraph& graph, NodeId geometry, int unit) {
  if (!graph.has_field(geometry, "texCoord")) return {};
  const NodeId written = graph.child(geometry, "texCoord");
  if (!graph.is(written, "MultiTextureCoordinate")) return written;
  const auto list = graph.children(written, "texCoord");
  return list.empty() ? NodeId() : list[std::min(static_cast<std::size_t>(unit), list.size() - 1)];
}

}  // namespace

int texture_index(SceneContext& context, NodeId node) {
  if (!node.valid()) return -1;
  if (const auto found = context.textures.find(node); found != context.textures.end()) return found->second;
  int& index = context.textures[node] = -1;
  const std::string_view name = context.graph[node].info->name;
  const TextureType* type = find_type(context.graph, node);
  if (type == nullptr || !type->drawn) {
    const std::string_view what = type == nullptr ? "is no texture that one sampler reads; it is left out"
                                                  : "is not drawn yet; a white texel stands for it";
    context.diagnostics.report(DiagnosticId::not_drawn, context.graph[node].type_span, fmt::format("a `{}` {}", name, what));
  }
  if (type == nullptr) return -1;
  SceneTexture texture = read_texture(context, node, *type);
  context.scene.textures.push_back(std::move(texture));
  return index = static_cast<int>(context.scene.textures.size() - 1);
}

int unit_transform(SceneContext& context, NodeId transform, std::size_t unit) {
  const NodeGraph& graph = context.graph;
  if (!graph.is(transform, "MultiTextureTransform")) return unit == 0 ? texture_transform_index(context, transform) : -1;
  const auto list = graph.children(transform, "textureTransform");
  return unit < list.size() ? texture_transform_index(context, list[unit]) : -1;
}

void read_textures(SceneContext& context, NodeId texture, NodeId transform, SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  const bool multi = graph.is(texture, "MultiTexture");
  const bool has_units = graph.is(transform, "MultiTextureTransform");  // a single one does nothing to several textures
  const std::vector<NodeId> single = {texture};
  const auto list = multi ? graph.children(texture, "texture") : std::span<const NodeId>(single);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto combination = multi ? read_combination(graph, texture, i) : TextureCombination();
    if (!combination) continue;
    TextureUse use;
    use.texture = texture_index(context, list[i]);
    if (use.texture < 0) continue;
    use.combination = *combination;
    use.transform = multi && !has_units ? -1 : unit_transform(context, transform, i);
    use.unit = static_cast<int>(i);
    shape.textures.push_back(use);
  }
  if (!multi) return;
  shape.multi_color = context.slots.slot(texture, "color");
  shape.multi_alpha = context.slots.slot(texture, "alpha");
}

void read_texture_coordinates(SceneContext& context, SceneShape& shape) {
  for (TextureUse& use : shape.textures) {
    const SceneTexture& texture = context.scene.textures[static_cast<std::size_t>(use.texture)];
    if (is_point_light_map(context.graph, texture.node)) {
      project_from(context, texture.node, "light", use);
      continue;
    }
    const NodeId given = unit_coordinates(context.graph, shape.geometry, use.unit);
    if (!given.valid()) use.coord = texture.default_coord;
    if (context.graph.is(given, "TextureCoordinateGenerator")) read_generator(context, given, texture, use);
    if (context.graph.is(given, "ProjectedTextureCoordinate")) project_from(context, given, "projector", use);
  }
}

}  // namespace plugc

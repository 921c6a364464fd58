// A program's uniforms are those that reflection found active. Each is fed by the field that composing noted for it, else by
// what its castle_ name means for this shape: the second light of its list, its material, the camera.

#include "package/pack_program.h"

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "base/limits.h"
#include "compose/castle_names.h"
#include "compose/check_fields.h"
#include "compose/sampler_type.h"
#include "compose/screen_library.h"
#include "package/pack_attributes.h"
#include "package/pack_fog.h"
#include "package/pack_shape.h"
#include "package/pack_style.h"
#include "package/target_variables.h"

namespace plugc {
namespace {

PackedUniformType pack_type(std::string_view type) {
  static const std::map<std::string_view, PackedUniformType> kTypes = {
      {"bool", PackedUniformType::bool_},
      {"int", PackedUniformType::int_},
      {"float", PackedUniformType::float_},
      {"vec2", PackedUniformType::vec2},
      {"vec3", PackedUniformType::vec3},
      {"vec4", PackedUniformType::vec4},
      {"ivec2", PackedUniformType::ivec2},
      {"ivec3", PackedUniformType::ivec3},
      {"ivec4", PackedUniformType::ivec4},
      {"mat3", PackedUniformType::mat3},
      {"mat4", PackedUniformType::mat4},
      {"sampler2D", PackedUniformType::sampler2D},
      {"sampler3D", PackedUniformType::sampler3D},
      {"samplerCube", PackedUniformType::samplerCube},
      {"sampler2DShadow", PackedUniformType::sampler2DShadow},
      {"samplerCubeShadow", PackedUniformType::samplerCubeShadow}};
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? PackedUniformType::float_ : found->second;
}

std::unique_ptr<PackedTargetProgramT> pack_target(const ValidatedProgram& program, SourceList& sources) {
  auto packed = std::make_unique<PackedTargetProgramT>();
  packed->target = static_cast<PackedTarget>(program.target());
  for (std::size_t i = 0; i < program.stages().size(); ++i) {
    auto stage = std::make_unique<PackedStageT>();
    stage->kind = static_cast<PackedStageKind>(program.stages()[i].stage);
    stage->text = program.stages()[i].text.text();
    stage->origins = sources.origins(program.stages()[i].text);
    stage->columns = sources.columns(program.stages()[i].text, stage->origins);
    if (i < program.spirv().size()) stage->spirv = program.spirv()[i];
    packed->stages.push_back(std::move(stage));
  }
  return packed;
}

/// What the uniform's declaration gives it; nothing where that does not fit its type.
std::vector<double> initial_of(const UniformOfTargets& uniform, PackedUniformType type) {
  const FieldUniform* field = uniform.fed.field;
  const bool fits = field != nullptr && field->initial.size() == uniform.variable.count * component_count(type);
  return fits ? field->initial : std::vector<double>();
}

std::unique_ptr<PackedUniformT> pack_uniform(const UniformOfTargets& uniform) {
  auto packed = std::make_unique<PackedUniformT>();
  packed->name = uniform.variable.name;
  packed->type = pack_type(uniform.variable.type);
  packed->count = uniform.variable.count;
  packed->targets = static_cast<std::uint8_t>(uniform.targets);
  packed->initial = initial_of(uniform, packed->type);
  packed->location = pack_number(uniform.variable.location);
  packed->binding = pack_number(uniform.variable.binding);
  return packed;
}

std::optional<PackedBinding> projector_binding(const Scene& scene, std::uint32_t index, const TextureUse& use) {
  if (use.generator == CoordGenerator::mirror_plane)
    return PackedBinding(index, 0, 0, 1, PackedSource::mirror_projector_matrix);
  if (use.projector < 0) return std::nullopt;
  const SceneProjector& found = scene.projectors[static_cast<std::size_t>(use.projector)];
  if (found.shadow_map >= 0)
    return PackedBinding(index, static_cast<std::uint32_t>(found.shadow_map), 0, 1, PackedSource::projector_matrix);
  if (!found.viewpoint.node.valid()) return std::nullopt;
  const auto standing = std::ranges::find(scene.viewpoints, found.viewpoint.node, &SceneViewpoint::node);
  const auto number =
      standing == scene.viewpoints.end() ? 0 : static_cast<std::uint32_t>(standing - scene.viewpoints.begin() + 1);
  return PackedBinding(index, static_cast<std::uint32_t>(use.projector), number, 1, PackedSource::viewpoint_projector_matrix);
}

PackedSource screen_source(ScreenValue value) {
  switch (value) {
    case ScreenValue::color: return PackedSource::screen_color;
    case ScreenValue::depth: return PackedSource::screen_depth;
    case ScreenValue::width: return PackedSource::screen_width;
    case ScreenValue::height: break;
  }
  return PackedSource::screen_height;
}

class Binder {
 public:
  Binder(const ValidRecipe& recipe, const BindingContext& context) : recipe_(recipe), c_(context) {
    if (context.shape.material >= 0) material_ = context.scene.materials[static_cast<std::size_t>(context.shape.material)];
  }
  std::vector<PackedBinding> bind();

 private:
  void bind_uniform(std::uint32_t index, const UniformOfTargets& uniform);
  void bind_switch(std::uint32_t index, const SwitchUniform& one);
  void bind_field(std::uint32_t index, const ReflectedVariable& uniform, const FieldUniform& field);
  void bind_castle(std::uint32_t index, const CastleName& name);
  void bind_light(std::uint32_t index, PackedSource source, int number);
  void bind_map(std::uint32_t index, int map, DepthCompare compare, std::uint32_t element = 0);
  void bind_shadow(std::uint32_t index, PackedSource source, int number);
  void bind_own_map(std::uint32_t index, PackedSource source) {
    if (c_.shadow_map >= 0) add(index, source, static_cast<std::uint32_t>(c_.shadow_map));
  }
  void bind_material(std::uint32_t index, CastleSource source);
  void bind_fog(std::uint32_t index, CastleSource source);
  void bind_texture(std::uint32_t index, int texture, std::uint32_t element = 0);
  bool reads(std::string_view sampler, int texture) const {
    return sampler_type(c_.scene.textures[static_cast<std::size_t>(texture)].kind) == sampler;
  }
  void bind_texture_matrix(std::uint32_t index, int transform);
  void bind_projector(std::uint32_t index, const TextureUse& use);
  void add(std::uint32_t index, PackedSource source, std::uint32_t a = 0, std::uint32_t b = 0, float scale = 1) {
    bindings_.emplace_back(index, a, b, scale, source);
  }
  const SceneLight* light(int number) const {
    if (number < 0 || static_cast<std::size_t>(number) >= c_.shape.lights.size()) return nullptr;
    return &c_.scene.lights[static_cast<std::size_t>(c_.shape.lights[static_cast<std::size_t>(number)])];
  }

  const ValidRecipe& recipe_;
  const BindingContext& c_;
  SceneMaterial material_;
  std::vector<PackedBinding> bindings_;
};

void Binder::bind_texture(std::uint32_t index, int texture, std::uint32_t element) {
  if (texture < 0) return;
  const SceneTexture& read = c_.scene.textures[static_cast<std::size_t>(texture)];
  if (read.shadow_map >= 0 && read.moments)
    return add(index, PackedSource::shadow_moments, static_cast<std::uint32_t>(read.shadow_map), element);
  if (read.shadow_map >= 0) return bind_map(index, read.shadow_map, read.compare, element);
  if (read.rendered >= 0) return add(index, PackedSource::rendered_texture, static_cast<std::uint32_t>(read.rendered), element);
  const std::uint32_t packed = c_.package_textures[static_cast<std::size_t>(texture)];
  if (packed != kNothing) add(index, PackedSource::texture, packed, element);
}

void Binder::bind_texture_matrix(std::uint32_t index, int transform) {
  if (transform < 0) return;
  const std::uint32_t matrix = c_.scene.texture_transforms[static_cast<std::size_t>(transform)].matrix;
  if (matrix != kSceneNoSlot) return add(index, PackedSource::slot, matrix);
  add(index, PackedSource::texture_matrix, static_cast<std::uint32_t>(transform));
}

void Binder::bind_projector(std::uint32_t index, const TextureUse& use) {
  if (auto binding = projector_binding(c_.scene, index, use)) bindings_.push_back(*binding);
}

void Binder::bind_field(std::uint32_t index, const ReflectedVariable& uniform, const FieldUniform& fed) {
  const bool sampler = is_sampler(uniform.type);
  if (fed.field < 0) {
    // a sampler that nothing feeds sees unit 0, as an unset sampler uniform does in OpenGL
    const auto& used = c_.shape.textures;
    const bool fits = sampler && fed.of_shader && !used.empty() && reads(uniform.type, used.front().texture);
    if (fits) bind_texture(index, used.front().texture);
    return;
  }
  const auto& owners = fed.of_shader ? c_.scene.shaders : c_.scene.effects;
  const ShaderField& field = owners[static_cast<std::size_t>(fed.owner)].fields[static_cast<std::size_t>(fed.field)];
  if (!feeds(c_.scene, field, uniform.type)) return;  // reported by check_fields
  if (sampler) {
    const std::size_t count = std::min<std::size_t>(field.textures.size(), uniform.count);
    for (std::size_t i = 0; i < count; ++i) bind_texture(index, field.textures[i], static_cast<std::uint32_t>(i));
  } else if (field.slot != kSceneNoSlot) {
    add(index, PackedSource::slot, field.slot);
  }
}

void Binder::bind_light(std::uint32_t index, PackedSource source, int number) {
  if (light(number) != nullptr)
    add(index, source, static_cast<std::uint32_t>(c_.shape.lights[static_cast<std::size_t>(number)]));
}

void Binder::bind_map(std::uint32_t index, int map, DepthCompare compare, std::uint32_t element) {
  const bool greater = compare == DepthCompare::greater_equal;
  add(index, greater ? PackedSource::shadow_map_greater : PackedSource::shadow_map, static_cast<std::uint32_t>(map), element);
}

/// The shadow of light `number` as the shape shows it; else, for code that asks all the same, the light's own map.
void Binder::bind_shadow(std::uint32_t index, PackedSource source, int number) {
  const SceneLight* found = light(number);
  if (found == nullptr) return;
  const int light_index = c_.shape.lights[static_cast<std::size_t>(number)];
  const auto& receives = c_.shape.receives;
  const auto received = std::ranges::find(receives, light_index, &ReceivedShadow::light);
  const ReceivedShadow shadow = received == receives.end() ? ReceivedShadow{light_index, found->shadow_map} : *received;
  if (shadow.shadow_map < 0) return;
  if (source == PackedSource::shadow_map) return bind_map(index, shadow.shadow_map, shadow.compare);
  add(index, source, static_cast<std::uint32_t>(shadow.shadow_map));
}

void Binder::bind_material(std::uint32_t index, CastleSource source) {
  const auto slot = [&](std::uint32_t which) {
    if (which != kSceneNoSlot) add(index, PackedSource::slot, which);
  };
  switch (source) {
    case CastleSource::material_diffuse_alpha:
      return add(index, PackedSource::color_and_transparency, material_.diffuse, material_.transparency);
    case CastleSource::unlit_color:
      return add(index, PackedSource::color_and_transparency, material_.emissive, material_.transparency);
    case CastleSource::material_ambient:
      return add(index, PackedSource::slot_product, material_.ambient_color, material_.ambient);
    case CastleSource::material_specular: return slot(material_.specular);
    case CastleSource::material_emissive: return slot(material_.emissive);
    case CastleSource::material_metallic: return slot(material_.metallic);
    case CastleSource::material_roughness: return slot(material_.roughness);
    case CastleSource::material_occlusion_strength: return slot(material_.occlusion_strength);
    case CastleSource::normal_scale: return slot(material_.normal_scale);
    case CastleSource::material_shininess:
      if (material_.shininess != kSceneNoSlot) add(index, PackedSource::slot_scaled, material_.shininess, 0, 128);
      return;
    default: return;
  }
}

void Binder::bind_fog(std::uint32_t index, CastleSource source) {
  if (c_.shape.fog < 0) return;
  const SceneFog& fog = c_.scene.fogs[static_cast<std::size_t>(c_.shape.fog)];
  if (source == CastleSource::fog_color) return add(index, PackedSource::slot, fog.color);
  if (source == CastleSource::fog_exponential) return add(index, PackedSource::slot, fog.exponential);
  add(index, PackedSource::fog_visibility_range, fog.visibility_range, static_cast<std::uint32_t>(fog.transform + 1));
}

void Binder::bind_castle(std::uint32_t index, const CastleName& name) {
  const auto textures = c_.shape.textures;
  const bool has_texture = name.number >= 0 && static_cast<std::size_t>(name.number) < textures.size();
  const TextureUse use = has_texture ? textures[static_cast<std::size_t>(name.number)] : TextureUse();
  switch (name.source) {
    case CastleSource::model_view_matrix: return add(index, PackedSource::model_view_matrix);
    case CastleSource::projection_matrix: return add(index, PackedSource::projection_matrix);
    case CastleSource::normal_matrix: return add(index, PackedSource::normal_matrix);
    case CastleSource::camera_matrix: return add(index, PackedSource::camera_matrix);
    case CastleSource::camera_inverse_matrix: return add(index, PackedSource::camera_inverse_matrix);
    case CastleSource::camera_rotation_matrix: return add(index, PackedSource::camera_rotation_matrix);
    case CastleSource::camera_rotation_inverse_matrix: return add(index, PackedSource::camera_rotation_inverse_matrix);
    case CastleSource::light_position: return bind_light(index, PackedSource::light_position, name.number);
    case CastleSource::light_spot_direction: return bind_light(index, PackedSource::light_spot_direction, name.number);
    case CastleSource::light_spot_cos_cutoff: return bind_light(index, PackedSource::light_spot_cos_cutoff, name.number);
    case CastleSource::light_spot_cutoff: return bind_light(index, PackedSource::light_spot_cutoff, name.number);
    case CastleSource::light_beam_width: return bind_light(index, PackedSource::light_beam_width, name.number);
    case CastleSource::light_radius: return bind_light(index, PackedSource::light_radius, name.number);
    case CastleSource::light_color: return bind_light(index, PackedSource::light_color, name.number);
    case CastleSource::light_ambient_color: return bind_light(index, PackedSource::light_ambient_color, name.number);
    case CastleSource::light_attenuation: return bind_light(index, PackedSource::light_attenuation, name.number);
    case CastleSource::shadow_map: return bind_shadow(index, PackedSource::shadow_map, name.number);
    case CastleSource::projector_matrix: return bind_shadow(index, PackedSource::projector_matrix, name.number);
    case CastleSource::shadow_moments: return bind_shadow(index, PackedSource::shadow_moments, name.number);
    case CastleSource::shadow_depth_plane: return bind_shadow(index, PackedSource::shadow_depth_plane, name.number);
    case CastleSource::shadow_depths: return bind_own_map(index, PackedSource::shadow_depths);
    case CastleSource::shadow_depth_line: return bind_own_map(index, PackedSource::shadow_depth_line);
    case CastleSource::shadow_unblurred: return bind_own_map(index, PackedSource::shadow_unblurred);
    case CastleSource::depth_pass_range: return add(index, PackedSource::depth_pass_range);
    case CastleSource::shadow_intensity:
      if (const SceneLight* found = light(name.number)) add(index, PackedSource::shadow_intensity, found->shadow_intensity);
      return;
    case CastleSource::fog_color:
    case CastleSource::fog_exponential:
    case CastleSource::fog_visibility_range: return bind_fog(index, name.source);
    case CastleSource::global_ambient: return add(index, PackedSource::slot, c_.scene.global_ambient);
    case CastleSource::texture: return bind_texture(index, use.texture);
    case CastleSource::texture_matrix: return bind_texture_matrix(index, use.transform);
    case CastleSource::texture_coord_parameter:
      if (use.parameter != kSceneNoSlot) add(index, PackedSource::slot, use.parameter);
      return;
    case CastleSource::texture_projector: return bind_projector(index, use);
    case CastleSource::multi_texture_color:
      return add(index, PackedSource::color_and_alpha, c_.shape.multi_color, c_.shape.multi_alpha);
    default: break;
  }
  if (const auto style = bind_style(index, name, c_)) bindings_.push_back(*style);
  if (const auto plane = bind_fog_plane(index, name, c_)) bindings_.push_back(*plane);
  bind_material(index, name.source);
}

/// A uniform under which the code of a switched effect or light stands.
void Binder::bind_switch(std::uint32_t index, const SwitchUniform& one) {
  if (one.of_light)
    bind_light(index, PackedSource::light_on, one.index);
  else
    add(index, PackedSource::slot, c_.scene.effects[static_cast<std::size_t>(one.index)].enabled);
}

void Binder::bind_uniform(std::uint32_t index, const UniformOfTargets& uniform) {
  if (uniform.fed.switched != nullptr) return bind_switch(index, *uniform.fed.switched);
  if (uniform.fed.field != nullptr) return bind_field(index, uniform.variable, *uniform.fed.field);
  if (const auto castle = find_castle_name(uniform.variable.name)) return bind_castle(index, *castle);
  if (recipe_.used.screen_pass == ScreenPass::none) return;
  const auto value = find_screen_value(uniform.variable.name);
  const bool is_there = value != ScreenValue::depth || recipe_.used.screen_pass == ScreenPass::color_and_depth;
  if (value && is_there) add(index, screen_source(*value));
}

std::vector<PackedBinding> Binder::bind() {
  const std::vector<UniformOfTargets> uniforms = all_uniforms(recipe_);
  for (std::size_t i = 0; i < uniforms.size(); ++i) bind_uniform(static_cast<std::uint32_t>(i), uniforms[i]);
  return std::move(bindings_);
}

}  // namespace

std::uint32_t SourceList::index(SourceId source) {
  const auto [found, added] = known_.try_emplace(source.value, static_cast<std::uint32_t>(names_->size()));
  if (added) names_->emplace_back(sources_->name(source));
  return found->second;
}

PackedLineOrigin SourceList::origin(const Span& span) {
  if (!span.valid()) return {0, 0};
  return {index(span.source), sources_->line(span.source, span.begin)};
}

std::vector<PackedLineOrigin> SourceList::origins(const MappedText& text) {
  std::vector<PackedLineOrigin> origins;
  const std::string_view all = text.text();
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::size_t word = std::min(all.find_first_not_of(" \t\r", begin), end);
    const Span span = word < end ? text.locate(static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(end)) : Span{};
    origins.push_back(origin(span));
    begin = end + 1;
  }
  return origins;
}

namespace {

/// Every byte at which the map changes, and the first word of every line.
std::vector<std::uint32_t> map_changes(const MappedText& text) {
  std::vector<std::uint32_t> offsets = text.seams();
  const std::string_view all = text.text();
  for (std::size_t begin = 0; begin < all.size(); begin = std::min(all.find('\n', begin), all.size()) + 1)
    offsets.push_back(static_cast<std::uint32_t>(std::min(all.find_first_not_of(" \t\r", begin), all.size() - 1)));
  std::ranges::sort(offsets);
  return offsets;
}

}  // namespace

std::vector<PackedColumnOrigin> SourceList::columns(const MappedText& text, const std::vector<PackedLineOrigin>& origins) {
  std::vector<PackedColumnOrigin> columns;
  const std::string_view all = text.text();
  std::uint32_t line = 1, line_begin = 0;
  std::uint32_t shift = 0;  // from a column of the text to the author's, so far on this line
  for (const std::uint32_t offset : map_changes(text)) {
    for (std::size_t end = all.find('\n', line_begin); end < offset; end = all.find('\n', line_begin)) {
      line_begin = static_cast<std::uint32_t>(end + 1);
      ++line;
      shift = 0;
    }
    const Span span = text.locate(offset, offset + 1);
    if (line > origins.size() || origins[line - 1].line() == 0 || !span.valid()) continue;
    const Position at = sources_->position(span.source, span.begin);
    if (at.line != origins[line - 1].line() || index(span.source) != origins[line - 1].source()) continue;
    const std::uint32_t column = offset - line_begin + 1;
    if (at.column - column == shift) continue;
    shift = at.column - column;
    columns.emplace_back(line, column, at.column);
  }
  return columns;
}

std::unique_ptr<PackedProgramT> pack_program(const ValidRecipe& recipe, std::string name, SourceList& sources) {
  PLUGC_CHECK(!recipe.targets.empty(), "only valid programs are packed");
  auto packed = std::make_unique<PackedProgramT>();
  packed->recipe = std::move(name);
  packed->name = packed->recipe.substr(0, packed->recipe.find(';'));
  for (const TargetProgram& target : recipe.targets) packed->targets.push_back(pack_target(target.program, sources));
  const TargetProgram& first = recipe.targets.front();
  for (const UniformOfTargets& uniform : all_uniforms(recipe)) packed->uniforms.push_back(pack_uniform(uniform));
  packed->attributes = pack_attributes(all_attributes(recipe), recipe.used.screen_pass != ScreenPass::none);
  packed->plugs_filled = first.composed.plugs_filled;
  packed->plugs_empty = first.composed.plugs_empty;
  return packed;
}

std::string program_content(const ValidRecipe& recipe) {
  std::string content;
  for (const TargetProgram& target : recipe.targets) {
    for (const StageText& stage : target.program.stages()) {
      content += static_cast<char>('0' + static_cast<int>(target.program.target()));
      content += static_cast<char>('0' + static_cast<int>(stage.stage));
      content += stage.text.text();
      content += '\0';
    }
    for (const FieldUniform& field : target.composed.fields) {
      for (const double number : field.initial) content.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  }
  // Equal texts of two recipes may be fed differently from target to target: then their lists of uniforms differ.
  for (const UniformOfTargets& uniform : all_uniforms(recipe)) content += static_cast<char>('0' + uniform.targets);
  return content;
}

std::vector<PackedBinding> pack_projected_coords(const BindingContext& context, std::uint32_t units_read) {
  std::vector<PackedBinding> coords;
  if (context.shape.shader < 0) return coords;
  const auto& textures = context.shape.textures;
  const std::size_t units = std::min<std::size_t>({units_read, textures.size(), kMaxTexCoordSets});
  for (std::uint32_t unit = 0; unit < units; ++unit) {
    const CoordGenerator generator = textures[unit].generator;
    if (generator != CoordGenerator::projection && generator != CoordGenerator::mirror_plane) continue;
    if (auto binding = projector_binding(context.scene, unit, textures[unit])) coords.push_back(*binding);
  }
  return coords;
}

std::vector<PackedBinding> pack_bindings(const ValidRecipe& recipe, const BindingContext& context) {
  return Binder(recipe, context).bind();
}

}  // namespace plugc

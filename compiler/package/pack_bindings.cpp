// A program's uniforms are those that reflection found active. Each is fed by the field that composing noted for it, else by
// what its castle_ name means for this shape: the second light of its list, its material, the camera.

#include "package/pack_bindings.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/limits.h"
#include "compose/castle_names.h"
#include "compose/check_fields.h"
#include "compose/sampler_type.h"
#include "compose/screen_library.h"
#include "package/pack_fog.h"
#include "package/pack_shape.h"
#include "package/pack_style.h"
#include "package/target_variables.h"

namespace plugc {
namespace {

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

/// What a name is of: of the camera or the pass, of a light, of a light's shadow, of the map that the program is drawn over.
enum class CastleOwner : std::uint8_t { view, light, shadow, own_map };

struct PlainName {
  CastleSource name;
  PackedSource source;
  CastleOwner owner;
};

constexpr PlainName kPlainNames[] = {
    {CastleSource::model_view_matrix, PackedSource::model_view_matrix, CastleOwner::view},
    {CastleSource::projection_matrix, PackedSource::projection_matrix, CastleOwner::view},
    {CastleSource::normal_matrix, PackedSource::normal_matrix, CastleOwner::view},
    {CastleSource::camera_matrix, PackedSource::camera_matrix, CastleOwner::view},
    {CastleSource::camera_inverse_matrix, PackedSource::camera_inverse_matrix, CastleOwner::view},
    {CastleSource::camera_rotation_matrix, PackedSource::camera_rotation_matrix, CastleOwner::view},
    {CastleSource::camera_rotation_inverse_matrix, PackedSource::camera_rotation_inverse_matrix, CastleOwner::view},
    {CastleSource::depth_pass_range, PackedSource::depth_pass_range, CastleOwner::view},
    {CastleSource::light_position, PackedSource::light_position, CastleOwner::light},
    {CastleSource::light_spot_direction, PackedSource::light_spot_direction, CastleOwner::light},
    {CastleSource::light_spot_cos_cutoff, PackedSource::light_spot_cos_cutoff, CastleOwner::light},
    {CastleSource::light_spot_cutoff, PackedSource::light_spot_cutoff, CastleOwner::light},
    {CastleSource::light_beam_width, PackedSource::light_beam_width, CastleOwner::light},
    {CastleSource::light_radius, PackedSource::light_radius, CastleOwner::light},
    {CastleSource::light_color, PackedSource::light_color, CastleOwner::light},
    {CastleSource::light_ambient_color, PackedSource::light_ambient_color, CastleOwner::light},
    {CastleSource::light_attenuation, PackedSource::light_attenuation, CastleOwner::light},
    {CastleSource::shadow_map, PackedSource::shadow_map, CastleOwner::shadow},
    {CastleSource::projector_matrix, PackedSource::projector_matrix, CastleOwner::shadow},
    {CastleSource::shadow_moments, PackedSource::shadow_moments, CastleOwner::shadow},
    {CastleSource::shadow_depth_plane, PackedSource::shadow_depth_plane, CastleOwner::shadow},
    {CastleSource::shadow_depths, PackedSource::shadow_depths, CastleOwner::own_map},
    {CastleSource::shadow_depth_line, PackedSource::shadow_depth_line, CastleOwner::own_map},
    {CastleSource::shadow_unblurred, PackedSource::shadow_unblurred, CastleOwner::own_map}};

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
  void bind_plain(std::uint32_t index, const PlainName& plain, int number);
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

void Binder::bind_plain(std::uint32_t index, const PlainName& plain, int number) {
  switch (plain.owner) {
    case CastleOwner::view: return add(index, plain.source);
    case CastleOwner::light: return bind_light(index, plain.source, number);
    case CastleOwner::shadow: return bind_shadow(index, plain.source, number);
    case CastleOwner::own_map: return bind_own_map(index, plain.source);
  }
}

void Binder::bind_castle(std::uint32_t index, const CastleName& name) {
  const auto plain = std::ranges::find(kPlainNames, name.source, &PlainName::name);
  if (plain != std::end(kPlainNames)) return bind_plain(index, *plain, name.number);
  const auto textures = c_.shape.textures;
  const bool has_texture = name.number >= 0 && static_cast<std::size_t>(name.number) < textures.size();
  const TextureUse use = has_texture ? textures[static_cast<std::size_t>(name.number)] : TextureUse();
  switch (name.source) {
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

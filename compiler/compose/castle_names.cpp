// One table of patterns; `#` in a pattern stands for a number.

#include "compose/castle_names.h"

#include <cctype>

namespace plugc {
namespace {

struct Pattern {
  std::string_view name;
  CastleName meaning;
};

using enum CastleKind;
using Source = CastleSource;

constexpr Pattern kPatterns[] = {
    {"castle_ModelViewMatrix", {uniform, "mat4", Source::model_view_matrix}},
    {"castle_ProjectionMatrix", {uniform, "mat4", Source::projection_matrix}},
    {"castle_NormalMatrix", {uniform, "mat3", Source::normal_matrix}},
    {"castle_MaterialDiffuseAlpha", {uniform, "vec4", Source::material_diffuse_alpha}},
    {"castle_MaterialBaseAlpha", {uniform, "vec4", Source::material_diffuse_alpha}},
    {"castle_MaterialEmissiveAlpha", {uniform, "vec4", Source::unlit_color}},
    {"castle_MaterialAmbient", {uniform, "vec3", Source::material_ambient}},
    {"castle_MaterialSpecular", {uniform, "vec3", Source::material_specular}},
    {"castle_MaterialEmissive", {uniform, "vec3", Source::material_emissive}},
    {"castle_MaterialShininess", {uniform, "float", Source::material_shininess}},
    {"castle_MaterialMetallic", {uniform, "float", Source::material_metallic}},
    {"castle_MaterialRoughness", {uniform, "float", Source::material_roughness}},
    {"castle_MaterialOcclusionStrength", {uniform, "float", Source::material_occlusion_strength}},
    {"castle_normalScale", {uniform, "float", Source::normal_scale}},
    {"castle_UnlitColor", {uniform, "vec4", Source::unlit_color}},
    {"castle_BackMaterialDiffuseAlpha", {uniform, "vec4", Source::back_diffuse_alpha}},
    {"castle_BackMaterialBaseAlpha", {uniform, "vec4", Source::back_diffuse_alpha}},
    {"castle_BackMaterialAmbient", {uniform, "vec3", Source::back_ambient}},
    {"castle_BackMaterialSpecular", {uniform, "vec3", Source::back_specular}},
    {"castle_BackMaterialEmissive", {uniform, "vec3", Source::back_emissive}},
    {"castle_BackMaterialShininess", {uniform, "float", Source::back_shininess}},
    {"castle_BackMaterialMetallic", {uniform, "float", Source::back_metallic}},
    {"castle_BackMaterialRoughness", {uniform, "float", Source::back_roughness}},
    {"castle_BackUnlitColor", {uniform, "vec4", Source::back_unlit_color}},
    {"castle_AlphaCutoff", {uniform, "float", Source::alpha_cutoff}},
    {"castle_clip_plane_#", {uniform, "vec4", Source::clip_plane}},
    {"castle_PointSize", {uniform, "float", Source::point_size}},
    {"castle_PointSizeLeast", {uniform, "float", Source::point_size_least}},
    {"castle_PointSizeMost", {uniform, "float", Source::point_size_most}},
    {"castle_PointFalloff", {uniform, "vec3", Source::point_falloff}},
    {"castle_TargetSize", {uniform, "vec2", Source::target_size}},
    {"castle_HatchColor", {uniform, "vec3", Source::hatch_color}},
    {"castle_GlobalAmbient", {uniform, "vec3", Source::global_ambient}},
    {"castle_LightSource#Position", {uniform, "vec3", Source::light_position}},
    {"castle_LightSource#SpotDirection", {uniform, "vec3", Source::light_spot_direction}},
    {"castle_LightSource#SpotCosCutoff", {uniform, "float", Source::light_spot_cos_cutoff}},
    {"castle_LightSource#SpotCutoff", {uniform, "float", Source::light_spot_cutoff}},
    {"castle_LightSource#BeamWidth", {uniform, "float", Source::light_beam_width}},
    {"castle_LightSource#Radius", {uniform, "float", Source::light_radius}},
    {"castle_LightSource#Color", {uniform, "vec3", Source::light_color}},
    {"castle_LightSource#AmbientColor", {uniform, "vec3", Source::light_ambient_color}},
    {"castle_LightSource#Attenuation", {uniform, "vec3", Source::light_attenuation}},
    {"castle_texture_#", {uniform, "sampler2D", Source::texture}},
    {"castle_TextureMatrix#", {uniform, "mat4", Source::texture_matrix}},
    {"castle_texture_coord_parameter_#", {uniform, "vec4", Source::texture_coord_parameter}},
    {"castle_texture_projector_#", {uniform, "mat4", Source::texture_projector}},
    {"castle_MultiTextureColor", {uniform, "vec4", Source::multi_texture_color}},
    {"castle_shadow_map_#", {uniform, "sampler2DShadow", Source::shadow_map}},
    {"castle_projector_matrix_#", {uniform, "mat4", Source::projector_matrix}},
    {"castle_shadow_intensity_#", {uniform, "float", Source::shadow_intensity}},
    {"castle_shadow_mask_#", {uniform, "sampler2D", Source::shadow_map}},
    {"castle_shadow_moments_#", {uniform, "sampler2D", Source::shadow_moments}},
    {"castle_shadow_depth_plane_#", {uniform, "vec4", Source::shadow_depth_plane}},
    {"castle_shadow_depths", {uniform, "sampler2D", Source::shadow_depths}},
    {"castle_shadow_depth_line", {uniform, "vec4", Source::shadow_depth_line}},
    {"castle_shadow_unblurred", {uniform, "sampler2D", Source::shadow_unblurred}},
    {"castle_DepthPassRange", {uniform, "vec4", Source::depth_pass_range}},
    {"castle_FogColor", {uniform, "vec3", Source::fog_color}},
    {"castle_FogVisibilityRange", {uniform, "float", Source::fog_visibility_range}},
    {"castle_FogExponential", {uniform, "float", Source::fog_exponential}},
    {"castle_FogPlane", {uniform, "vec4", Source::fog_plane}},
    {"castle_CameraMatrix", {uniform, "mat4", Source::camera_matrix}},
    {"castle_CameraInverseMatrix", {uniform, "mat4", Source::camera_inverse_matrix}},
    {"castle_CameraRotationMatrix", {uniform, "mat3", Source::camera_rotation_matrix}},
    {"castle_CameraRotationInverseMatrix", {uniform, "mat3", Source::camera_rotation_inverse_matrix}},
    {"castle_Vertex", {attribute, "vec4"}},
    {"castle_Normal", {attribute, "vec3"}},
    {"castle_Tangent", {attribute, "vec4"}},
    {"castle_ColorPerVertex", {attribute, "vec4"}},
    {"castle_MultiTexCoord#", {attribute, "vec4"}},
    {"castle_FogCoord", {attribute, "float"}},
    {"castle_vertex_eye", {varying, "vec4"}},
    {"castle_normal_eye", {varying, "vec3"}},
    {"castle_TexCoord#", {varying, "vec4"}},
    {"castle_FogFragCoord", {varying, "float"}},
    {"castle_tangent_to_eye_space", {varying, "mat3"}},
    {"castle_Color", {varying, "vec4"}},
    {"castle_ColorPerVertexFragment", {varying, "vec4"}},
    {"castle_projected_tex_coord_#", {varying, "vec4"}},
    {"castle_shadow_depth_#", {varying, "float"}},
    {"castle_clip_distance_#", {varying, "float"}},
    {"castle_line_place", {varying, "vec4"}},
    {"castle_line_end", {varying, "vec4"}},
    {"castle_FragColor", {output, "vec4"}},
};

/// The number that stands for `#`, -1 when the pattern has none, -2 when the name does not match. Numbers above 999 do not.
int match(std::string_view pattern, std::string_view name) {
  const std::size_t hash = pattern.find('#');
  if (hash == std::string_view::npos) return pattern == name ? -1 : -2;
  if (!name.starts_with(pattern.substr(0, hash))) return -2;
  name.remove_prefix(hash);
  int number = 0;
  std::size_t digits = 0;
  while (digits < name.size() && digits < 3 && std::isdigit(static_cast<unsigned char>(name[digits])) != 0) {
    number = number * 10 + (name[digits++] - '0');
  }
  return digits > 0 && name.substr(digits) == pattern.substr(hash + 1) ? number : -2;
}

}  // namespace

std::optional<CastleName> find_castle_name(std::string_view name) {
  if (!name.starts_with("castle_")) return std::nullopt;
  for (const Pattern& pattern : kPatterns) {
    const int number = match(pattern.name, name);
    if (number == -2) continue;
    CastleName found = pattern.meaning;
    found.number = number;
    return found;
  }
  return std::nullopt;
}

std::string number_own_light(std::string_view name, int light) {
  constexpr std::string_view kPrefix = "castle_LightSource";
  if (!name.starts_with(kPrefix) || name.size() == kPrefix.size()) return "";
  if (std::isupper(static_cast<unsigned char>(name[kPrefix.size()])) == 0) return "";
  return std::string(kPrefix) + std::to_string(light) + std::string(name.substr(kPrefix.size()));
}

}  // namespace plugc

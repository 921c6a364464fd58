#pragma once
// The names that the renderer feeds to templates and effects alike (effects.md, "Names that effects may use"): what each
// is, and where its value comes from.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "glsl/stage.h"

namespace plugc {

enum class CastleKind : std::uint8_t { uniform, attribute, varying, output };

/// What the value of a castle_ uniform is computed from.
enum class CastleSource : std::uint8_t {
  none,
  model_view_matrix,
  projection_matrix,
  normal_matrix,
  material_diffuse_alpha,
  material_ambient,
  material_specular,
  material_emissive,
  material_shininess,
  material_metallic,
  material_roughness,
  material_occlusion_strength,
  normal_scale,
  unlit_color,
  global_ambient,
  light_position,
  light_spot_direction,
  light_spot_cos_cutoff,
  light_spot_cutoff,
  light_beam_width,
  light_radius,
  light_color,
  light_ambient_color,
  light_attenuation,
  texture,
  texture_matrix,
  texture_coord_parameter,
  multi_texture_color,
  texture_projector,
  shadow_map,
  projector_matrix,
  shadow_intensity,
  shadow_moments,
  shadow_depth_plane,
  shadow_depths,
  shadow_depth_line,
  shadow_unblurred,
  depth_pass_range,
  back_diffuse_alpha,
  back_ambient,
  back_specular,
  back_emissive,
  back_shininess,
  back_metallic,
  back_roughness,
  back_unlit_color,
  alpha_cutoff,
  clip_plane,
  point_size,
  point_size_least,
  point_size_most,
  point_falloff,
  target_size,
  hatch_color,
  fog_color,
  fog_visibility_range,
  fog_exponential,
  fog_plane,
  camera_matrix,
  camera_inverse_matrix,
  camera_rotation_matrix,
  camera_rotation_inverse_matrix,
};

struct CastleName {
  CastleKind kind = CastleKind::uniform;
  std::string_view type;  ///< GLSL type.
  CastleSource source = CastleSource::none;
  int number = -1;  ///< N of a light, texture or coordinate; -1 for names without one.
};

/// What a castle_ name means; nullopt for names that plugc does not feed.
std::optional<CastleName> find_castle_name(std::string_view name);

/// `castle_LightSourceSpotDirection`, as a light's own effect may write for "this light"; its numbered form, else "".
std::string number_own_light(std::string_view name, int light);

}  // namespace plugc

// One light source, in whichever stage the lighting is computed. It adds itself through a plug, as an effect would.
// Source: X3D 4.1, clause 17.2.2 (lighting model): Lambert diffuse, Blinn specular, the ambient term inside the cone.
uniform vec3 castle_LightSourceNPosition;
uniform vec3 castle_LightSourceNColor;
#ifdef LIGHT_AMBIENT
uniform vec3 castle_LightSourceNAmbientColor;
#endif
#ifdef SPOT
uniform vec3 castle_LightSourceNSpotDirection;
uniform float castle_LightSourceNSpotCosCutoff;
#ifdef BEAM_WIDTH
uniform float castle_LightSourceNSpotCutoff;
uniform float castle_LightSourceNBeamWidth;
#endif
#endif
#ifdef ATTENUATION
uniform vec3 castle_LightSourceNAttenuation;
#endif
#ifdef RADIUS
uniform float castle_LightSourceNRadius;
#endif
#ifdef AS_CONTRIBUTION
#ifdef LIGHT_AMBIENT
uniform vec3 castle_MaterialAmbient;
#endif
#ifdef SPECULAR
uniform vec3 castle_MaterialSpecular;
#endif

struct MaterialInfo
{
  vec4 diffuse_alpha;
  vec3 ambient;
  vec3 specular;
  float shininess;
};
#endif

/* PLUG-DECLARATIONS */

#ifdef PHYSICAL
void PLUG_add_light(inout vec4 color, const in vec4 vertex_eye, const in vec3 normal_eye, const in MaterialInfo material,
  const in vec3 view)
#else
void light_source_N(inout vec4 color, const in vec4 vertex_eye, const in vec3 normal_eye, const in MaterialInfo material)
#endif
{
#ifdef POSITIONAL
  vec3 light_dir = castle_LightSourceNPosition - vertex_eye.xyz;
  float light_distance = length(light_dir);
  light_dir /= light_distance;
#else
  vec3 light_dir = castle_LightSourceNPosition;
#endif
#ifdef SPOT
  float spot_cos = dot(castle_LightSourceNSpotDirection, -light_dir);
  if (spot_cos < castle_LightSourceNSpotCosCutoff)
    return;
#endif

  float light_scale = 1.0;
  /* PLUG: light_scale (light_scale, normal_eye, light_dir) */
#ifdef BEAM_WIDTH
  // Full intensity inside beamWidth, falling to nothing at cutOffAngle (X3D 4.1, 17.4.3).
  light_scale *= clamp((acos(spot_cos) - castle_LightSourceNSpotCutoff) /
                       (castle_LightSourceNBeamWidth - castle_LightSourceNSpotCutoff), 0.0, 1.0);
#endif
#ifdef ATTENUATION
  light_scale /= max(castle_LightSourceNAttenuation.x + castle_LightSourceNAttenuation.y * light_distance +
                     castle_LightSourceNAttenuation.z * light_distance * light_distance, 1.0);
#endif
#ifdef RADIUS
  light_scale *= step(light_distance, castle_LightSourceNRadius);
#endif

#ifdef PHYSICAL
  color.rgb += castle_LightSourceNColor * reflected_share(material, normal_eye, light_dir, view) * light_scale;
#else
  // Effects take these terms as vec4; where none does, three components do.
#ifdef WIDE_DIFFUSE
  vec4 diffuse = vec4(material.diffuse_alpha.rgb * castle_LightSourceNColor, material.diffuse_alpha.a);
#else
  vec3 diffuse = material.diffuse_alpha.rgb * castle_LightSourceNColor;
#endif
  /* PLUG: material_light_diffuse (diffuse, vertex_eye, normal_eye) */
  float diffuse_factor = max(dot(normal_eye, light_dir), 0.0);
  vec3 contribution = diffuse.rgb * diffuse_factor;
#ifdef LIGHT_AMBIENT
#ifdef WIDE_AMBIENT
  vec4 ambient = vec4(material.ambient * castle_LightSourceNAmbientColor, 1.0);
#else
  vec3 ambient = material.ambient * castle_LightSourceNAmbientColor;
#endif
  /* PLUG: material_light_ambient (ambient) */
  contribution += ambient.rgb;
#endif
#ifdef SPECULAR
#ifdef WIDE_SPECULAR
  vec4 specular = vec4(material.specular * castle_LightSourceNColor, 1.0);
#else
  vec3 specular = material.specular * castle_LightSourceNColor;
#endif
  /* PLUG: material_light_specular (specular) */
  if (diffuse_factor > 0.0)
  {
    vec3 half_vector = normalize(light_dir - normalize(vertex_eye.xyz));
    contribution += specular.rgb * pow(max(dot(half_vector, normal_eye), 0.0), material.shininess);
  }
#endif
  color = vec4(color.rgb + contribution * light_scale, color.a);
#endif
}

#ifdef PHONG
#ifdef AS_CONTRIBUTION
void PLUG_add_light_contribution(inout vec4 color, const in vec4 vertex_eye, const in vec3 normal_eye,
  in float material_shininess, in vec4 color_per_vertex)
{
  MaterialInfo material = MaterialInfo(color_per_vertex, vec3(0.0), vec3(0.0), material_shininess);
#ifdef LIGHT_AMBIENT
  material.ambient = castle_MaterialAmbient;
#endif
#ifdef SPECULAR
  material.specular = castle_MaterialSpecular;
#endif
  light_source_N(color, vertex_eye, normal_eye, material);
}
#else
void PLUG_add_light(inout vec4 color, const in vec4 vertex_eye, const in vec3 normal_eye, const in MaterialInfo material)
{
  light_source_N(color, vertex_eye, normal_eye, material);
}
#endif
#endif

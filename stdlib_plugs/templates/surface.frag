// Texture N of the material that is not its main one: it multiplies the parameter that it is named after (X3D 4.1, 12.4), or
// says how the surface is bent (normalTexture). Its effects see it alone, and no other sees it.
uniform sampler2D castle_texture_N;
in vec4 castle_TexCoordN;
#ifdef OCCLUSION
uniform float castle_MaterialOcclusionStrength;
#endif
#ifdef NORMAL
uniform float castle_normalScale;
in mat3 castle_tangent_to_eye_space;
#endif

/* PLUG-DECLARATIONS */

vec4 surface_texture_N()
{
  vec4 tex_coord = castle_TexCoordN;
  vec4 texture_color = texture(castle_texture_N, tex_coord.st);
  /* PLUG: texture_color (texture_color, castle_texture_N, tex_coord) */
#ifdef LINEAR_LIGHT
  texture_color.rgb = pow(texture_color.rgb, vec3(2.2));
#endif
  return texture_color;
}

#ifdef AMBIENT
void PLUG_material_ambient(inout vec3 ambient)
{
  ambient *= surface_texture_N().rgb;
}
#endif
#ifdef SPECULAR
void PLUG_material_specular(inout vec3 specular)
{
  specular *= surface_texture_N().rgb;
}
#endif
#ifdef SHININESS
void PLUG_material_shininess(inout float shininess)
{
  shininess *= surface_texture_N().a;
}
#endif
#ifdef EMISSIVE
void PLUG_material_emissive(inout vec3 emissive)
{
  emissive *= surface_texture_N().rgb;
}
#endif
#ifdef OCCLUSION
void PLUG_material_occlusion(inout vec4 color)
{
  color.rgb *= mix(1.0, surface_texture_N().r, castle_MaterialOcclusionStrength);
}
#endif
#ifdef METALLIC_ROUGHNESS
void PLUG_material_metallic_roughness(inout float metallic, inout float roughness)
{
  vec4 both = surface_texture_N();
  metallic *= both.b;
  roughness *= both.g;
}
#endif
#ifdef NORMAL
// On back faces the surface is bent the other way: only what stands out of it is negated (thesis, A.2).
void PLUG_fragment_eye_space(const in vec4 vertex_eye, inout vec3 normal_eye)
{
  vec3 normal_tangent = surface_texture_N().xyz * 2.0 - vec3(1.0);
  normal_tangent.xy *= castle_normalScale;
#ifdef TWO_SIDED
  if (!gl_FrontFacing)
    normal_tangent.z = -normal_tangent.z;
#endif
  normal_eye = normalize(castle_tangent_to_eye_space * normal_tangent);
}
#endif

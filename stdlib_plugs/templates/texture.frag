// Texture N: sampled (a ShaderTexture is pink until an effect paints it), offered to effects, applied.
#ifdef IMAGE_2D
uniform sampler2D castle_texture_N;
#endif
#ifdef IMAGE_3D
uniform sampler3D castle_texture_N;
#endif
#ifdef CUBE
uniform samplerCube castle_texture_N;
#endif
#ifdef SHADOW_2D
uniform sampler2DShadow castle_texture_N;
#endif
#ifdef SHADOW_CUBE
uniform samplerCubeShadow castle_texture_N;
#endif
in vec4 castle_TexCoordN;
#ifdef USES_DIFFUSE
vec4 diffuse_color;
#endif
#ifdef ARG2_SPECULAR
uniform vec3 castle_MaterialSpecular;
#endif
#ifdef USES_FACTOR
uniform vec4 castle_MultiTextureColor;
#endif

#ifdef MODE_COMBINED
vec4 texture_mode_N(const in vec4 arg1, const in vec4 arg2, const in float amount);
#endif
#ifdef ALPHA_APART
vec4 texture_alpha_mode_N(const in vec4 arg1, const in vec4 arg2, const in float amount);
#endif

/* PLUG-DECLARATIONS */

void PLUG_main_texture_apply(inout vec4 fragment_color, const in vec3 normal_eye)
{
  vec4 tex_coord = castle_TexCoordN;
#ifdef FIRST_UNIT
  /* PLUG: texture_coord_shift (tex_coord.st) */
#endif
#ifdef IMAGE_2D
#ifdef PROJECTIVE
  vec4 texture_color = textureProj(castle_texture_N, tex_coord);
#else
  vec4 texture_color = texture(castle_texture_N, tex_coord.st);
#endif
#endif
#ifdef IMAGE_3D
  vec4 texture_color = texture(castle_texture_N, tex_coord.stp);
#endif
#ifdef CUBE
  vec4 texture_color = texture(castle_texture_N, tex_coord.stp);
#endif
#ifdef SHADOW_2D
  vec4 texture_color = vec4(vec3(textureProj(castle_texture_N, tex_coord)), 1.0);
#endif
#ifdef SHADOW_CUBE
  vec4 texture_color = vec4(vec3(texture(castle_texture_N, vec4(tex_coord.stp, min(length(tex_coord.stp), 1.0)))), 1.0);
#endif
#ifdef SHADER
  vec4 texture_color = vec4(1.0, 0.0, 1.0, 1.0);
  /* PLUG: texture_color (texture_color, tex_coord) */
#else
  /* PLUG: texture_color (texture_color, castle_texture_N, tex_coord) */
#endif
#ifdef LINEAR_LIGHT
  texture_color.rgb = pow(texture_color.rgb, vec3(2.2));
#endif
#ifdef MODE_MODULATE
  fragment_color *= texture_color;
#endif
#ifdef MODE_REPLACE
  fragment_color = texture_color;
#endif
#ifdef MODE_COMBINED
#ifdef ARG2_PREVIOUS
  vec4 arg2 = fragment_color;
#endif
#ifdef ARG2_DIFFUSE
  vec4 arg2 = diffuse_color;
#endif
#ifdef ARG2_SPECULAR
  vec4 arg2 = vec4(castle_MaterialSpecular, 1.0);
#endif
#ifdef ARG2_FACTOR
  vec4 arg2 = castle_MultiTextureColor;
#endif
#ifdef BLEND_DIFFUSE
  float amount = diffuse_color.a;
#endif
#ifdef BLEND_TEXTURE
  float amount = texture_color.a;
#endif
#ifdef BLEND_FACTOR
  float amount = castle_MultiTextureColor.a;
#endif
#ifdef BLEND_CURRENT
  float amount = fragment_color.a;
#endif
#ifdef NO_BLEND
  float amount = 1.0;
#endif
#ifdef ALPHA_APART
#ifdef ALPHA_BLEND_DIFFUSE
  float alpha_amount = diffuse_color.a;
#endif
#ifdef ALPHA_BLEND_TEXTURE
  float alpha_amount = texture_color.a;
#endif
#ifdef ALPHA_BLEND_FACTOR
  float alpha_amount = castle_MultiTextureColor.a;
#endif
#ifdef ALPHA_BLEND_CURRENT
  float alpha_amount = fragment_color.a;
#endif
#ifdef ALPHA_NO_BLEND
  float alpha_amount = 1.0;
#endif
  float alpha = texture_alpha_mode_N(texture_color, arg2, alpha_amount).a;
  fragment_color = vec4(texture_mode_N(texture_color, arg2, amount).rgb, alpha);
#else
  fragment_color = texture_mode_N(texture_color, arg2, amount);
#endif
#endif
#ifdef COMPLEMENT
  fragment_color.rgb = 1.0 - fragment_color.rgb;
#endif
#ifdef ALPHA_REPLICATE
  fragment_color.rgb = vec3(fragment_color.a);
#endif
}

// Texture N: sampled, offered to effects, applied.
uniform sampler2D castle_texture_N;
in vec4 castle_TexCoordN;

/* PLUG-DECLARATIONS */

void PLUG_main_texture_apply(inout vec4 fragment_color, const in vec3 normal_eye)
{
  vec4 tex_coord = castle_TexCoordN;
#ifdef FIRST_UNIT
  /* PLUG: texture_coord_shift (tex_coord.st) */
#endif
  vec4 texture_color = texture(castle_texture_N, tex_coord.st);
  /* PLUG: texture_color (texture_color, castle_texture_N, tex_coord) */
#ifdef LINEAR_LIGHT
  texture_color.rgb = pow(texture_color.rgb, vec3(2.2));
#endif
#ifdef MODE_MODULATE
  fragment_color *= texture_color;
#endif
#ifdef MODE_REPLACE
  fragment_color = texture_color;
#endif
#ifdef MODE_ADD
  fragment_color.rgb += texture_color.rgb;
  fragment_color.a *= texture_color.a;
#endif
}

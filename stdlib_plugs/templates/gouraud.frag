// Gouraud shading, fragment stage: the interpolated colour, then textures and effects.
in vec4 castle_Color;
#ifdef VERTEX_EYE
in vec4 castle_vertex_eye;
#endif
#ifdef NORMAL_EYE
in vec3 castle_normal_eye;
#endif
out vec4 castle_FragColor;

/* PLUG-DECLARATIONS */

void main()
{
  vec4 fragment_color = castle_Color;
#ifdef NORMAL_EYE
  vec3 normal_eye = normalize(castle_normal_eye);
#else
  vec3 normal_eye = vec3(0.0);
#endif
  /* PLUG: main_texture_apply (fragment_color, normal_eye) */
  /* PLUG: texture_apply (fragment_color, normal_eye) */
  /* PLUG: fragment_modify (fragment_color) */
  /* PLUG: fog_apply (fragment_color, normal_eye) */
  castle_FragColor = fragment_color;
  /* PLUG: fragment_end (castle_FragColor) */
}

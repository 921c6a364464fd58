// The shadow of light N: a depth map compared in hardware, four texels filtered (percentage-closer filtering, 2x2).
// Outside the map all is lit: its border says so.
uniform sampler2DShadow castle_shadow_map_N;
#ifdef SHADOW_INTENSITY
uniform float castle_shadow_intensity_N;
#endif
in vec4 castle_projected_tex_coord_N;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec4 map_coord = castle_projected_tex_coord_N;
  map_coord.p = max(map_coord.p, 0.0);  // beyond the far end of depths that fall to 0
  float visibility = map_coord.q > 0.0 ? textureProj(castle_shadow_map_N, map_coord) : 1.0;
#ifdef SHADOW_INTENSITY
  light_scale *= 1.0 - castle_shadow_intensity_N * (1.0 - visibility);
#else
  light_scale *= visibility;
#endif
}

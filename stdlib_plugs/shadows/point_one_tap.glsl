// The cube map of point light N compared once. Its filter decides whether that is the nearest texel (`hard`), or the four around the
// place, across the edges of the cube too (`bilinear`).
void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec3 from_light = castle_projected_tex_coord_N.xyz;
  light_scale *= shadow_lit_N(from_light, length(from_light));
}

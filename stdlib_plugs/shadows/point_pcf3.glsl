// The mean of 3 x 3 bilinear look-ups into the cube map of point light N, a texel apart across the ray from the light: on every face
// and over every edge alike.
void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec3 from_light = castle_projected_tex_coord_N.xyz;
  float depth = length(from_light);
  vec3 right, up;
  shadow_across_N(from_light, right, up);
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      sum += shadow_lit_N(from_light + float(x) * right + float(y) * up, depth);
  light_scale *= sum / 9.0;
}

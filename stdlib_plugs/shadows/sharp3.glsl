// The 3 x 3 kernel's edge, where its value is a half, drawn about one pixel wide: steps of the map's texels are rounded off as by the
// kernel, and the edge is not blurred. What is narrower than 1.5 texels never takes half of the kernel, and vanishes.
uniform sampler2DShadow castle_shadow_map_N;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec3 map_coord = shadow_coord_N();
  vec2 slope;
  float visibility = shadow_kernel_N(map_coord, slope);
  vec2 texel = map_coord.st * vec2(textureSize(castle_shadow_map_N, 0));
  // How much the value changes from this pixel to its neighbours. Above 1 the kernel is narrower than a pixel, and sharp enough;
  // the lower bound only keeps 0 (all around is lit, or nothing is) from dividing.
  float change = length(vec2(dot(slope, dFdx(texel)), dot(slope, dFdy(texel))));
  light_scale *= clamp(0.5 + (visibility - 0.5) / clamp(change, 1.0 / 1024.0, 1.0), 0.0, 1.0);
}

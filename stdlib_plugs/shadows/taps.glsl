// The mean of TAPS x TAPS bilinear look-ups, a texel apart and centred on the place.
uniform sampler2DShadow castle_shadow_map_N;
#ifdef TAPS_2
const int shadow_taps_N = 2;
#endif
#ifdef TAPS_3
const int shadow_taps_N = 3;
#endif
#ifdef TAPS_4
const int shadow_taps_N = 4;
#endif

#ifdef SLOPE
// `slope`: the change of the value a texel to the right and a texel up, from what the outer look-ups see.
float shadow_kernel_N(const in vec3 map_coord, out vec2 slope)
#else
float shadow_kernel_N(const in vec3 map_coord)
#endif
{
  const float middle = 0.5 * float(shadow_taps_N - 1);
  const float weight = 1.0 / float(shadow_taps_N * shadow_taps_N);
  vec2 texel = 1.0 / vec2(textureSize(castle_shadow_map_N, 0));
  float sum = 0.0;
#ifdef SLOPE
  slope = vec2(0.0);
#endif
  for (int y = 0; y < shadow_taps_N; ++y)
    for (int x = 0; x < shadow_taps_N; ++x)
    {
      vec2 place = vec2(x, y) - middle;
      float lit = texture(castle_shadow_map_N, vec3(map_coord.st + place * texel, map_coord.p));
      sum += lit;
#ifdef SLOPE
      slope += place * lit;
#endif
    }
#ifdef SLOPE
  slope *= weight;
#endif
  return sum * weight;
}

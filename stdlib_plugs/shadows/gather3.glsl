// The mean of 3 x 3 bilinear look-ups, in four gathers: along a side they weigh four texels by 1 - f, 1, 1, f (f: how far the
// place lies from one texel's middle to the next), by a third.
#extension GL_ARB_gpu_shader5 : require
uniform sampler2DShadow castle_shadow_map_N;

#ifdef SLOPE
// `slope`: the change of the value a texel to the right and a texel up, from what the outer look-ups see.
float shadow_kernel_N(const in vec3 map_coord, out vec2 slope)
#else
float shadow_kernel_N(const in vec3 map_coord)
#endif
{
  vec2 size = vec2(textureSize(castle_shadow_map_N, 0));
  vec2 texel = map_coord.st * size - 0.5;
  vec2 f = fract(texel);
  vec2 g = 1.0 - f;
  vec2 corner = floor(texel) / size; // where the first and the second texel of either side meet
  // A gather's x y z w are the upper left, upper right, lower right and lower left of four texels.
  vec4 lower_left = textureGather(castle_shadow_map_N, corner, map_coord.p);
  vec4 lower_right = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(2, 0));
  vec4 upper_left = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(0, 2));
  vec4 upper_right = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(2, 2));
  // Rows from below, two at a time, each the weighted sum of its texels.
  vec2 lower = lower_left.wx * g.x + lower_left.zy + lower_right.wx + lower_right.zy * f.x;
  vec2 upper = upper_left.wx * g.x + upper_left.zy + upper_right.wx + upper_right.zy * f.x;
#ifdef SLOPE
  vec2 left = lower_left.wz * g.y + lower_left.xy + upper_left.wz + upper_left.xy * f.y;
  vec2 right = lower_right.wz * g.y + lower_right.xy + upper_right.wz + upper_right.xy * f.y;
  slope = vec2(dot(right - left, vec2(g.x, f.x)), dot(upper - lower, vec2(g.y, f.y))) * (1.0 / 9.0);
#endif
  return (lower.x * g.y + lower.y + upper.x + upper.y * f.y) * (1.0 / 9.0);
}

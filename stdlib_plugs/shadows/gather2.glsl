// The mean of 2 x 2 bilinear look-ups, in gathers: along a side they weigh three texels by 1 - f, 1, f (f: how far the place lies
// in its texel), halved.
#extension GL_ARB_gpu_shader5 : require
uniform sampler2DShadow castle_shadow_map_N;

float shadow_kernel_N(const in vec3 map_coord)
{
  vec2 size = vec2(textureSize(castle_shadow_map_N, 0));
  vec2 texel = map_coord.st * size;
  vec2 f = fract(texel);
  vec2 g = 1.0 - f;
  vec2 corner = floor(texel) / size; // where the first and the second texel of either side meet
  // A gather's x y z w are the upper left, upper right, lower right and lower left of four texels.
  vec4 four = textureGather(castle_shadow_map_N, corner, map_coord.p);
  vec4 right = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(1, 0));
  vec4 upper = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(0, 1));
  float last = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(1, 1)).y;
  return (dot(four, vec4(g.x, 1.0, g.y, g.x * g.y)) + f.x * (right.y + right.z * g.y) + f.y * (upper.y + upper.x * g.x) +
          f.x * f.y * last) * 0.25;
}

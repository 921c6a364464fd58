// The mean of 4 x 4 bilinear look-ups, in nine gathers: along a side they weigh five texels by 1 - f, 1, 1, 1, f (f: how far the
// place lies in its texel), by a quarter. Of the last gathers of a row or column one half counts.
#extension GL_ARB_gpu_shader5 : require
uniform sampler2DShadow castle_shadow_map_N;

float shadow_kernel_N(const in vec3 map_coord)
{
  vec2 size = vec2(textureSize(castle_shadow_map_N, 0));
  vec2 texel = map_coord.st * size;
  vec2 f = fract(texel);
  vec2 g = 1.0 - f;
  vec2 corner = (floor(texel) - 1.0) / size; // where the first and the second texel of either side meet
  // A gather's x y z w are the upper left, upper right, lower right and lower left of four texels.
  vec4 a = textureGather(castle_shadow_map_N, corner, map_coord.p);
  vec4 b = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(2, 0));
  vec2 c = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(3, 0)).yz;
  float sum = dot(a, vec4(g.x, 1.0, g.y, g.x * g.y)) + dot(b, vec4(1.0, 1.0, g.y, g.y)) + dot(c, f.x * vec2(1.0, g.y));
  a = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(0, 2));
  b = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(2, 2));
  c = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(3, 2)).yz;
  sum += dot(a, vec4(g.x, 1.0, 1.0, g.x)) + dot(b, vec4(1.0)) + dot(c, f.xx);
  a.xy = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(0, 3)).xy;
  b.xy = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(2, 3)).xy;
  c.x = textureGatherOffset(castle_shadow_map_N, corner, map_coord.p, ivec2(3, 3)).y;
  sum += f.y * (dot(a.xy, vec2(g.x, 1.0)) + dot(b.xy, vec2(1.0)) + f.x * c.x);
  return sum * 0.0625;
}

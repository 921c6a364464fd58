// The depths of a shadow map as moments, blurred along rows by 1 2 1 (as wide as a mean of 2 x 2 look-ups). Depth is linear from
// 0 to 1, so that a spot light's is resolved alike near and far; what is no number is far away, and darkens nobody.
uniform sampler2D castle_shadow_depths;
uniform vec4 castle_shadow_depth_line;
out vec4 castle_FragColor;

vec4 moments_at(const in ivec2 place)
{
  float stored = texelFetch(castle_shadow_depths, place, 0).r;
  float depth = (castle_shadow_depth_line.x * stored + castle_shadow_depth_line.y) /
                (castle_shadow_depth_line.z * stored + castle_shadow_depth_line.w);
  depth = depth < 1.0 ? max(depth, 0.0) : 1.0;
#ifdef VSM
  return vec4(depth, depth * depth, 0.0, 0.0);
#endif
#ifdef EVSM
  vec2 warped = depth_warp_N(depth);
  return vec4(warped, warped * warped);
#endif
#ifdef MSM
  float centred = 2.0 * depth - 1.0; // for powers that are rounded less
  float square = centred * centred;
  return vec4(centred, square, square * centred, square * square);
#endif
}

void main()
{
  ivec2 place = ivec2(gl_FragCoord.xy);
  int last = textureSize(castle_shadow_depths, 0).x - 1;
  castle_FragColor = 0.5 * moments_at(place) + 0.25 * (moments_at(ivec2(max(place.x - 1, 0), place.y)) +
                                                      moments_at(ivec2(min(place.x + 1, last), place.y)));
}

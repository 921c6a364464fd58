// Moments that are blurred along rows, blurred along columns too.
uniform sampler2D castle_shadow_unblurred;
out vec4 castle_FragColor;

vec4 moments_at(const in ivec2 place)
{
  return texelFetch(castle_shadow_unblurred, place, 0);
}

void main()
{
  ivec2 place = ivec2(gl_FragCoord.xy);
  int last = textureSize(castle_shadow_unblurred, 0).y - 1;
  castle_FragColor = 0.5 * moments_at(place) + 0.25 * (moments_at(ivec2(place.x, max(place.y - 1, 0))) +
                                                      moments_at(ivec2(place.x, min(place.y + 1, last))));
}

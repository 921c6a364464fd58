// What lies behind clip plane N is cut away. Distances to a plane are linear, so that this is exact.
in float castle_clip_distance_N;

void PLUG_fragment_end(const in vec4 fragment_color)
{
  if (castle_clip_distance_N < 0.0)
    discard;
}

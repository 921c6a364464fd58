// Where the fragment lies in the map of light N: s, t, and the depth to compare with, held within what the map can store. What is
// behind a spot light lies far outside of the map, where all is lit.
in vec4 castle_projected_tex_coord_N;

vec3 shadow_coord_N()
{
  vec3 map_coord = castle_projected_tex_coord_N.stp;
#ifdef PERSPECTIVE
  map_coord /= castle_projected_tex_coord_N.q;
#endif
  map_coord.p = clamp(map_coord.p, 0.0, 1.0);
#ifdef PERSPECTIVE
  return castle_projected_tex_coord_N.q > 0.0 ? map_coord : vec3(-8.0, -8.0, 0.5);
#else
  return map_coord;
#endif
}

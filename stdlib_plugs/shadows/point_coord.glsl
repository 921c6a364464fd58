// Where the fragment lies as point light N sees it: its offset from the light, in world space, as a share of the largest distance
// that the cube map holds. Its length is the depth to compare; what lies beyond is compared as if it lay at the end.
uniform samplerCubeShadow castle_shadow_map_N;
in vec4 castle_projected_tex_coord_N;

// How much of what lies at that depth is lit, looked up in that direction.
float shadow_lit_N(const in vec3 direction, const in float depth)
{
  return texture(castle_shadow_map_N, vec4(direction, min(depth, 1.0)));
}

#ifdef ACROSS
// Two directions across the ray from the light, each as long as a texel is wide where the ray meets the cube.
void shadow_across_N(const in vec3 from_light, out vec3 right, out vec3 up)
{
  vec3 size = abs(from_light);
  vec3 least = size.x <= min(size.y, size.z) ? vec3(1.0, 0.0, 0.0) : size.y <= size.z ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  float texel = 2.0 * max(size.x, max(size.y, size.z)) / float(textureSize(castle_shadow_map_N, 0).x);
  right = normalize(cross(from_light, least)) * texel;
  up = normalize(cross(right, from_light)) * texel;
}
#endif

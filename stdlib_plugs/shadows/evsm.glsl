// Exponential variance shadow maps: the smaller of two bounds, each of variance over another warp of depth.
uniform sampler2D castle_shadow_moments_N;
in float castle_shadow_depth_N;

// Of depths within 0.0001 of the map's range nobody is in front of the other; the warp stretches that by its slope.
const float depth_tolerance_N = 1e-4;
// The warps leave less that is not there.
const float dark_share_N = 0.25;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec2 place = shadow_coord_N().st;
  vec2 depth = depth_warp_N(clamp(castle_shadow_depth_N, 0.0, 1.0));
  vec2 tolerance = 2.0 * depth_tolerance_N * warp_exponents_N * depth;
  vec4 moments = textureLod(castle_shadow_moments_N, place, 0.0);
  float share = min(chebyshev_share_N(moments.xz, depth.x, tolerance.x * tolerance.x),
                    chebyshev_share_N(moments.yw, depth.y, tolerance.y * tolerance.y));
  float light = light_of_share_N(share, dark_share_N);
  light_scale *= place == clamp(place, 0.0, 1.0) ? light : 1.0; // outside of the map all is lit
}

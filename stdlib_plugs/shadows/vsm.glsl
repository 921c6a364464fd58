// Variance shadow maps (Donnelly, Lauritzen 2006): the map holds the mean depth around each texel, and the mean of its square.
uniform sampler2D castle_shadow_moments_N;
in float castle_shadow_depth_N;

// Of depths within 0.001 of the map's range nobody is in front of the other.
const float least_variance_N = 1e-6;
// Variance alone tells little: where a caster's edge lies over another caster, it may allow half of the light.
const float dark_share_N = 0.35;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec2 place = shadow_coord_N().st;
  float depth = clamp(castle_shadow_depth_N, 0.0, 1.0);
  float share = chebyshev_share_N(textureLod(castle_shadow_moments_N, place, 0.0).xy, depth, least_variance_N);
  float light = light_of_share_N(share, dark_share_N);
  light_scale *= place == clamp(place, 0.0, 1.0) ? light : 1.0; // outside of the map all is lit
}

// Moment shadow maps (Peters, Klein 2015, "Moment shadow mapping"): of all that has these four moments, the least share that can lie
// in front of the fragment, which is Hamburger's moment problem. The extreme is three depths: the fragment's own, and the roots of the
// quadratic polynomial that is orthogonal to it under these moments.
uniform sampler2D castle_shadow_moments_N;
in float castle_shadow_depth_N;

// So much of the moments of 0, and of -1 and 1 half as often: what rounding makes of one single depth would be no moments at all.
// These three stay apart wherever that depth lies; were they 0 and 1 alone, a depth near one of the ends would be lost in the
// rounding, and all behind it lit. It must be little, as it is a veil in front of everything.
const float moment_bias_N = 3e-6;
// Four moments allow less that is not there than variance does.
const float dark_share_N = 0.25;

// The share of light that passes. Depths run from -1 to 1 here: their powers are rounded less than those of 0 to 1 are.
float allowed_share_N(const in vec4 moments, const in float depth)
{
  vec4 b = mix(moments, vec4(0.0, 0.5, 0.0, 0.5), moment_bias_N);
  // The matrix of rows 1 b.x b.y, b.x b.y b.z, b.y b.z b.w is L D L^T; solved for 1, depth, depth^2.
  float d1 = b.y - b.x * b.x;
  float below = b.z - b.x * b.y;
  float l21 = below / d1;
  float d2 = b.w - b.y * b.y - below * l21;
  float y1 = depth - b.x;
  float c2 = (depth * depth - b.y - l21 * y1) / d2;
  float c1 = y1 / d1 - l21 * c2;
  float c0 = 1.0 - b.x * c1 - b.y * c2;
  float middle = -0.5 * c1 / c2;
  float apart = sqrt(max(middle * middle - c0 / c2, 0.0));
  float near = middle - apart;
  float far = middle + apart;
  if (depth <= near)
    return 1.0;
  if (depth <= far)
    return 1.0 - (depth * far - b.x * (depth + far) + b.y) / ((far - near) * (depth - near));
  return (near * far - b.x * (near + far) + b.y) / ((depth - near) * (depth - far));
}

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  vec2 place = shadow_coord_N().st;
  float depth = clamp(2.0 * castle_shadow_depth_N - 1.0, -1.0, 1.0);
  float share = allowed_share_N(textureLod(castle_shadow_moments_N, place, 0.0), depth);
  float light = light_of_share_N(share, dark_share_N);
  light_scale *= place == clamp(place, 0.0, 1.0) ? light : 1.0; // outside of the map all is lit
}

// The mean of 16 bilinear look-ups, spread over a disc so that none is near another, and turned by another angle in every pixel:
// where equal look-ups would show bands, there is noise. The angle is a hash of the pixel's place on the screen, so nothing moves
// while the camera stands still.
#ifndef POINT
uniform sampler2DShadow castle_shadow_map_N;
#endif

// In texels: with the bilinear filter's own width, about what 3 x 3 look-ups cover.
const float disc_radius_N = 1.5;
// In a disc of radius 1, no two nearer than 0.4.
const vec2 disc_N[16] = vec2[16](
  vec2(-0.800, -0.427), vec2(-0.365, -0.345), vec2(-0.245, -0.837), vec2(0.081, -0.597),
  vec2(0.037, -0.189), vec2(0.385, -0.885), vec2(0.537, -0.307), vec2(0.972, -0.147),
  vec2(0.438, 0.175), vec2(0.703, 0.591), vec2(0.301, 0.743), vec2(-0.003, 0.419),
  vec2(-0.032, 0.978), vec2(-0.463, 0.776), vec2(-0.329, 0.081), vec2(-0.766, 0.149));

// From 0 to 2 pi.
float pixel_angle_N()
{
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint hash = pixel.x * 0x9E3779B1u + pixel.y * 0x85EBCA77u;
  hash = (hash ^ (hash >> 15)) * 0x2C1B3C6Du;
  return float((hash ^ (hash >> 12)) & 0xFFFFu) * (6.2831853 / 65536.0);
}

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
#ifdef POINT
  vec3 from_light = castle_projected_tex_coord_N.xyz;
  float depth = length(from_light);
  vec3 right, up;
  shadow_across_N(from_light, right, up);
#else
  vec3 map_coord = shadow_coord_N();
  vec2 reach = disc_radius_N / vec2(textureSize(castle_shadow_map_N, 0));
#endif
  float angle = pixel_angle_N();
  float c = cos(angle), s = sin(angle);
  mat2 turn = mat2(c, s, -s, c);
  float sum = 0.0;
  for (int i = 0; i < 16; ++i)
  {
#ifdef POINT
    vec2 place = disc_radius_N * (turn * disc_N[i]);
    sum += shadow_lit_N(from_light + place.x * right + place.y * up, depth);
#else
    sum += texture(castle_shadow_map_N, vec3(map_coord.st + reach * (turn * disc_N[i]), map_coord.p));
#endif
  }
  light_scale *= sum / 16.0;
}

// The map of light N compared once. Its filter decides whether that is the nearest texel (`hard`), or the four around the place,
// compared and weighted by the hardware (`bilinear`).
uniform sampler2DShadow castle_shadow_map_N;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  light_scale *= texture(castle_shadow_map_N, shadow_coord_N());
}

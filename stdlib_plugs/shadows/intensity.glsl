// shadowIntensity of light N: what a shadow takes away is taken in part. One half stands before the method, one behind it.
#ifdef BEFORE
float unshadowed_N;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  unshadowed_N = light_scale;
}
#endif
#ifdef AFTER
uniform float castle_shadow_intensity_N;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  light_scale = mix(unshadowed_N, light_scale, castle_shadow_intensity_N);
}
#endif

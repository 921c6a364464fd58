// The shadow of light N, traced for every pixel of the picture before it is drawn.
uniform sampler2D castle_shadow_mask_N;

void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  light_scale *= texelFetch(castle_shadow_mask_N, ivec2(gl_FragCoord.xy), 0).r;
}

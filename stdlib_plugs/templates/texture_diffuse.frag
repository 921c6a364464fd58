// What MultiTexture calls DIFFUSE: the colour in front of the first texture.
vec4 diffuse_color;

void PLUG_main_texture_apply(inout vec4 fragment_color, const in vec3 normal_eye)
{
  diffuse_color = fragment_color;
}

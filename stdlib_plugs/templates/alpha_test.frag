// Alpha test of textures whose alpha is all or nothing (X3D 4.1, 12.2.3: alphaMode MASK, alphaCutoff 0.5).
void PLUG_fragment_end(const in vec4 fragment_color)
{
  if (fragment_color.a < 0.5)
    discard;
}

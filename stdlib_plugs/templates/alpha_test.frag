// Alpha test (X3D 4.1, 12.2.3: alphaMode MASK), and that of textures whose alpha is all or nothing.
#ifdef CUTOFF
uniform float castle_AlphaCutoff;

#endif
void PLUG_fragment_end(const in vec4 fragment_color)
{
#ifdef CUTOFF
  if (fragment_color.a < castle_AlphaCutoff)
#else
  if (fragment_color.a < 0.5)
#endif
    discard;
}

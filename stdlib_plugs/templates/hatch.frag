// Hatches over a face, in the picture's own grid, neither lit nor turned with the face (X3D 4.1, FillProperties and table 12.3).
#ifdef HATCHED
uniform vec3 castle_HatchColor;
#endif

void PLUG_fragment_modify(inout vec4 fragment_color)
{
  bool hatched = false;
  vec2 at = mod(gl_FragCoord.xy, 8.0);
  vec2 across = mod(vec2(gl_FragCoord.x + gl_FragCoord.y, gl_FragCoord.x - gl_FragCoord.y), 8.0);
#ifdef HORIZONTAL
  hatched = hatched || at.y < 1.0;
#endif
#ifdef VERTICAL
  hatched = hatched || at.x < 1.0;
#endif
#ifdef RISING
  hatched = hatched || across.y < 1.0;
#endif
#ifdef FALLING
  hatched = hatched || across.x < 1.0;
#endif
#ifdef HATCHED
  if (hatched)
    fragment_color = vec4(castle_HatchColor, 1.0);
#endif
#ifdef UNFILLED
  if (!hatched)
    discard;
#endif
}

// Dashes and dots (X3D 4.1, table 12.2): a pattern of 16 pixels along each line, counted from an end of it.
uniform vec2 castle_TargetSize;
in vec4 castle_line_place;
flat in vec4 castle_line_end;

void PLUG_fragment_end(const in vec4 fragment_color)
{
  vec2 way = castle_line_place.xy / castle_line_place.w - castle_line_end.xy / castle_line_end.w;
  float place = mod(0.5 * length(way * castle_TargetSize), 16.0);
#ifdef DASHED
  bool drawn = place < 10.0;
#endif
#ifdef DOTTED
  bool drawn = mod(place, 4.0) < 2.0;
#endif
#ifdef DASH_DOT
  bool drawn = place < 8.0 || (place >= 11.0 && place < 13.0);
#endif
#ifdef DASH_DOT_DOT
  bool drawn = place < 6.0 || (place >= 8.0 && place < 10.0) || (place >= 12.0 && place < 14.0);
#endif
  if (!drawn)
    discard;
}

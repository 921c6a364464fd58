// A triangle over the whole picture, from no vertex data.
#ifdef POSITION_01
out vec2 screenf_01_position;
#endif

void main()
{
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
#ifdef POSITION_01
  screenf_01_position = corner;
#endif
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}

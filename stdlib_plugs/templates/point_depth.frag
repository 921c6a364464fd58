// Depth pass of a point light's shadow map: what is stored is the distance to the light, as a share of the largest. OpenGL moves
// depths that a program writes by no polygon offset, so it is done here: by the slope, and by units of 24 bits.
in vec4 castle_vertex_eye;
uniform vec3 castle_DepthPassRange;  // 1 / the largest distance, the slope's factor, the constant part

void PLUG_fragment_end(const in vec4 fragment_color)
{
  float depth = length(castle_vertex_eye.xyz) * castle_DepthPassRange.x;
  float slope = max(abs(dFdx(depth)), abs(dFdy(depth)));
  gl_FragDepth = depth + castle_DepthPassRange.y * slope + castle_DepthPassRange.z;
}

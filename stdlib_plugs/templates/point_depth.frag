// Depth pass of a point light's shadow map: what is stored is the distance to the light, as a share of the largest. OpenGL moves
// depths that a program writes by no polygon offset, so it is done here: by the slope, and by units of 24 bits. Where the light
// stands straight in front of a plane there is no slope, but distances grow all around, with the square of the way: the last term is
// that growth over as many texels as the slope's factor allows for to either side.
in vec4 castle_vertex_eye;
uniform vec4 castle_DepthPassRange;  // 1 / the largest distance, the slope's factor, the constant part, the least share that casts

void PLUG_fragment_end(const in vec4 fragment_color)
{
  vec3 from_light = castle_vertex_eye.xyz;
  float depth = length(from_light) * castle_DepthPassRange.x;
  float slope = max(abs(dFdx(depth)), abs(dFdy(depth)));
  float step_squared = max(dot(dFdx(from_light), dFdx(from_light)), dot(dFdy(from_light), dFdy(from_light)));
  float reach = 0.5 * castle_DepthPassRange.y;
  float growth = 0.5 * reach * reach * step_squared / length(from_light) * castle_DepthPassRange.x;
#ifdef NEAR
  if (depth < castle_DepthPassRange.w)
    discard;
#endif
  gl_FragDepth = depth + castle_DepthPassRange.y * slope + growth + castle_DepthPassRange.z;
}

uniform float time;
attribute float weight;
varying vec3 place;
const float speeds[2] = float[2](1.0, 2.5e-1);

void PLUG_vertex_object_space(const in vec4 vertex_object, inout vec3 normal_object);
void PLUG_vertex_object_space_change(inout vec4 vertex_object, inout vec3 normal_object) {
  vertex_object.y += sin(time * speeds[0] + vertex_object.x) * weight;
  place = (gl_ModelViewMatrix * vertex_object).xyz;
  gl_Position = ftransform();
  /* PLUG: wave_height (vertex_object.y, place) */
}

#define LONG(x) \
  ((x) * 2.0) /* more
*/ + 1.0
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
/* VARYING-PASSTHROUGH-GEOMETRY-SHADERS */
flat centroid in vec3 n[];
void main() { for (int i = 0; i < gl_in.length(); ++i) { EmitVertex(); } }

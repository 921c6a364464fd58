// How large a point is, in pixels (X3D 4.1, PointProperties): it falls with the distance from the viewer, within bounds.
uniform float castle_PointSize;
uniform float castle_PointSizeLeast;
uniform float castle_PointSizeMost;
uniform vec3 castle_PointFalloff;  // constant, by the distance, by its square

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  float away = length(vertex_eye.xyz);
  float size = castle_PointSize / max(dot(castle_PointFalloff, vec3(1.0, away, away * away)), 1e-6);
  gl_PointSize = max(clamp(size, castle_PointSizeLeast, max(castle_PointSizeLeast, castle_PointSizeMost)), 1.0);
}

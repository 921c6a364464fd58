// How far a vertex lies on the side of clip plane N that stays (X3D 4.1, 11.4.1).
uniform vec4 castle_clip_plane_N;
out float castle_clip_distance_N;

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  castle_clip_distance_N = dot(castle_clip_plane_N, vertex_eye);
}

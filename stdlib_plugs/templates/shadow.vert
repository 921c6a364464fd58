// Where a vertex lies in the shadow map of light N.
uniform mat4 castle_projector_matrix_N;
out vec4 castle_projected_tex_coord_N;
#ifdef MOMENTS
uniform vec4 castle_shadow_depth_plane_N;
out float castle_shadow_depth_N;
#endif

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  castle_projected_tex_coord_N = castle_projector_matrix_N * vertex_eye;
#ifdef MOMENTS
  castle_shadow_depth_N = dot(castle_shadow_depth_plane_N, vertex_eye);
#endif
}

// Where a vertex lies in the shadow map of light N.
uniform mat4 castle_projector_matrix_N;
out vec4 castle_projected_tex_coord_N;

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  castle_projected_tex_coord_N = castle_projector_matrix_N * vertex_eye;
}

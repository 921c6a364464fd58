// For dashes: where the fragment lies in the picture, and where an end of its line does (one end speaks for all of a line).
uniform mat4 castle_ProjectionMatrix;
out vec4 castle_line_place;
flat out vec4 castle_line_end;

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  castle_line_place = castle_ProjectionMatrix * vertex_eye;
  castle_line_end = castle_line_place;
}

// From the space of a normal map to eye space: x along the tangent, y across it, z out of the surface.
in vec4 castle_Tangent;
out mat3 castle_tangent_to_eye_space;

/* PLUG-DECLARATIONS */

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  vec4 tangent_object = castle_Tangent;
  /* PLUG: tangent_object_space (tangent_object) */
  vec3 tangent_eye = normalize(mat3(castle_ModelViewMatrix) * tangent_object.xyz);
  castle_tangent_to_eye_space = mat3(tangent_eye, cross(normal_eye, tangent_eye) * tangent_object.w, normal_eye);
}

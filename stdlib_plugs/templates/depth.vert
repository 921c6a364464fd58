// Depth pass of a shadow map: the shape's vertices, moved by its vertex effects, seen from the light.
uniform mat4 castle_ModelViewMatrix;
uniform mat4 castle_ProjectionMatrix;
in vec4 castle_Vertex;
#ifdef NORMALS
uniform mat3 castle_NormalMatrix;
in vec3 castle_Normal;
#endif
#ifdef VERTEX_EYE
out vec4 castle_vertex_eye;
#endif
#ifdef NORMAL_EYE
out vec3 castle_normal_eye;
#endif

/* PLUG-DECLARATIONS */

void main()
{
  vec4 vertex_object = castle_Vertex;
#ifdef NORMALS
  vec3 normal_object = castle_Normal;
#else
  vec3 normal_object = vec3(0.0, 0.0, 1.0);
#endif
  /* PLUG: vertex_object_space_change (vertex_object, normal_object) */
  /* PLUG: vertex_object_space (vertex_object, normal_object) */
  vec4 vertex_eye = castle_ModelViewMatrix * vertex_object;
#ifdef NORMALS
  vec3 normal_eye = normalize(castle_NormalMatrix * normal_object);
#else
  vec3 normal_eye = vec3(0.0, 0.0, 1.0);
#endif
  /* PLUG: vertex_eye_space (vertex_eye, normal_eye) */
  /* PLUG: vertex_eye_space_extended (vertex_eye, normal_eye, normal_object) */
#ifdef VERTEX_EYE
  castle_vertex_eye = vertex_eye;
#endif
#ifdef NORMAL_EYE
  castle_normal_eye = normal_eye;
#endif
  gl_Position = castle_ProjectionMatrix * vertex_eye;
}

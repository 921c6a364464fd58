// Texture coordinates of unit N on their way to the fragments: the mesh's own, or generated (X3D 4.1, table 18.6).
#ifdef OF_MESH
in vec4 castle_MultiTexCoordN;
#endif
#ifdef TEXTURE_MATRIX
uniform mat4 castle_TextureMatrixN;
#endif
#ifdef PARAMETER
uniform vec4 castle_texture_coord_parameter_N;
#endif
#ifdef PROJECTION
uniform mat4 castle_texture_projector_N;
#endif
#ifdef IN_WORLD_SPACE
uniform mat3 castle_CameraRotationInverseMatrix;
#endif
out vec4 castle_TexCoordN;

#ifdef IN_OBJECT_SPACE
void PLUG_vertex_object_space(const in vec4 vertex_object, inout vec3 normal_object)
#else
void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
#endif
{
#ifdef OF_MESH
  vec4 tex_coord = castle_MultiTexCoordN;
#endif
#ifdef SPHERE
  vec4 tex_coord = vec4(normal_eye.xy * 0.5 + 0.5, 0.0, 1.0);
#endif
#ifdef SPHERE_LOCAL
  vec4 tex_coord = vec4(normal_object.xy * 0.5 + 0.5, 0.0, 1.0);
#endif
#ifdef CAMERA_SPACE_NORMAL
  vec4 tex_coord = vec4(normal_eye, 1.0);
#endif
#ifdef CAMERA_SPACE_POSITION
  vec4 tex_coord = vertex_eye;
#endif
#ifdef CAMERA_SPACE_REFLECTION
  vec4 tex_coord = vec4(reflect(normalize(vertex_eye.xyz), normal_eye), 1.0);
#endif
#ifdef COORD
  vec4 tex_coord = vertex_object;
#endif
#ifdef SPHERE_REFLECT
  // With an index of refraction other than 1, what shines through instead of what is mirrored.
  float refraction = castle_texture_coord_parameter_N.x;
  vec3 from_eye = normalize(vertex_eye.xyz);
  vec4 tex_coord = vec4(refraction == 1.0 ? reflect(from_eye, normal_eye)
                                          : refract(from_eye, normal_eye, 1.0 / refraction), 1.0);
#endif
#ifdef SPHERE_REFLECT_LOCAL
  float refraction = castle_texture_coord_parameter_N.x;
  vec3 from_eye = normalize(vertex_object.xyz - castle_texture_coord_parameter_N.yzw);
  vec4 tex_coord = vec4(refraction == 1.0 ? reflect(from_eye, normal_object)
                                          : refract(from_eye, normal_object, 1.0 / refraction), 1.0);
#endif
#ifdef WORLD_SPACE_NORMAL
  vec4 tex_coord = vec4(castle_CameraRotationInverseMatrix * normal_eye, 1.0);
#endif
#ifdef WORLD_SPACE_REFLECTION
  vec4 tex_coord = vec4(castle_CameraRotationInverseMatrix * reflect(normalize(vertex_eye.xyz), normal_eye), 1.0);
#endif
#ifdef PROJECTION
  vec4 tex_coord = castle_texture_projector_N * vertex_eye;
#endif
#ifdef TEXTURE_MATRIX
  tex_coord = castle_TextureMatrixN * tex_coord;
#endif
  castle_TexCoordN = tex_coord;
}

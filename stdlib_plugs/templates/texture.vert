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
#ifdef NOISE

// Noise of gradients on the lattice of whole numbers: what the gradient at a corner of the cell adds.
float corner_noise_N(const in vec3 cell, const in vec3 from_corner)
{
  uvec3 scattered = uvec3(ivec3(cell)) * uvec3(0x8DA6B343u, 0xD8163841u, 0xCB1AB31Fu);
  uint hash = scattered.x ^ scattered.y ^ scattered.z;
  hash = (hash ^ (hash >> 15)) * 0x2C1B3C6Du;
  hash = (hash ^ (hash >> 12)) * 0x297A2D39u;
  hash ^= hash >> 15;
  vec3 gradient = vec3(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u) / 511.5 - 1.0;
  return dot(gradient, from_corner);
}

// About -1 to 1, and 0 at whole numbers.
float gradient_noise_N(const in vec3 place)
{
  vec3 cell = floor(place);
  vec3 at = place - cell;
  vec3 share = at * at * at * (at * (at * 6.0 - 15.0) + 10.0);
  float sums[4];
  for (int i = 0; i < 4; ++i)
  {
    vec3 corner = vec3(0.0, float(i & 1), float(i >> 1));
    float left = corner_noise_N(cell + corner, at - corner);
    corner.x = 1.0;
    sums[i] = mix(left, corner_noise_N(cell + corner, at - corner), share.x);
  }
  return mix(mix(sums[0], sums[1], share.y), mix(sums[2], sums[3], share.y), share.z);
}
#endif

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
#ifdef NOISE
#ifdef IN_OBJECT_SPACE
  vec3 place = vertex_object.xyz;
#else
  vec3 place = vertex_eye.xyz;
#endif
  // three noises that have nothing to do with each other, as shares of the texture
  vec3 noises = vec3(gradient_noise_N(place), gradient_noise_N(place + 57.5), gradient_noise_N(place + 113.25));
  vec4 tex_coord = vec4(noises * 0.5 + 0.5, 1.0);
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

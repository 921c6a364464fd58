// Texture coordinates of unit N on their way to the fragments.
in vec4 castle_MultiTexCoordN;
#ifdef TEXTURE_MATRIX
uniform mat4 castle_TextureMatrixN;
#endif
out vec4 castle_TexCoordN;

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
#ifdef TEXTURE_MATRIX
  castle_TexCoordN = castle_TextureMatrixN * castle_MultiTexCoordN;
#else
  castle_TexCoordN = castle_MultiTexCoordN;
#endif
}

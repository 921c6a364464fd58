// Gouraud shading, vertex stage: the lights are summed here, a colour goes to the fragments.
uniform mat4 castle_ModelViewMatrix;
uniform mat4 castle_ProjectionMatrix;
in vec4 castle_Vertex;
#ifdef NORMALS
uniform mat3 castle_NormalMatrix;
in vec3 castle_Normal;
#endif
#ifdef COLOR_PER_VERTEX
in vec4 castle_ColorPerVertex;
#endif
#ifdef VERTEX_EYE
out vec4 castle_vertex_eye;
#endif
#ifdef NORMAL_EYE
out vec3 castle_normal_eye;
#endif
out vec4 castle_Color;

#ifdef LIT
uniform vec4 castle_MaterialDiffuseAlpha;
#ifdef AMBIENT
uniform vec3 castle_MaterialAmbient;
uniform vec3 castle_GlobalAmbient;
#endif
#ifdef SPECULAR
uniform vec3 castle_MaterialSpecular;
uniform float castle_MaterialShininess;
#endif
#ifdef EMISSIVE
uniform vec3 castle_MaterialEmissive;
#endif

struct MaterialInfo
{
  vec4 diffuse_alpha;
  vec3 ambient;
  vec3 specular;
  float shininess;
};
#endif
#ifdef UNLIT
uniform vec4 castle_UnlitColor;
#endif

/* PLUG-DECLARATIONS */

#ifdef LIT
vec4 lighting(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  MaterialInfo material;
#ifdef AMBIENT
  material.ambient = castle_MaterialAmbient;
#else
  material.ambient = vec3(0.0);
#endif
  /* PLUG: material_ambient (material.ambient) */
#ifdef SPECULAR
  material.specular = castle_MaterialSpecular;
  material.shininess = castle_MaterialShininess;
#else
  material.specular = vec3(0.0);
  material.shininess = 1.0;
#endif
  /* PLUG: material_specular (material.specular) */
  /* PLUG: material_shininess (material.shininess) */
  material.diffuse_alpha = castle_MaterialDiffuseAlpha;
#ifdef COLOR_PER_VERTEX
  material.diffuse_alpha = castle_ColorPerVertex * vec4(1.0, 1.0, 1.0, material.diffuse_alpha.a);
#endif

#ifdef AMBIENT
  vec4 result = vec4(material.ambient * castle_GlobalAmbient, material.diffuse_alpha.a);
#else
  vec4 result = vec4(0.0, 0.0, 0.0, material.diffuse_alpha.a);
#endif
  /* PLUG: add_light (result, vertex_eye, normal_eye, material) */
  /* PLUG: add_light_contribution (result, vertex_eye, normal_eye, material.shininess, material.diffuse_alpha) */
#ifdef EMISSIVE
  vec3 emissive = castle_MaterialEmissive;
  /* PLUG: material_emissive (emissive) */
  result = vec4(result.rgb + emissive, result.a);
#endif
  return vec4(min(result.rgb, vec3(1.0)), result.a);
}
#endif

#ifdef UNLIT
vec4 lighting(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  vec4 result = castle_UnlitColor;
#ifdef COLOR_PER_VERTEX
  result = castle_ColorPerVertex * vec4(1.0, 1.0, 1.0, result.a);
#endif
  /* PLUG: material_emissive (result.rgb) */
  return result;
}
#endif

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
#ifdef TWO_SIDED
  if (normal_eye.z < 0.0)
    normal_eye = -normal_eye;
#endif
  castle_Color = lighting(vertex_eye, normal_eye);
  /* PLUG: lighting_apply (castle_Color, vertex_eye, normal_eye) */
  gl_Position = castle_ProjectionMatrix * vertex_eye;
}

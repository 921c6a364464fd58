// Phong shading, fragment stage: the material, the sum of the lights, then what effects do to the result.
#ifdef VERTEX_EYE
in vec4 castle_vertex_eye;
#endif
#ifdef NORMALS
in vec3 castle_normal_eye;
#endif
#ifdef COLOR_PER_VERTEX
in vec4 castle_ColorPerVertexFragment;
#endif
out vec4 castle_FragColor;

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

// Everything that textures and effects do to the colour that enters the lighting (or, unlit, is the result).
void main_texture_apply(inout vec4 fragment_color, const in vec3 normal_eye)
{
  /* PLUG: main_texture_apply (fragment_color, normal_eye) */
  /* PLUG: texture_apply (fragment_color, normal_eye) */
}

#ifdef LIT
vec4 lighting(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  MaterialInfo material;
  material.diffuse_alpha = castle_MaterialDiffuseAlpha;
#ifdef COLOR_PER_VERTEX
  material.diffuse_alpha = castle_ColorPerVertexFragment * vec4(1.0, 1.0, 1.0, material.diffuse_alpha.a);
#endif
  main_texture_apply(material.diffuse_alpha, normal_eye);
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

#ifdef AMBIENT
  vec4 result = vec4(material.ambient * castle_GlobalAmbient, material.diffuse_alpha.a);
#else
  vec4 result = vec4(0.0, 0.0, 0.0, material.diffuse_alpha.a);
#endif
  /* PLUG: add_light (result, vertex_eye, normal_eye, material) */
  /* PLUG: add_light_contribution (result, vertex_eye, normal_eye, material.shininess, material.diffuse_alpha) */
  /* PLUG: material_occlusion (result) */
#ifdef EMISSIVE
  vec3 emissive = castle_MaterialEmissive;
  /* PLUG: material_emissive (emissive) */
  result.rgb += emissive;
#endif
  result.rgb = min(result.rgb, vec3(1.0));
  return result;
}
#endif

#ifdef UNLIT
vec4 lighting(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  vec4 result = castle_UnlitColor;
#ifdef COLOR_PER_VERTEX
  result = castle_ColorPerVertexFragment * vec4(1.0, 1.0, 1.0, result.a);
#endif
  main_texture_apply(result, normal_eye);
  /* PLUG: material_emissive (result.rgb) */
  return result;
}
#endif

void main()
{
#ifdef VERTEX_EYE
  vec4 vertex_eye = castle_vertex_eye;
#else
  vec4 vertex_eye = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef NORMALS
  vec3 normal_eye = normalize(castle_normal_eye);
#ifdef TWO_SIDED
  if (!gl_FrontFacing)
    normal_eye = -normal_eye;
#endif
#else
  vec3 normal_eye = vec3(0.0, 0.0, 1.0);
#endif
  /* PLUG: fragment_eye_space (vertex_eye, normal_eye) */
  vec4 fragment_color = lighting(vertex_eye, normal_eye);
  /* PLUG: lighting_apply (fragment_color, vertex_eye, normal_eye) */
  /* PLUG: fragment_modify (fragment_color) */
  /* PLUG: fog_apply (fragment_color, normal_eye) */
  castle_FragColor = fragment_color;
  /* PLUG: fragment_end (castle_FragColor) */
}

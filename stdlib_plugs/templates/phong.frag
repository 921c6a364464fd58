// Phong shading, fragment stage: the material, the sum of the lights, then what effects do to the result.
#ifdef VERTEX_EYE
in vec4 castle_vertex_eye;
#endif
#ifdef NORMAL_EYE
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
#ifdef BACK_MATERIAL
uniform vec4 castle_BackMaterialDiffuseAlpha;
#ifdef AMBIENT
uniform vec3 castle_BackMaterialAmbient;
#endif
#ifdef SPECULAR
uniform vec3 castle_BackMaterialSpecular;
uniform float castle_BackMaterialShininess;
#endif
#ifdef EMISSIVE
uniform vec3 castle_BackMaterialEmissive;
#endif
#endif

struct MaterialInfo
{
  vec4 diffuse_alpha;
  vec3 ambient;
  vec3 specular;
  float shininess;
};
#endif
#ifdef PHYSICAL
uniform vec4 castle_MaterialBaseAlpha;
uniform float castle_MaterialMetallic;
uniform float castle_MaterialRoughness;
#ifdef EMISSIVE
uniform vec3 castle_MaterialEmissive;
#endif
#ifdef BACK_MATERIAL
uniform vec4 castle_BackMaterialBaseAlpha;
uniform float castle_BackMaterialMetallic;
uniform float castle_BackMaterialRoughness;
#ifdef EMISSIVE
uniform vec3 castle_BackMaterialEmissive;
#endif
#endif

struct MaterialInfo
{
  float perceptualRoughness;
  vec3 reflectance0;  // what is mirrored of light that comes straight from above, and (reflectance90) from the horizon
  float alphaRoughness;
  vec3 diffuseColor;
  vec3 reflectance90;
  vec3 specularColor;
};
#endif
#ifdef UNLIT
uniform vec4 castle_UnlitColor;
#ifdef BACK_MATERIAL
uniform vec4 castle_BackUnlitColor;
#endif
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
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
    material.diffuse_alpha = castle_BackMaterialDiffuseAlpha;
#endif
#ifdef COLOR_PER_VERTEX
  material.diffuse_alpha = castle_ColorPerVertexFragment * vec4(1.0, 1.0, 1.0, material.diffuse_alpha.a);
#endif
  main_texture_apply(material.diffuse_alpha, normal_eye);
#ifdef AMBIENT
  material.ambient = castle_MaterialAmbient;
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
    material.ambient = castle_BackMaterialAmbient;
#endif
#else
  material.ambient = vec3(0.0);
#endif
  /* PLUG: material_ambient (material.ambient) */
#ifdef SPECULAR
  material.specular = castle_MaterialSpecular;
  material.shininess = castle_MaterialShininess;
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
  {
    material.specular = castle_BackMaterialSpecular;
    material.shininess = castle_BackMaterialShininess;
  }
#endif
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
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
    emissive = castle_BackMaterialEmissive;
#endif
  /* PLUG: material_emissive (emissive) */
  result = vec4(result.rgb + emissive, result.a);
#endif
  return vec4(min(result.rgb, vec3(1.0)), result.a);
}
#endif
#ifdef PHYSICAL
#ifdef VIEW

// The share of a light's colour that goes on to the viewer: glTF 2.0, appendix B.3 (X3D 4.1, 12.2.7): Lambert's diffuse
// reflection below a surface of mirroring facets, distributed as by Trowbridge and Reitz, shading each other as by Smith.
vec3 reflected_share(const in MaterialInfo material, const in vec3 normal_eye, const in vec3 light_dir, const in vec3 view)
{
  const float kPi = 3.14159265;
  float n_l = dot(normal_eye, light_dir);
  if (n_l <= 0.0)
    return vec3(0.0);
  vec3 half_vector = normalize(light_dir + view);
  float n_v = abs(dot(normal_eye, view));
  float n_h = clamp(dot(normal_eye, half_vector), 0.0, 1.0);
  float v_h = clamp(dot(view, half_vector), 0.0, 1.0);
  float alpha_2 = material.alphaRoughness * material.alphaRoughness;
  float spread = n_h * n_h * (alpha_2 - 1.0) + 1.0;
  float distribution = alpha_2 / (kPi * spread * spread);
  float visibility = 0.5 / (n_l * sqrt(n_v * n_v * (1.0 - alpha_2) + alpha_2) + n_v * sqrt(n_l * n_l * (1.0 - alpha_2) + alpha_2));
  vec3 mirrored = material.reflectance0 + (material.reflectance90 - material.reflectance0) * pow(1.0 - v_h, 5.0);
  return n_l * ((1.0 - mirrored) * material.diffuseColor / kPi + mirrored * distribution * visibility);
}
#endif

vec4 lighting(const in vec4 vertex_eye, const in vec3 normal_eye)
{
  vec4 base = castle_MaterialBaseAlpha;
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
    base = castle_BackMaterialBaseAlpha;
#endif
#ifdef COLOR_PER_VERTEX
  base = castle_ColorPerVertexFragment * vec4(1.0, 1.0, 1.0, base.a);
#endif
  main_texture_apply(base, normal_eye);
  float metallic = castle_MaterialMetallic;
  float roughness = castle_MaterialRoughness;
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
  {
    metallic = castle_BackMaterialMetallic;
    roughness = castle_BackMaterialRoughness;
  }
#endif
  /* PLUG: material_metallic_roughness (metallic, roughness) */
  metallic = clamp(metallic, 0.0, 1.0);
  MaterialInfo material;
  material.perceptualRoughness = clamp(roughness, 0.04, 1.0);
  material.alphaRoughness = material.perceptualRoughness * material.perceptualRoughness;
  material.reflectance0 = mix(vec3(0.04), base.rgb, metallic);
  material.reflectance90 = vec3(1.0);
  material.specularColor = material.reflectance0;
  material.diffuseColor = base.rgb * 0.96 * (1.0 - metallic);
  vec4 result = vec4(0.0, 0.0, 0.0, base.a);
#ifdef VIEW
  vec3 view = normalize(-vertex_eye.xyz);
#else
  vec3 view = vec3(0.0, 0.0, 1.0);
#endif
  /* PLUG: add_light (result, vertex_eye, normal_eye, material, view) */
  /* PLUG: material_occlusion (result) */
#ifdef EMISSIVE
  vec3 emissive = castle_MaterialEmissive;
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
    emissive = castle_BackMaterialEmissive;
#endif
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
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing)
    result = castle_BackUnlitColor;
#endif
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
#ifdef NORMAL_EYE
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
#ifdef PHYSICAL
  fragment_color.rgb = pow(max(fragment_color.rgb, vec3(0.0)), vec3(1.0 / 2.2));  // linear light, encoded for the screen
#endif
  /* PLUG: fog_apply (fragment_color, normal_eye) */
  castle_FragColor = fragment_color;
  /* PLUG: fragment_end (castle_FragColor) */
}

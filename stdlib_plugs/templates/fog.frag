// Fog and LocalFog (X3D 4.1, 24.4.2): from the visibility range on nothing but the fog is seen.
uniform vec3 castle_FogColor;
uniform float castle_FogVisibilityRange;
#ifdef EITHER
uniform float castle_FogExponential;
#endif
in float castle_FogFragCoord;

void PLUG_fog_apply(inout vec4 fragment_color, const in vec3 normal_eye_fragment)
{
#ifdef EITHER
  // the fog of this view: the views of a scene may differ in it
  float clear = castle_FogVisibilityRange - castle_FogFragCoord;
  float exponential = clear > 0.0 ? min(exp(-castle_FogFragCoord / clear), 1.0) : 0.0;
  float linear = clamp(1.0 - castle_FogFragCoord / castle_FogVisibilityRange, 0.0, 1.0);
  float visible = castle_FogExponential == 0.0 ? linear : exponential;
#endif
#ifdef LINEAR
  float visible = clamp(1.0 - castle_FogFragCoord / castle_FogVisibilityRange, 0.0, 1.0);
#endif
#ifdef EXPONENTIAL
  float clear = castle_FogVisibilityRange - castle_FogFragCoord;
  float visible = clear > 0.0 ? min(exp(-castle_FogFragCoord / clear), 1.0) : 0.0;
#endif
  fragment_color.rgb = mix(castle_FogColor, fragment_color.rgb, visible);
}

// Fog and LocalFog (X3D 4.1, 24.4.2): from the visibility range on nothing but the fog is seen.
uniform vec3 castle_FogColor;
uniform float castle_FogVisibilityRange;
in float castle_FogFragCoord;

void PLUG_fog_apply(inout vec4 fragment_color, const in vec3 normal_eye_fragment)
{
#ifdef LINEAR
  float visible = clamp(1.0 - castle_FogFragCoord / castle_FogVisibilityRange, 0.0, 1.0);
#else
  float clear = castle_FogVisibilityRange - castle_FogFragCoord;
  float visible = clear > 0.0 ? min(exp(-castle_FogFragCoord / clear), 1.0) : 0.0;
#endif
  fragment_color.rgb = mix(castle_FogColor, fragment_color.rgb, visible);
}

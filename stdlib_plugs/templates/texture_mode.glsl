// How MultiTexture combines texture N (arg1) with the colour so far, or what its `source` names (arg2): X3D 4.1, table 18.3,
// and what leaves the range from 0 to 1 comes back into it only when all is done. Modes that speak of the colour alone multiply alpha.
#ifdef FOR_ALPHA
vec4 texture_alpha_mode_N(const in vec4 arg1, const in vec4 arg2, const in float amount)
#else
vec4 texture_mode_N(const in vec4 arg1, const in vec4 arg2, const in float amount)
#endif
{
#ifdef MODULATE
  return arg1 * arg2;
#endif
#ifdef REPLACE
  return arg1;
#endif
#ifdef SELECTARG2
  return arg2;
#endif
#ifdef MODULATE2X
  return arg1 * arg2 * 2.0;
#endif
#ifdef MODULATE4X
  return arg1 * arg2 * 4.0;
#endif
#ifdef ADD
  return arg1 + arg2;
#endif
#ifdef ADDSIGNED
  return arg1 + arg2 - 0.5;
#endif
#ifdef ADDSIGNED2X
  return (arg1 + arg2 - 0.5) * 2.0;
#endif
#ifdef SUBTRACT
  return arg1 - arg2;
#endif
#ifdef ADDSMOOTH
  return arg1 + (1.0 - arg1) * arg2;
#endif
#ifdef BLEND
  return mix(arg2, arg1, amount);
#endif
#ifdef MODULATEALPHA_ADDCOLOR
  return vec4(arg1.rgb + arg1.a * arg2.rgb, arg1.a * arg2.a);
#endif
#ifdef MODULATEINVALPHA_ADDCOLOR
  return vec4((1.0 - arg1.a) * arg2.rgb + arg1.rgb, arg1.a * arg2.a);
#endif
#ifdef MODULATEINVCOLOR_ADDALPHA
  return vec4((1.0 - arg1.rgb) * arg2.rgb + arg1.a, arg1.a * arg2.a);
#endif
#ifdef DOTPRODUCT3
  return vec4(clamp(4.0 * dot(arg1.rgb - 0.5, arg2.rgb - 0.5), 0.0, 1.0));
#endif
}

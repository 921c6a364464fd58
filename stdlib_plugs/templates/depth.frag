// Depth pass of a shadow map: nothing but depth is written.
/* PLUG-DECLARATIONS */

void main()
{
#ifdef FRAGMENT_END
  vec4 fragment_color = vec4(0.0);
  /* PLUG: fragment_end (fragment_color) */
#endif
}

// Percentage-closer filtering (Reeves, Salesin, Cook 1987): the share of a kernel of texels that are no nearer than the fragment.
void PLUG_light_scale(inout float light_scale, const in vec3 normal_eye, const in vec3 light_dir)
{
  light_scale *= shadow_kernel_N(shadow_coord_N());
}

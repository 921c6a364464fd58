// Depth warped by two exponentials (Lauritzen, McCool 2008, "Layered variance shadow maps"): the first stretches what is far, the
// second what is near, so that light that bleeds through in one is shut out in the other.
// The first exponent is as large as 32-bit floats bear: its second moment reaches exp(2 * 40) = 5.5e34 of 3.4e38. The second is
// small: it looks at what is nearest in the blur, and with a larger one a slanted caster's nearest texel would outweigh all
// others, which shows as blocks.
const vec2 warp_exponents_N = vec2(40.0, 5.0);

vec2 depth_warp_N(const in float depth)
{
  vec2 stretched = warp_exponents_N * (2.0 * depth - 1.0);
  return vec2(exp(stretched.x), -exp(-stretched.y));
}

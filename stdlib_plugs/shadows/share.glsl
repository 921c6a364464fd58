// From the share of light that moments allow, which is never too small, to the share that is let through.
// Four moments may take 0.07 of a plane's own blurred depths for something in front of it: from `lit_share` on it is all.
const float lit_share_N = 0.85;

// Where several casters lie above each other the bound is loose: what it allows up to `dark_share` is none. Halfway between the two
// lies the edge of the shadow, near the half that it has where one caster is far above what it shadows. What is no number is lit.
float light_of_share_N(const in float share, const in float dark_share)
{
  return share < lit_share_N ? max((share - dark_share) / (lit_share_N - dark_share), 0.0) : 1.0;
}

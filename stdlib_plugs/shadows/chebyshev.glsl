// Chebyshev's one-sided inequality: of what has these first two moments, at most this share lies at `value` or beyond. Where
// several casters overlap the bound is too high, and light bleeds into their shadow: shares below `bleeding` count as none, and the
// others are stretched over the whole range again.
float chebyshev_share_N(const in vec2 moments, const in float value, const in float least_variance, const in float bleeding)
{
  float variance = max(moments.y - moments.x * moments.x, least_variance);
  float ahead = value - moments.x;
  float share = variance / (variance + ahead * ahead);
  return ahead > 0.0 ? clamp((share - bleeding) / (1.0 - bleeding), 0.0, 1.0) : 1.0;
}

// Chebyshev's one-sided inequality: of what has these first two moments, at most this share lies at `value` or beyond.
float chebyshev_share_N(const in vec2 moments, const in float value, const in float least_variance)
{
  float variance = max(moments.y - moments.x * moments.x, least_variance);
  float ahead = value - moments.x;
  return ahead > 0.0 ? variance / (variance + ahead * ahead) : 1.0;
}

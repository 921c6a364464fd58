#pragma once
// What an interpolator makes of its keys: X3D 4.1, clause 19. Keys do not decrease (else the result is undefined, but some
// value of the list or between two of them); in front of the first and behind the last of them the value stays.

#include <cstddef>
#include <span>
#include <vector>

namespace plugc {

/// Where a fraction lies among keys: between key `index` and the next one, `weight` of the way (0: at the key itself).
struct KeyInterval {
  std::size_t index = 0;
  double weight = 0;
};

/// Between equal keys there is nothing: from that key on the last of them counts. `count` is how many keys have a value, at
/// least 1.
KeyInterval find_interval(double fraction, std::span<const double> keys, std::size_t count);

/// Keys with their values, `width` numbers each.
struct KeyFrames {
  std::span<const double> keys, values;
  std::size_t width = 1;

  std::size_t count() const;  ///< Keys that have a value.
  std::span<const double> value(std::size_t index) const { return values.subspan(index * width, width); }
};

// Each needs a frame at least, and gives `width` numbers.
std::vector<double> interpolate_linear(double fraction, const KeyFrames& frames);
/// RGB, by hue, saturation and value (19.4.1), the shorter way round.
std::vector<double> interpolate_color(double fraction, const KeyFrames& frames);
/// Unit vectors, along the arc between them.
std::vector<double> interpolate_normals(double fraction, const KeyFrames& frames);
/// Axis and angle in radians, the shorter way round.
std::vector<double> interpolate_rotation(double fraction, const KeyFrames& frames);
/// Rotations along a curve without corners (19.4.13).
std::vector<double> interpolate_squad(double fraction, const KeyFrames& frames);

struct SplineShape {
  std::span<const double> velocities;  ///< As many numbers as the values, or those of the first and last key, or none.
  bool normalize = false;
  bool closed = false;
};
/// 19.2.4.
std::vector<double> interpolate_spline(double fraction, const KeyFrames& frames, const SplineShape& shape);

/// 19.4.4: the fraction of the way to the next key; `easing` holds (in, out) of each key.
double ease(double fraction, std::span<const double> keys, std::span<const double> easing);

}  // namespace plugc

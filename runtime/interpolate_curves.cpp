// Interpolation on curves: rotations as unit quaternions, splines in Hermite's form.

#include <algorithm>
#include <cmath>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/quaternion.hpp>

#include "runtime/interpolate.h"
#include "runtime/rotations.h"

namespace plugc {
namespace {

glm::dquat quaternion_at(const KeyFrames& frames, std::size_t index) {
  return to_quaternion(frames.value(index));
}

/// q or -q, which is the same rotation: whichever is nearer.
glm::dquat nearer(const glm::dquat& q, const glm::dquat& to) {
  return glm::dot(q, to) < 0 ? -q : q;
}

/// glm's intermediate() divides by the angle's sine; between equal rotations there is nothing to bend.
glm::dquat control_point(const glm::dquat& before, const glm::dquat& here, const glm::dquat& behind) {
  const glm::dquat point = glm::intermediate(before, here, behind);
  return std::isfinite(glm::dot(point, point)) ? point : here;
}

double difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// The curve of a spline interpolator, with the tangents that the standard gives it.
class Spline {
 public:
  Spline(const KeyFrames& frames, const SplineShape& shape)
      : frames_(frames), shape_(shape), count_(frames.count()), ends_given_(shape.velocities.size() == 2 * frames.width) {
    all_given_ = count_ != 0 && shape.velocities.size() >= frames.values.size();
    const bool meets = count_ > 2 && difference(frames.value(0), frames.value(count_ - 1)) == 0;
    closed_ = shape.closed && meets && !all_given_ && !ends_given_;
    for (std::size_t i = 0; shape.normalize && i + 1 < count_; ++i) length_ += difference(frames.value(i), frames.value(i + 1));
  }

  /// At that key, scaled for the interval behind it (`leaving`) or in front of it.
  std::vector<double> tangent(std::size_t index, bool leaving) const {
    std::vector<double> result = velocity(index);
    const double scale = interval_scale(index, leaving);
    for (double& number : result) number *= scale;
    return result;
  }

 private:
  std::vector<double> velocity(std::size_t index) const {
    const bool is_end = index == 0 || index == count_ - 1;
    if (all_given_) return given(index);
    if (is_end && ends_given_) return given(index == 0 ? 0 : 1);
    if (is_end && !closed_) return std::vector<double>(frames_.width, 0.0);
    const std::span<const double> before = frames_.value(is_end ? count_ - 2 : index - 1);
    const std::span<const double> behind = frames_.value(is_end ? 1 : index + 1);
    std::vector<double> result;
    for (std::size_t i = 0; i < frames_.width; ++i) result.push_back((behind[i] - before[i]) / 2);
    return result;
  }

  std::vector<double> given(std::size_t index) const {
    const std::span<const double> written = shape_.velocities.subspan(index * frames_.width, frames_.width);
    std::vector<double> result(written.begin(), written.end());
    const double speed = difference(written, std::vector<double>(frames_.width, 0.0));
    if (!shape_.normalize || !(speed > 0)) return result;
    for (double& number : result) number *= length_ / speed;
    return result;
  }

  /// Intervals of unequal length: F+ and F- of the standard.
  double interval_scale(std::size_t index, bool leaving) const {
    const bool is_end = index == 0 || index == count_ - 1;
    if (is_end && !closed_) return 1;
    const std::size_t last = count_ - 1;
    const double before = is_end ? frames_.keys[last] - frames_.keys[last - 1] : frames_.keys[index] - frames_.keys[index - 1];
    const double behind = is_end ? frames_.keys[1] - frames_.keys[0] : frames_.keys[index + 1] - frames_.keys[index];
    const double both = before + behind;
    return both > 0 ? 2 * (leaving ? before : behind) / both : 1;
  }

  const KeyFrames& frames_;
  const SplineShape& shape_;
  std::size_t count_;
  bool ends_given_;
  bool all_given_ = false;
  bool closed_ = false;
  double length_ = 0;  // of the straight way over all keys, where speeds are normalised
};

}  // namespace

std::vector<double> interpolate_rotation(double fraction, const KeyFrames& frames) {
  const KeyInterval at = find_interval(fraction, frames.keys, frames.count());
  const std::span<const double> here = frames.value(at.index);
  if (at.weight == 0) return {here.begin(), here.end()};
  return axis_and_angle(glm::slerp(quaternion_at(frames, at.index), quaternion_at(frames, at.index + 1), at.weight));
}

std::vector<double> interpolate_squad(double fraction, const KeyFrames& frames) {
  const std::size_t count = frames.count();
  const KeyInterval at = find_interval(fraction, frames.keys, count);
  const std::span<const double> here = frames.value(at.index);
  if (at.weight == 0) return {here.begin(), here.end()};
  const glm::dquat from = quaternion_at(frames, at.index);
  const glm::dquat to = nearer(quaternion_at(frames, at.index + 1), from);
  const glm::dquat before = at.index == 0 ? from : nearer(quaternion_at(frames, at.index - 1), from);
  const glm::dquat behind = at.index + 2 >= count ? to : nearer(quaternion_at(frames, at.index + 2), to);
  return axis_and_angle(glm::squad(from, to, control_point(before, from, to), control_point(from, to, behind), at.weight));
}

std::vector<double> interpolate_spline(double fraction, const KeyFrames& frames, const SplineShape& shape) {
  const KeyInterval at = find_interval(fraction, frames.keys, frames.count());
  const std::span<const double> from = frames.value(at.index);
  if (at.weight == 0) return {from.begin(), from.end()};
  const std::span<const double> to = frames.value(at.index + 1);
  const Spline spline(frames, shape);
  const std::vector<double> leaving = spline.tangent(at.index, true), arriving = spline.tangent(at.index + 1, false);
  const double s = at.weight, s2 = s * s, s3 = s2 * s;
  std::vector<double> result;
  for (std::size_t i = 0; i < frames.width; ++i) {
    result.push_back((2 * s3 - 3 * s2 + 1) * from[i] + (3 * s2 - 2 * s3) * to[i] + (s3 - 2 * s2 + s) * leaving[i] +
                     (s3 - s2) * arriving[i]);
  }
  return result;
}

}  // namespace plugc

#include "runtime/interpolate.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace plugc {
namespace {

/// Hue from 0 to 6, saturation, value.
glm::dvec3 to_hsv(const glm::dvec3& rgb) {
  const double high = std::max({rgb.r, rgb.g, rgb.b}), low = std::min({rgb.r, rgb.g, rgb.b});
  const double range = high - low;
  if (!(range > 0)) return {0, 0, high};
  double hue = 0;
  if (high == rgb.r)
    hue = (rgb.g - rgb.b) / range;
  else if (high == rgb.g)
    hue = 2 + (rgb.b - rgb.r) / range;
  else
    hue = 4 + (rgb.r - rgb.g) / range;
  return {hue < 0 ? hue + 6 : hue, high > 0 ? range / high : 0, high};
}

glm::dvec3 to_rgb(const glm::dvec3& hsv) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hsv.x, 6.0);
    return hsv.z - hsv.z * hsv.y * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return {channel(5), channel(3), channel(1)};
}

/// A grey has the other colour's hue.
glm::dvec3 mix_colors(const glm::dvec3& from, const glm::dvec3& to, double weight) {
  glm::dvec3 a = to_hsv(from), b = to_hsv(to);
  if (a.y == 0) a.x = b.x;
  if (b.y == 0) b.x = a.x;
  if (b.x - a.x > 3) a.x += 6;
  if (a.x - b.x > 3) b.x += 6;
  return to_rgb(glm::mix(a, b, weight));
}

/// Along the great circle; between opposite vectors there is none, and the straight way is taken.
glm::dvec3 mix_normals(const glm::dvec3& from, const glm::dvec3& to, double weight) {
  const double lengths = glm::length(from) * glm::length(to);
  const double angle = lengths > 0 ? std::acos(std::clamp(glm::dot(from, to) / lengths, -1.0, 1.0)) : 0;
  const double sine = std::sin(angle);
  constexpr double kParallel = 1e-9;
  if (!(sine > kParallel)) {
    const glm::dvec3 straight = glm::mix(from, to, weight);
    const double length = glm::length(straight);
    return length > 0 ? straight / length : from;
  }
  return (std::sin((1 - weight) * angle) * glm::normalize(from) + std::sin(weight * angle) * glm::normalize(to)) / sine;
}

glm::dvec3 vector_at(std::span<const double> numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

std::vector<double> copy(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

}  // namespace

std::size_t KeyFrames::count() const {
  return width == 0 ? 0 : std::min(keys.size(), values.size() / width);
}

KeyInterval find_interval(double fraction, std::span<const double> keys, std::size_t count) {
  const std::span<const double> used = keys.subspan(0, count);
  if (!(fraction > used.front())) return {0, 0};
  if (fraction >= used.back()) return {count - 1, 0};
  const auto next = std::upper_bound(used.begin(), used.end(), fraction);
  if (next == used.begin() || next == used.end()) return {count - 1, 0};  // keys that decrease
  const auto index = static_cast<std::size_t>(next - used.begin() - 1);
  const double weight = (fraction - used[index]) / (*next - used[index]);
  return {index, std::isfinite(weight) ? std::clamp(weight, 0.0, 1.0) : 0.0};
}

std::vector<double> interpolate_linear(double fraction, const KeyFrames& frames) {
  const KeyInterval at = find_interval(fraction, frames.keys, frames.count());
  std::vector<double> result = copy(frames.value(at.index));
  if (at.weight == 0) return result;
  const std::span<const double> next = frames.value(at.index + 1);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += at.weight * (next[i] - result[i]);
  return result;
}

std::vector<double> interpolate_color(double fraction, const KeyFrames& frames) {
  const KeyInterval at = find_interval(fraction, frames.keys, frames.count());
  if (at.weight == 0) return copy(frames.value(at.index));
  const glm::dvec3 color =
      mix_colors(vector_at(frames.value(at.index), 0), vector_at(frames.value(at.index + 1), 0), at.weight);
  return {color.r, color.g, color.b};
}

std::vector<double> interpolate_normals(double fraction, const KeyFrames& frames) {
  const KeyInterval at = find_interval(fraction, frames.keys, frames.count());
  std::vector<double> result = copy(frames.value(at.index));
  if (at.weight == 0) return result;
  const std::span<const double> next = frames.value(at.index + 1);
  for (std::size_t i = 0; i + 2 < result.size(); i += 3) {
    const glm::dvec3 normal = mix_normals(vector_at(result, i), vector_at(next, i), at.weight);
    for (int c = 0; c < 3; ++c) result[i + static_cast<std::size_t>(c)] = normal[c];
  }
  return result;
}

double ease(double fraction, std::span<const double> keys, std::span<const double> easing) {
  const std::size_t count = std::min(keys.size(), easing.size() / 2);
  if (count == 0) return fraction;
  const KeyInterval at = find_interval(fraction, keys, count);
  if (at.index + 1 >= count) return fraction > keys[0] ? 1 : 0;
  double out = easing[2 * at.index + 1], in = easing[2 * at.index + 2];
  const double sum = in + out, u = at.weight;
  if (!(sum >= 0)) return u;
  if (sum > 1) {
    in /= sum;
    out /= sum;
  }
  const double slope = 1 / (2 - in - out);
  if (u < out) return slope / out * u * u;
  if (u <= 1 - in) return slope * (2 * u - out);
  return 1 - slope * (1 - u) * (1 - u) / in;
}

}  // namespace plugc

#pragma once
// A package made measurable: its colour programs also say which triangle each pixel shows, its lights can be dimmed one by
// one, and its maps get the size and bias of an experiment. Everything else stays as it is drawn for users.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "package/package_file.h"

namespace plugc {

/// What an experiment changes about a scene; what is not given stays.
struct Settings {
  std::optional<std::uint32_t> size;  ///< Of every shadow map.
  std::optional<double> scale;        ///< glPolygonOffset(scale, bias) of every shadow map.
  std::optional<double> bias;
  std::optional<double> projection_near;      ///< Of every light with a map.
  std::optional<glm::dvec3> light_direction;  ///< Of every light with a map.
  /// Everything, lights and viewpoints too, put under one Transform.
  std::optional<double> scene_scale;
  std::optional<glm::dvec3> scene_offset;
};

/// Slots of a light that no other light or shape reads.
struct LightSlots {
  std::uint32_t on = 0;
  std::uint32_t intensity = 0;
};

struct MeasurablePackage {
  std::vector<std::uint8_t> bytes;
  const Package* package = nullptr;
  std::vector<LightSlots> lights;     ///< By light of scene 0.
  std::vector<std::uint32_t> scales;  ///< By shadow map of scene 0: the slot of glPolygonOffset's first factor.
};

/// Colour programs write into output 1: shape, triangle, 0, kSeen.
inline constexpr float kSeen = 7.0F;

/// Intensity of the measured light: so low that no sum of lights reaches 1, where shaders clamp it.
inline constexpr double kMeasuringIntensity = 0.05;

/// `bytes` is a package as written, with one scene. Throws std::runtime_error where it cannot be opened.
MeasurablePackage make_measurable(const std::vector<std::uint8_t>& bytes, const Settings& settings);

/// Only the settings, no measuring: for timing. Throws likewise.
std::vector<std::uint8_t> with_settings(const std::vector<std::uint8_t>& bytes, const Settings& settings);

}  // namespace plugc

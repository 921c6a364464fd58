#pragma once
// How a shape looks into a shadow map. docs/shadow_methods.md tells what each costs and when it is the one to take.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace plugc {

/// Values are those of PackedShadowMethod.
enum class ShadowMethod : std::uint8_t {
  hard,       ///< The nearest texel.
  bilinear,   ///< Four texels, compared and weighted by the hardware.
  pcf2,       ///< The mean of 2 x 2 bilinear look-ups a texel apart.
  pcf3,       ///< Of 3 x 3, through gathers where the target has them.
  pcf4,       ///< Of 4 x 4, the same.
  pcf2_taps,  ///< The same three, never through gathers: to measure against.
  pcf3_taps,
  pcf4_taps,
  sharp3,   ///< The edge of pcf3, sharpened to about a pixel.
  poisson,  ///< 16 bilinear look-ups on a disc that is turned from pixel to pixel.
  traced,   ///< One ray to the light a pixel: no map.
  vsm,      ///< Variance: the map holds the first two moments of depth, blurred.
  evsm,     ///< The same of two exponential warps of depth.
  msm,      ///< The first four moments.
};

inline constexpr ShadowMethod kDefaultShadowMethod = ShadowMethod::bilinear;

/// Whether the map's depths are turned into moments, and blurred, before anybody looks into it.
constexpr bool keeps_moments(ShadowMethod method) {
  return method >= ShadowMethod::vsm;
}

/// All names, in the order of the values: small letters, as on the command line. The field `method` has them in capitals.
std::span<const std::string_view> shadow_method_names();
std::string_view to_text(ShadowMethod method);
/// The method of that name in small letters or in capitals.
std::optional<ShadowMethod> shadow_method_named(std::string_view name);

/// What a point light's cube map is looked up by where that method is asked for: `hard`, `bilinear` and `poisson` as they are,
/// all others by `pcf3`, whose look-ups lie across the ray from the light.
ShadowMethod method_for_cube(ShadowMethod method);

/// The factor of glPolygonOffset that keeps a plane free of false shadow, however it is turned: max(2, k + 1) for a kernel of
/// k x k bilinear look-ups. The kernel reads texels up to (k + 1) / 2 away along either side, over which the plane may come
/// nearer by both its slopes times that; OpenGL counts the larger slope alone (3.3 core, 3.6.4), so it must be counted twice.
/// The nearest texel is half a texel away, so 1 would do; 2 leaves room for the rounding of depth.
/// `poisson` (a disc of 1.5 texels around the place) counts as `pcf3`; `sharp3` as k = 1.5, as the corners of its kernel that
/// then still lie in front are too little to reach the middle of its edge. Moments tell of a plane by themselves how its depths
/// spread, and every step back is light under what stands close to a surface: 0.5 puts a plane half of a standard deviation
/// of its own blurred depths in front of their mean, where four moments allow it 0.93 of the light, and two all of it.
double automatic_slope_scale(ShadowMethod method);
/// glPolygonOffset's other number: steps of the depth format, for planes that face the light, whose depth is rounded too. The
/// default of the field `bias`.
inline constexpr double kAutomaticDepthBias = 4;

/// What a shadow map is where the scene does not say it.
struct ShadowDefaults {
  ShadowMethod method = kDefaultShadowMethod;
  std::uint32_t size = 0;  ///< Texels along a side; 0: what the specification says (128, or 256 for a map that nobody wrote).
};

}  // namespace plugc

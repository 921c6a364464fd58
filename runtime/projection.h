#pragma once
// What a light sees: the view and projection of its shadow map. Whatever the scene leaves at zero is fitted to the boxes
// of the shapes that cast and of those that receive. Here, for maps that authors see: the camera plays no part, so that what a
// light projects stays where it is. Maps of the renderer's own are fitted tighter (tight_fit.h).
// Every result is finite, whatever goes in.

#include <cstdint>
#include <string>
#include <vector>

#include "base/placed_box.h"
#include "runtime/world.h"

namespace plugc {

/// A light as its map needs it, in world space. Zero: to be computed.
struct LightFrame {
  PackedLightKind kind = PackedLightKind::directional;
  glm::dvec3 location{0};
  bool located = true;  ///< Directional: a location or a rectangle is written; else the location is computed too.
  glm::dvec3 direction{0, 0, -1};
  glm::dvec3 up{0};
  bool up_written = true;  ///< Else any other direction across the light's would do as well.
  double near = 0;
  double far = 0;
  double angle = 0;            ///< Spot: full angle in radians.
  bool angle_written = false;  ///< Else it is the light's own, and nothing outside of it is lit.
  double radius = -1;          ///< Spot and point: how far the light reaches; negative: for ever.
  glm::dvec4 rectangle{0};     ///< Directional: left bottom right top.
  std::uint32_t map_size = 1;  ///< Texels along a side: how wide a margin of one texel is.
  double reach = 2;            ///< Texels from a place to the farthest that its look-up reads: the margin of a tight fit.
  double unit = 1;             ///< World length of a unit of the light's own space.

  bool operator==(const LightFrame&) const = default;
};

/// Distances, lengths or tangents.
struct Interval {
  double low = 0;
  double high = 0;
};

struct FitInput {
  std::vector<PlacedBox> casters;
  std::vector<PlacedBox> receivers;
  const View* camera = nullptr;  ///< Of what receives, only what it shows counts (tight_fit.h); null: all of it.
};

/// Texels from a place to the middle of the farthest one that a method's look-up takes part of, blurred before or not: so far
/// around a caster is a soft edge. At least 2: an author's own look-up reads some, too, and maps of narrow methods see the
/// same.
double look_up_reach(PackedShadowMethod method);

/// Reads a light's slots. Wrong values (near < 0, far <= near, left >= right, bottom >= top) are reported and become zero.
LightFrame light_frame(const PackedScene& scene, const PackedShadowMap& map, const Slots& slots, const World& world,
                       Messages& messages);

/// What the light sees in a map that authors see too: depths from 0 to 1, within the distances that are written, and all of a
/// spot light's angle.
View fit_light(const LightFrame& light, const FitInput& input);

/// Fits a directional light's map: `rectangle` is left, bottom, right, top. Reversed depths fall from 1 to 1/2, where a float
/// still resolves as much as at 1.
glm::dmat4 parallel(const glm::dvec4& rectangle, const Interval& depth, bool reversed);
/// A spot light's: `window` is left, bottom, right, top at distance 1. Reversed depths are near / distance: none is too far.
glm::dmat4 perspective(const glm::dvec4& window, const Interval& depth, bool reversed);

/// The range with a margin (a part of it) at both ends, and never empty: a flat scene gets a thickness that its distance can
/// resolve.
Interval widened(Interval range, double margin);
/// The view, or one of nothing where it is not finite as floats.
View checked(const View& view);

/// World space to linear depth: the dot product with (x, y, z, 1) runs from 0 at the near end of the map's depths to 1 at the
/// far end. Zero for a view without a range.
glm::dvec4 linear_depth_plane(const View& light);
/// A depth d as the map stores it to the same linear depth: (x d + y) / (z d + w).
glm::dvec4 linear_depth_line(const View& light);

/// World space to the map's texture space: x and y from 0 to 1, depth from 0 to 1 or as `reversed` says; of a point light, the
/// offset from it as a share of the largest distance.
glm::dmat4 world_to_texture(const View& light);

}  // namespace plugc

#pragma once
// What a light sees: the view and projection of its shadow map. Whatever the scene leaves at zero is fitted to the boxes
// of the shapes that cast and of those that receive; the camera plays no part, so a still scene keeps its maps.
// Every result is finite, whatever goes in.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/world.h"

namespace plugc {

/// A light as its map needs it, in world space. Zero: to be computed.
struct LightFrame {
  PackedLightKind kind = PackedLightKind::directional;  ///< directional or spot
  glm::dvec3 location{0};
  bool located = true;  ///< Directional: a location or a rectangle is written; else the location is computed too.
  glm::dvec3 direction{0, 0, -1};
  glm::dvec3 up{0};
  double near = 0;
  double far = 0;
  double angle = 0;            ///< Spot: full angle in radians.
  glm::dvec4 rectangle{0};     ///< Directional: left bottom right top.
  std::uint32_t map_size = 1;  ///< Texels along a side: how wide a margin of one texel is.
  bool reversed = false;       ///< For a map that stores reversed depth: see fit_light.
};

/// A box in a space of its own: seen from the light it is fitted tighter than the world's box around it.
struct PlacedBox {
  Box box;
  glm::dmat4 to_world{1.0};
};

struct FitInput {
  std::vector<PlacedBox> casters;
  std::vector<PlacedBox> receivers;
  bool may_move = false;  ///< A shape among them has a program that may leave its box.
};

/// Reads a light's slots. Wrong values (near < 0, far <= near, left >= right, bottom >= top) are reported and become zero.
LightFrame light_frame(const PackedScene& scene, const PackedShadowMap& map, const Slots& slots, const World& world,
                       Messages& messages);

/// What the light sees. With `reversed`, depths fall from 1: of a directional light to 1/2 at the last receiver, where a float
/// resolves as much as at the first; of a spot light as near / distance, for which no distance is too far. Every receiver
/// then has its place, so that written distances, which only save a map from coarse depths, are not needed.
View fit_light(const LightFrame& light, const FitInput& input);

/// World space to the map's texture space: x and y from 0 to 1, depth from 0 to 1 or as `reversed` says.
glm::dmat4 world_to_texture(const View& light);

}  // namespace plugc

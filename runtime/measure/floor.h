#pragma once
// The least error that a map of a given projection can have: it knows the scene at texel centres only.

#include "runtime/measure/map_footprint.h"

namespace plugc {

/// Mean of |m . d| for d spread evenly over the unit square around 0: how far, along m, a texel's centre lies from a point of
/// the texel. 0.25 along an axis, 0.2357 diagonally; 0.2435 on the average of all directions, for |m| = 1.
double mean_distance_from_texel_centre(const glm::dvec2& m);

/// The share of the counted pixels that a hard map without any bias error has wrong: along every edge of the true shadow, the
/// mean distance on screen between a pixel and the centre of its texel. About 0.2435 * L * h / N, with L the length of the
/// edges in pixels, h a texel's footprint there in pixels, N the pixels counted.
double hard_map_floor(const TruthPicture& truth, const CameraRays& rays, const MapProjection& map);

}  // namespace plugc

#pragma once
// The shadow map of a point light: six square views around it, in world space and in OpenGL's order (+x -x +y -y +z -z). Its
// depths are distances to the light, as shares of the largest.

#include "runtime/projection.h"

namespace plugc {

inline constexpr unsigned kCubeFaceCount = 6;

/// The map as a whole (`all_around`): where the light stands, and the largest distance, which is `far` where it is written,
/// else reaches the farthest receiver. What is nearer than `near` does not cast. Always finite.
View fit_point_light(const LightFrame& light, const FitInput& input);

/// What a face of that map sees. `tangent` of half its angle: 1 is the face itself, more a wider view around it.
View cube_face(const View& map, unsigned face, double tangent = 1.0);

/// Whether some receiver may look into the face of a map of `size` texels. Filters look beyond edges.
bool face_is_read(const View& map, unsigned face, int size, const FitInput& input);

/// PackedSource::depth_pass_range for offsets as glPolygonOffset takes them.
glm::dvec4 depth_pass_range(const View& map, double scale, double bias);

}  // namespace plugc

#pragma once
// The backdrop: what a Background shows around the eye, behind everything.

#include "runtime/draw_shape.h"

namespace plugc {

/// What the matrix turns, without what it moves, scales and shears: of the transform that a backdrop stands under nothing else
/// counts (X3D 4.1, 24.2.1).
glm::dmat4 rotation_of(const glm::dmat4& matrix);

/// The camera at the origin of the world. All rays of an orthographic camera would meet the backdrop in one point: it is seen
/// with the default field of view then, as in the reference engine.
View backdrop_view(const View& camera);

/// Draws the world's (-1), or that of a rendered texture that has its own, over the background colour of the picture that
/// `pass` draws, before anything else. Returns the draw calls.
std::uint32_t draw_backdrop(const gl::Functions& functions, LoadedScene& scene, Pass& pass, std::int32_t of,
                            Messages& messages);

}  // namespace plugc

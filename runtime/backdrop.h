#pragma once
// The backdrop: what a Background shows around the eye, behind everything.

#include "runtime/draw_shape.h"

namespace plugc {

/// The camera at the origin of the world. All rays of an orthographic camera would meet the backdrop in one point: it is seen
/// with the default field of view then, as in the reference engine.
View backdrop_view(const View& camera);

/// Draws the world's (-1), or that of a rendered texture that has its own, over the background colour of the picture that
/// `pass` draws, before anything else. Returns the draw calls.
std::uint32_t draw_backdrop(const gl::Functions& functions, LoadedScene& scene, Pass& pass, std::int32_t of,
                            Messages& messages);

}  // namespace plugc

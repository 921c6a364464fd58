#pragma once
// Volumes and cube maps out of pictures.

#include <span>

#include "image/decode_image.h"

namespace plugc {

/// The pictures as slices, the first in front (X3D 4.1, 33.4.1). They must be of one size.
DecodedImage volume_of_slices(std::span<const Image* const> slices);

/// Right, left, top, bottom, back, front, each as seen from inside with its upper edge up (of the top and bottom one, the
/// edge beside the front is below and above): the six faces of a cube map (X3D 4.1, 34.4.1). They must be square and equal.
DecodedImage cube_of_faces(std::span<const Image* const> faces);

}  // namespace plugc

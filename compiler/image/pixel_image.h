#pragma once
// Pictures that a scene spells out: the values of SFImage and of PixelTexture3D.

#include <optional>
#include <span>
#include <string>

#include "image/decode_image.h"

namespace plugc {

/// `width height components pixel...` (X3D 4.1, 5.3.6), rows from the bottom up. Without pixels there is no image and no
/// problem.
DecodedImage image_of_pixels(std::span<const double> numbers);

/// `components width height depth pixel...` (X3D 4.1, 33.4.3).
DecodedImage volume_of_pixels(std::span<const double> numbers);

}  // namespace plugc

#pragma once
// What a shadow costs and how true it is, before it is tried: rules of thumb out of the laboratory's tables (docs/shadows.md).

#include <cstdint>

#include "package/package_file.h"

namespace plugc {

/// The error that a method is expected to have, as a multiple of hard_map_floor() for a map of its size.
double expected_error_factor(PackedShadowMethod method);

/// Milliseconds of processor time that a frame of the software renderer takes longer, all threads together: `receiver_pixels`
/// look-ups, and a map of `size` texels a side cleared, filled and, for moments, blurred. The vertices of what casts are left
/// out, as each map costs them alike. `faces`: 6 for a cube map, else 1. Traced: one ray a pixel, whatever the size is.
double shadow_cost(PackedShadowMethod method, std::uint32_t size, double receiver_pixels, int faces);

}  // namespace plugc

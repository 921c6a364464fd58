#pragma once
// Pixels to a PNG file, fast rather than small.

#include <cstdint>
#include <span>
#include <string>

namespace plugc {

/// Writes `width` x `height` RGBA pixels of 8 bits, rows from the bottom up. Without `alpha` the file is RGB.
/// False when the file cannot be written or the span is too short.
bool write_png(const std::string& path, std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba,
               bool alpha);

}  // namespace plugc

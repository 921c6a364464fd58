#pragma once
// Pixels to a PNG file.

#include <cstdint>
#include <span>
#include <string>

namespace plugc {

/// What the file is for: to be there at once, or to be kept, at several times the work.
enum class PngEffort : std::uint8_t { quick, small };

/// Writes `width` x `height` RGBA pixels of 8 bits, rows from the bottom up. Without `alpha` the file is RGB.
/// False when the file cannot be written or the span is too short.
bool write_png(const std::string& path, std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba,
               bool alpha, PngEffort effort = PngEffort::quick);

}  // namespace plugc

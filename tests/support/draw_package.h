#pragma once
// Packages drawn by the runtime, and what their pixels are.

#include <gmock/gmock.h>

#include <array>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "package/package_file.h"
#include "runtime/render.h"

namespace plugc {

using Color = std::array<int, 3>;

/// Values of dynamic fields, by `DEF.field`.
using FieldValues = std::vector<std::pair<std::string, double>>;

/// The one renderer of this process; null, with a failure, where there can be none.
Renderer* process_renderer();

/// Draws the first scene of a package as it is at that time, with these fields changed, on the one renderer of this process.
/// Whatever the renderer has to say is a failure.
Picture draw_package(const Package& package, std::uint32_t width = 64, std::uint32_t height = 64,
                     const FieldValues& fields = {}, double time = 0);

/// What those fields hold at that time, as draw_package() draws it.
std::vector<std::vector<double>> fields_at(const Package& package, const std::vector<std::string>& names, double time);

/// The same in a frame with those options.
Picture draw_package(const Package& package, const FrameOptions& frame);

/// The same, drawn once before the fields change: what a frame keeps from the last one is in the picture.
Picture redraw_package(const Package& package, std::uint32_t width, std::uint32_t height, const FieldValues& fields);

/// The colour `x` pixels from the left and `y` from the top.
Color color_at(const Picture& picture, std::uint32_t x, std::uint32_t y);

/// Each channel within `tolerance` of the other colour's.
bool is_near(const Color& a, const Color& b, int tolerance);

MATCHER_P(IsColor, color, "is about " + testing::PrintToString(color)) {
  constexpr int kRounding = 2;  // one step for 8 bits, one for arithmetic in 32-bit floats
  return is_near(arg, color, kRounding);
}

/// A colour from factors of 1, as lighting equations give it: clamped, and rounded to 8 bits.
Color from_factors(double red, double green, double blue);

}  // namespace plugc

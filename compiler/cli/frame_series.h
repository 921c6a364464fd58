#pragma once
// Which moments of a scene `plugc preview` draws, and into which files.

#include <cstdint>
#include <string>

namespace plugc {

struct FrameSeries {
  double time = 0;          ///< Seconds since the scene was loaded, of the first picture.
  double step = 0.04;       ///< From one picture to the next.
  std::uint32_t count = 0;  ///< Pictures with a number in their name; 0: one without.

  std::uint32_t pictures() const { return count == 0 ? 1 : count; }
  double time_of(std::uint32_t picture) const { return time + step * picture; }
};

/// `out.png` becomes `out0007.png` for picture 7 of a series: four digits, or as many as the last one needs.
std::string picture_name(const std::string& path, const FrameSeries& series, std::uint32_t picture);

/// Whether the series can be drawn; else prints why not.
bool check_series(const FrameSeries& series);

}  // namespace plugc

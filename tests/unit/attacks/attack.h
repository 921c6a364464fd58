#pragma once
// How the attacks are measured: by what is left in memory and on the list of messages, and by how work grows with the size
// of the input; never by the clock alone, which says more about the machine.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "unit/scene/graph_fixture.h"

namespace plugc {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kMemoryIsMeasured = false;  // shadows and quarantines are not ours
#else
inline constexpr bool kMemoryIsMeasured = true;
#endif

inline std::string repeated(std::string_view piece, std::size_t count) {
  std::string text;
  text.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

/// `make(i)` for each i, one behind the other.
template <typename Make>
std::string each(std::size_t count, Make make) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += make(std::to_string(i));
  return text;
}

inline std::string classic_scene(const std::string& statements) {
  return "#X3D V3.3 utf8\n" + statements;
}
inline std::string xml_scene(const std::string& elements) {
  return "<X3D version='3.3'><Scene>\n" + elements + "\n</Scene></X3D>";
}
inline std::string json_scene(const std::string& nodes) {
  return R"({"X3D":{"@version":"3.3","Scene":{"-children":[)" + nodes + "]}}}";
}

/// The messages of that kind.
inline std::size_t count_of(const Diagnostics& diagnostics, DiagnosticId id) {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.all().begin(), diagnostics.all().end(), [&](const Diagnostic& one) { return one.id == id; }));
}

/// Bytes of this process by /proc/self/status: `VmHWM:` at most so far, `VmRSS:` now.
inline std::size_t process_bytes(std::string_view line) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kibibytes = 0;
    if (word == line && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

/// How much memory `work` took at its peak beyond what there was, in a child; 0 when the child died.
template <typename Work>
std::size_t peak_of(Work work) {
  int ends[2];
  if (pipe(ends) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    const std::size_t before = process_bytes("VmRSS:");
    work();
    const std::size_t peak = process_bytes("VmHWM:") - before;
    const bool told = write(ends[1], &peak, sizeof peak) == sizeof peak;
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  std::size_t peak = 0;
  if (read(ends[0], &peak, sizeof peak) != sizeof peak) peak = 0;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? peak : 0;
}

/// That the child of peak_of() came to its end, within that many bytes.
inline void expect_peak(std::size_t peak, std::size_t bound) {
  EXPECT_GT(peak, 0U) << "the child failed";
  if (kMemoryIsMeasured) {
    EXPECT_LT(peak, bound);
  }
}

/// How many times longer the processor works on eight times the input: 8 where work is linear, 64 where it is quadratic.
template <typename Make>
double growth(Make scene_of, std::size_t size) {
  const auto seconds = [&](std::size_t of_size) {
    const std::string text = scene_of(of_size);
    double best = 1e9;
    for (int i = 0; i < 3; ++i) {
      const std::clock_t start = std::clock();
      const auto built = build(text);
      for (const Diagnostic& one : built->diagnostics.all()) to_text(one, built->sources);
      best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
  };
  const double small = seconds(size);
  return seconds(8 * size) / std::max(small, 1e-4);
}
inline constexpr double kLinear = 30;  // well between 8 and 64: caches and allocators have their say

}  // namespace plugc

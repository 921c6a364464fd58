#pragma once
// The runtime's frame drawn for measurement: in 32-bit floats with the triangle of each pixel, or against the clock.

#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "runtime/gl/context.h"
#include "runtime/loaded_scene.h"
#include "runtime/render.h"

namespace plugc {

/// Rows from the bottom up.
struct Shot {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> colors;
  std::vector<glm::vec4> triangles;  ///< As make_measurable()'s programs write them.
};

/// Milliseconds by the clock, and of processor time in all threads: the second hardly depends on what else the machine does.
struct FrameTime {
  double wall = 0;
  double processor = 0;
};

/// One context. A scene on it must be gone before the studio is.
class Studio {
 public:
  /// Null, with `error`, where the machine has no OpenGL. `cache_folder` keeps the driver's code; empty: the driver's own.
  /// `single_picture` as in RendererOptions.
  static std::unique_ptr<Studio> make(const std::string& cache_folder, std::string& error, bool single_picture = false);
  ~Studio();

  LoadedScene load(const Package& package);
  /// `samples` is ignored: one.
  Shot shoot(LoadedScene& scene, const FrameOptions& options);
  /// The map gets that many texels a side.
  void resize_map(LoadedScene& scene, std::uint32_t map, std::uint32_t size);
  /// What a frame of 8 bits costs until it is finished, its maps drawn anew or kept.
  FrameTime time_frame(LoadedScene& scene, const FrameOptions& options, bool draw_maps);
  /// What the runtime said since the last call.
  std::vector<std::string> take_messages();

 private:
  Studio();
  struct State;
  std::unique_ptr<State> state_;
};

/// The scene's maps are out of date, and fitted as if there had been no frame before.
void forget_maps(LoadedScene& scene);

}  // namespace plugc

#pragma once
// One scene with one light, compiled once, whose dynamic fields a test changes: drawn by the runtime in floats, and traced by
// brute force.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/gl/functions.h"
#include "runtime/render.h"
#include "runtime/world.h"
#include "support/brute_force.h"
#include "support/compile_text.h"

namespace plugc {

/// RGBA, rows from the bottom up.
struct FloatPicture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> values;
};

/// What is true of each pixel.
struct TruthPixel {
  bool counts = false;  ///< It shows a face that the light can reach.
  bool lit = false;
  double cosine = 0;  ///< Between the face's normal and the way to the light.
};
using Truth = std::vector<TruthPixel>;

/// Shares of the pixels that count, in percent.
struct Verdict {
  double false_shadow = 0;
  double false_lit = 0;
  double weighted = 0;  ///< Their sum with each pixel weighted by its cosine: what a viewer sees of it.
  std::size_t pixels = 0;
  double error() const { return false_shadow + false_lit; }
};

class Stage {
 public:
  /// `dynamic` names the fields that the test will set. `odd` scenes may be spoken of by the compiler and the renderer; else a
  /// word of theirs fails the test, as OpenGL's errors always do.
  explicit Stage(std::string_view scene, const std::vector<std::string>& dynamic = {}, std::uint32_t side = 128,
                 bool odd = false);
  explicit Stage(Compiled compiled);
  ~Stage();

  void set(std::string_view field, const std::vector<double>& values);
  /// The view of the next pictures; empty: the first.
  void look_through(std::string viewpoint) { frame_.viewpoint = std::move(viewpoint); }

  FloatPicture draw(bool shadows = true);
  /// What compiler and renderer said until the last picture was there.
  const std::vector<std::string>& said() const { return said_; }
  const FrameStatistics& statistics() const { return statistics_; }
  const PackedScene& scene() const;
  World world() const;
  const Slots& slots() const;
  View camera() const;

  /// By pixel: the picture with shadows over that without, 0 to 1; negative where the light does not reach.
  std::vector<double> visibility();
  Truth trace() const;
  Verdict judge() { return judge(trace()); }
  Verdict judge(const Truth& truth);

 private:
  void load();

  Compiled compiled_;
  bool odd_ = false;
  FrameOptions frame_;
  FrameStatistics statistics_;
  std::vector<std::string> said_;
  struct Drawn;
  std::unique_ptr<Drawn> drawn_;
};

/// As long as it lives, OpenGL says that textures have at most that many texels a side: both limits, of textures and of cube
/// maps' faces.
class SmallTextures {
 public:
  SmallTextures(int side, int cube_side);
  ~SmallTextures();
  SmallTextures(const SmallTextures&) = delete;
  SmallTextures& operator=(const SmallTextures&) = delete;
};

/// As long as it lives, OpenGL says of every target that is made that it cannot be drawn into.
class IncompleteTargets {
 public:
  IncompleteTargets();
  ~IncompleteTargets();
  IncompleteTargets(const IncompleteTargets&) = delete;
  IncompleteTargets& operator=(const IncompleteTargets&) = delete;

 private:
  decltype(gl::Functions::CheckFramebufferStatus) real_;
};

/// The share of pixels that count in both whose truth differs, in percent.
double difference(const Truth& a, const Truth& b);

}  // namespace plugc

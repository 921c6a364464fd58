#pragma once
// The embedding engineer's page: make a Renderer, draw frames.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/load_package.h"

namespace plugc {

/// RGBA, 8 bits a channel, rows from the bottom up.
struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> pixels;
};

struct FrameOptions {
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  std::string viewpoint;      ///< DEF name, or an index from 0; empty: the bound one, or a view of the whole scene.
  std::uint32_t samples = 1;  ///< Samples a pixel, cut to 1 to 4: edges are smoothed with more than one.
  bool shadows = true;        ///< False: no depth pass, everything lit (for comparisons).
  double time = 0;            ///< Seconds since the scene was loaded. Going back starts anew from there; what is not
                              ///< finite is 0.
};

/// What a frame cost; counted, not timed.
struct FrameStatistics {
  std::uint32_t draw_calls = 0;
  std::uint32_t shadow_passes = 0;
  std::uint32_t shadow_draw_calls = 0;
  std::uint32_t shadow_filter_passes = 0;  ///< Over all texels of a map.
  std::uint32_t programs_used = 0;
  std::uint32_t rendered_views = 0;  ///< Of rendered textures; a cube has six.
  std::uint32_t screen_passes = 0;   ///< Of screen effects.
};

/// How the context is tuned. Must be decided before the first Renderer of a process.
struct RendererOptions {
  bool single_picture = false;  ///< Quick code generation, slower drawing: best below about 60 frames.
  std::string cache_folder;     ///< Mesa's shader cache (a subfolder a mode); empty: Mesa's default.
};

/// One scene of one package on one context of its own. Not thread-safe; use one per thread.
/// The package must outlive the Renderer.
class Renderer {
 public:
  /// On failure (no OSMesa, no GL 3.3) returns null and sets `error`.
  static std::unique_ptr<Renderer> make(const RendererOptions& options, std::string& error);
  ~Renderer();

  /// Uploads what scene `scene` needs. Programs that the driver rejects are reported in messages() at the author's lines
  /// and their shapes are not drawn. False, with `error`, where the package has no such scene; then the old one stays.
  bool load(const Package& package, std::uint32_t scene, std::string& error);

  /// Sets the value of a slot (see PackedSlot); `values` holds all its numbers. Another number of them, or a slot that is none,
  /// changes nothing and becomes a message.
  void set_slot(std::uint32_t slot, const std::vector<double>& values);

  /// Sets a field that the package declares dynamic (`plugc build --dynamic DEF.field`), in every node of that name; booleans
  /// are 0 and 1. No program is compiled for it. False, with `error`, for any other field or another number of values: then
  /// nothing has changed.
  bool set_field(std::string_view name, const std::vector<double>& values, std::string& error);

  /// What the field holds that the package calls so (`DEF.field`), as of the last picture; empty where there is none.
  std::vector<double> field(std::string_view name) const;

  /// Sides are cut to what the driver draws. Empty before a scene is loaded, and where the driver has no target of that size;
  /// messages() says so. Throws std::bad_alloc.
  Picture draw(const FrameOptions& options);
  const FrameStatistics& statistics() const;
  const std::vector<std::string>& messages() const;  ///< Driver messages and odd inputs so far.

 private:
  Renderer();
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plugc

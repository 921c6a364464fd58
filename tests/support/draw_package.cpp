// One OpenGL context serves all pictures of a test program. Its code cache lies in the build folder, so that only the first
// run pays for generating code.

#include "support/draw_package.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace plugc {

Renderer* process_renderer() {
  static const std::unique_ptr<Renderer> renderer = [] {
    RendererOptions options;
    options.single_picture = true;
    options.cache_folder = PLUGC_BINARY_DIR "/test_cache/mesa";
    std::string error;
    auto made = Renderer::make(options, error);
    EXPECT_NE(made, nullptr) << error;
    return made;
  }();
  return renderer.get();
}

namespace {

/// The process's renderer with the first scene of the package; null where nothing can be drawn, which is a failure.
Renderer* load(const Package& package) {
  Renderer* renderer = process_renderer();
  std::string error;
  if (renderer != nullptr && renderer->load(package, 0, error)) return renderer;
  ADD_FAILURE() << "nothing can be drawn: " << error;
  return nullptr;
}

Picture draw_with(Renderer& renderer, const FrameOptions& frame, const FieldValues& fields) {
  std::string error;
  for (const auto& [name, value] : fields) EXPECT_TRUE(renderer.set_field(name, {value}, error)) << error;
  Picture picture = renderer.draw(frame);
  EXPECT_THAT(renderer.messages(), testing::IsEmpty());
  return picture;
}

FrameOptions frame_of(std::uint32_t width, std::uint32_t height, double time = 0) {
  FrameOptions frame;
  frame.width = width;
  frame.height = height;
  frame.time = time;
  return frame;
}

}  // namespace

Picture draw_package(const Package& package, const FrameOptions& frame) {
  Renderer* renderer = load(package);
  return renderer != nullptr ? draw_with(*renderer, frame, {}) : Picture();
}

Picture draw_package(const Package& package, std::uint32_t width, std::uint32_t height, const FieldValues& fields,
                     double time) {
  Renderer* renderer = load(package);
  return renderer != nullptr ? draw_with(*renderer, frame_of(width, height, time), fields) : Picture();
}

Picture redraw_package(const Package& package, std::uint32_t width, std::uint32_t height, const FieldValues& fields) {
  Renderer* renderer = load(package);
  if (renderer == nullptr) return {};
  draw_with(*renderer, frame_of(width, height), {});
  return draw_with(*renderer, frame_of(width, height), fields);
}

std::vector<std::vector<double>> fields_at(const Package& package, const std::vector<std::string>& names, double time) {
  constexpr std::uint32_t kSide = 4;
  std::vector<std::vector<double>> values;
  if (draw_package(package, kSide, kSide, {}, time).pixels.empty()) return values;
  for (const std::string& name : names) values.push_back(process_renderer()->field(name));
  return values;
}

Color color_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  if (x >= picture.width || y >= picture.height) {
    ADD_FAILURE() << "no pixel " << x << ", " << y;
    return {};
  }
  const std::size_t at = (std::size_t{picture.height - 1 - y} * picture.width + x) * 4;
  return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

bool is_near(const Color& a, const Color& b, int tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > tolerance) return false;
  }
  return true;
}

Color from_factors(double red, double green, double blue) {
  const auto channel = [](double factor) { return static_cast<int>(std::lround(std::clamp(factor, 0.0, 1.0) * 255)); };
  return {channel(red), channel(green), channel(blue)};
}

}  // namespace plugc

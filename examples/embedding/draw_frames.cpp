// A program that holds plugc's renderer: it opens the package of the example first_light, changes fields while it draws, and
// writes four pictures. docs/embedding.md goes through it.
//
//     plugc build examples/first_light/first_light.x3dv -o light.plugpack --dynamic Rim.enabled --dynamic Rings.ring_count
//     draw_frames light.plugpack frame       # frame0.ppm ... frame3.ppm

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/render.h"

namespace {

struct Change {
  std::string field;
  std::vector<double> values;  ///< Booleans are 0 and 1, a colour is three numbers.
};

/// What the host does to the scene before each picture: nothing, fewer rings, no rim, and all as it was.
const std::vector<std::vector<Change>> kFrames = {
    {},
    {{"Rings.ring_count", {3}}},
    {{"Rim.enabled", {0}}},
    {{"Rings.ring_count", {7}}, {"Rim.enabled", {1}}},
};

int fail(const std::string& error) {
  std::fprintf(stderr, "draw_frames: %s\n", error.c_str());
  return 1;
}

/// As binary PPM: RGB, rows from the top down. A Picture is RGBA, rows from the bottom up.
bool write_ppm(const std::string& path, const plugc::Picture& picture) {
  std::ofstream stream(path, std::ios::binary);
  stream << "P6\n" << picture.width << ' ' << picture.height << "\n255\n";
  for (std::size_t row = picture.height; row-- > 0;) {
    for (std::size_t pixel = row * picture.width; pixel < (row + 1) * picture.width; ++pixel) {
      stream.write(reinterpret_cast<const char*>(&picture.pixels[pixel * 4]), 3);
    }
  }
  return stream.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail("usage: draw_frames PACKAGE OUTPUT");
  std::string error;
  const plugc::LoadedPackage loaded = plugc::load_package_file(argv[1], error);
  if (loaded.package == nullptr) return fail(error);
  const auto renderer = plugc::Renderer::make({}, error);  // behind the package, so that it dies first
  if (renderer == nullptr || !renderer->load(*loaded.package, 0, error)) return fail(error);

  plugc::FrameOptions frame;
  frame.width = 400;
  frame.height = 225;
  for (std::size_t i = 0; i < kFrames.size(); ++i) {
    for (const Change& change : kFrames[i]) {
      if (!renderer->set_field(change.field, change.values, error)) return fail(error);
    }
    const std::string path = argv[2] + std::to_string(i) + ".ppm";
    if (!write_ppm(path, renderer->draw(frame))) return fail("cannot write `" + path + "`");
  }
  for (const std::string& message : renderer->messages()) std::fprintf(stderr, "%s\n", message.c_str());
  return 0;
}

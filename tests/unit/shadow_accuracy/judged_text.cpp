#include "judged_text.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "shadows/compile_scene.h"
#include "support/compile_text.h"

namespace plugc {
namespace {

std::string box(const glm::dvec3& at, const glm::dvec3& size, double angle) {
  return fmt::format(
      "Transform {{ translation {} {} {} rotation 0 1 0 {} children Shape {{ appearance Appearance {{ material Material {{ }} "
      "}}"
      " geometry Box {{ size {} {} {} }} }} }}\n",
      at.x, at.y, at.z, angle, size.x, size.y, size.z);
}

std::string head(const std::string& light) {
  return "#X3D V4.0 utf8\nNavigationInfo { headlight FALSE }\nViewpoint { position 0 6.5 8 orientation 1 0 0 -0.66 }\n" +
         light + "\n" + box({0, -0.5, 0}, {30, 1, 30}, 0);
}

/// No wall faces the sun or the spotlight at a grazing angle: in their maps it would be narrower than a kernel.
std::string boxes() {
  return box({-2.2, 0.8, 0.5}, {1.2, 1.6, 1.2}, 0.3) + box({0.4, 0.5, -1.2}, {1.6, 1.0, 0.8}, 0.45) +
         box({2.6, 1.2, 0.2}, {0.9, 2.4, 0.9}, 0.1) + box({0.9, 0.4, 2.4}, {0.8, 0.8, 0.8}, 0.2) +
         box({-1.3, 0.35, 3.1}, {1.0, 0.7, 0.5}, 0.55);
}

/// Above a place given in steps of the grid.
double hill_height(double x, double z) {
  return 0.55 * std::sin(0.5 * x) * std::sin(0.4 * z + 1) + 0.12 * std::sin(1.3 * x + 0.9 * z);
}

}  // namespace

Studio& process_studio() {
  process_validator();  // forks, so it comes before the renderer's threads
  static const std::unique_ptr<Studio> studio = [] {
    std::string error;
    auto made = Studio::make(PLUGC_BINARY_DIR "/test_cache/mesa", error);
    if (made == nullptr) throw std::runtime_error("nothing can be drawn: " + error);
    return made;
  }();
  return *studio;
}

std::vector<std::uint8_t> package_of(const std::string& scene, const std::string& method) {
  const SceneFolder folder;
  std::string error;
  std::vector<std::uint8_t> bytes = compile_scene(folder.write("scene.x3dv", scene), method, process_validator(), error);
  if (bytes.empty()) throw std::runtime_error(error);
  return bytes;
}

JudgedText judge_text(const std::string& scene) {
  JudgedText text;
  text.scene = load_measured_scene(process_studio(), package_of(scene), {});
  FrameOptions frame;
  frame.width = 640;
  frame.height = 360;
  text.judged = judge_scene(process_studio(), *text.scene, {frame});
  EXPECT_EQ(text.judged.views.size(), 1U);
  EXPECT_EQ(process_studio().take_messages(), std::vector<std::string>{});
  return text;
}

MeanErrors errors_of(const JudgedText& judged, const std::vector<std::uint8_t>& package, const Settings& settings,
                     int shift_count) {
  const auto scene = load_measured_scene(process_studio(), package, settings);
  return measure_errors(process_studio(), *scene, judged.judged, judged.view(), shift_count);
}

std::string boxes_in_the_sun() {
  return head("DirectionalLight { direction -0.9 -0.8 -0.5 shadows TRUE }") + boxes();
}

std::string stairs_and_slabs() {
  std::string scene = head("DirectionalLight { direction 0.35 -1 -0.55 shadows TRUE }");
  for (int step = 0; step < 6; ++step) scene += box({-3 + 0.8 * step, 0.2 * step + 0.1, 1.5}, {0.8, 0.4 * step + 0.2, 2.2}, 0);
  for (int slab = 0; slab < 3; ++slab) scene += box({0.4 * slab, 1.2 + slab, -2.0}, {6 - slab, 0.15, 2.4}, 0.05 * slab);
  return scene;
}

std::string boxes_under_a_spotlight() {
  return head("SpotLight { location 3 8 4 direction -0.36 -1 -0.44 cutOffAngle 0.7 beamWidth 0.6 shadows TRUE }") + boxes();
}

std::string ledges_on_a_wall() {
  std::string scene = head("DirectionalLight { direction 0.5 -1 -0.62 shadows TRUE }") + box({0, 2, -2}, {9, 4, 0.4}, 0);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 8; ++column)
      scene += box({-3.85 + 1.1 * column, 0.6 + 0.9 * row, -1.77}, {0.75, 0.07, 0.12}, 0);
  }
  return scene;
}

std::string low_slabs_below_a_tower() {
  std::string scene =
      head("DirectionalLight { direction -0.6 -1 -0.35 shadows TRUE }") + box({3.2, 7, -1}, {1.2, 14, 1.2}, 0.2);
  for (int slab = 0; slab < 4; ++slab)
    scene += box({-2.4 + 1.5 * slab, 0.3 + 0.15 * slab, 1.2 - 0.5 * slab}, {2.2, 0.06, 1.6}, 0.1 * slab);
  for (int bar = 0; bar < 3; ++bar) scene += box({-1 + 1.3 * bar, 2.5 + bar, 0.8}, {0.25, 0.25, 5}, 0.3);
  return scene;
}

std::string cones_on_hills() {
  constexpr int kSide = 60;
  constexpr int kCones = 400;
  std::string heights;
  for (int z = 0; z < kSide; ++z) {
    for (int x = 0; x < kSide; ++x) heights += fmt::format("{:.4f} ", hill_height(x, z));
  }
  std::string cones;
  for (int i = 0; i < kCones; ++i) {
    const double x = (kSide - 1) * std::fmod(i * std::numbers::phi, 1.0);
    const double z = (kSide - 1) * double(i) / kCones;
    cones += fmt::format(
        "Transform {{ translation {:.4f} {:.4f} {:.4f} children Shape {{ appearance Appearance {{ material Material {{ }} }} "
        "geometry Cone {{ bottomRadius 0.08 height 0.3 }} }} }}\n",
        0.2 * x, hill_height(x, z) + 0.15, 0.2 * z);
  }
  return fmt::format(
      "#X3D V4.0 utf8\nNavigationInfo {{ headlight FALSE }}\nViewpoint {{ position 0 6.5 8 orientation 1 0 0 -0.66 }}\n"
      "DirectionalLight {{ direction -0.95 -0.45 -0.3 shadows TRUE }}\n"
      "Transform {{ translation -6 0 -6 children [ Shape {{ appearance Appearance {{ material Material {{ }} }} geometry "
      "ElevationGrid {{ xDimension {0} zDimension {0} xSpacing 0.2 zSpacing 0.2 height [ {1}] }} }}\n{2}] }}\n",
      kSide, heights, cones);
}

}  // namespace plugc

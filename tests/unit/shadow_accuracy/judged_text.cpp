#include "judged_text.h"

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

}  // namespace plugc

// What shadow maps must achieve, as means over 16 positions of the map within a texel.

#include <array>

#include "judged_text.h"

namespace plugc {
namespace {

constexpr int kShifts = 16;

struct NamedScene {
  const char* name;
  std::string (*text)();
};
constexpr std::array kPlanesAndBoxes = {NamedScene{"boxes in the sun", boxes_in_the_sun},
                                        NamedScene{"stairs and slabs", stairs_and_slabs},
                                        NamedScene{"boxes under a spotlight", boxes_under_a_spotlight}};

TEST(ShadowAccuracy, AutomaticBiasStaysNearTheFloorOfItsMap) {
  constexpr double kMost = 1.25;
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    const std::vector<std::uint8_t> package = package_of(scene.text());
    for (const std::uint32_t size : {512U, 1024U, 2048U, 4096U}) {
      Settings settings;
      settings.size = size;
      const MeanErrors mean = errors_of(text, package, settings, kShifts);
      EXPECT_LE(mean.errors.wrong(), kMost * mean.floor)
          << scene.name << ", " << size << ": false shadow " << mean.errors.false_shadow << ", false light "
          << mean.errors.false_lit << ", far from an edge " << mean.errors.far_from_edge;
    }
  }
}

}  // namespace
}  // namespace plugc

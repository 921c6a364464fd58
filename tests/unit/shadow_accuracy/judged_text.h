#pragma once
// Scenes written down in a test, judged by the laboratory.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/measure/measured_scene.h"

namespace plugc {

/// The studio of this process.
Studio& process_studio();

/// The package of a scene with that `--shadows` method; empty: the default. Mistakes in it fail the test.
std::vector<std::uint8_t> package_of(const std::string& scene, const std::string& method = "");

/// One scene with one map, seen from its first viewpoint in a picture of 640 by 360.
struct JudgedText {
  std::unique_ptr<MeasuredScene> scene;
  JudgedScene judged;

  const JudgedView& view() const { return judged.views.at(0); }
};
JudgedText judge_text(const std::string& scene);

/// Mean errors of a method at a size, over `shift_count` sub-texel positions.
MeanErrors errors_of(const JudgedText& judged, const std::vector<std::uint8_t>& package, const Settings& settings,
                     int shift_count);

/// Boxes on the ground under a slanting sun; a flight of stairs below slabs; the boxes again under a spotlight.
std::string boxes_in_the_sun();
std::string stairs_and_slabs();
std::string boxes_under_a_spotlight();
/// A wall with ledges that stand out by a few texels of 1024.
std::string ledges_on_a_wall();
/// A tall tower and bars above slabs that lie close to the ground: edges over casters at the far end of a long range of depths.
std::string low_slabs_below_a_tower();
/// Surfaces that bend everywhere, in low light.
std::string cones_on_hills();

}  // namespace plugc

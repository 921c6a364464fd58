// Inputs that leave nothing to compute with: the picture is defined, every number in it is finite, OpenGL has no complaint.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxes_scene.h"
#include "stage.h"

namespace plugc {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t kSide = 32;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_defined(Stage& stage, const std::string& what) {
  const FloatPicture picture = stage.draw();
  for (const float value : picture.values) {
    if (!(value >= 0 && value <= 1)) {
      ADD_FAILURE() << what << ": a pixel is " << value;
      return;
    }
  }
  EXPECT_EQ(stage.draw().values, picture.values) << what << ": the next frame is another";
}

/// The light with that map; `method` empty: the default one.
std::string with_map(std::string light, const std::string& size, const std::string& method) {
  const std::string fields = "size " + size + (method.empty() ? " " : " method \"" + method + "\" ");
  return light.replace(light.find("size "), light.find('}') - light.find("size "), fields);
}

std::string shape(const std::string& geometry) {
  return "Shape { appearance USE Grey geometry " + geometry + " }\n";
}

class Degenerate : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ShadowStability, Degenerate, testing::Values(kSun, kSpot),
                         [](const auto& one) { return one.index == 0 ? "Sun" : "Spot"; });

TEST_P(Degenerate, Scenes) {
  const std::string head = "#X3D V4.0 utf8\nPROFILE Full\nNavigationInfo { headlight FALSE }\n" + std::string(GetParam()) +
                           "\nViewpoint { position 5 5 9 orientation -0.73 0.65 0.2 0.68 }\n"
                           "DEF Holder Shape { appearance DEF Grey Appearance { material Material { ambientIntensity 0 } } ";
  const std::string ground =
      "geometry IndexedFaceSet { coordIndex [0 1 2 3 -1] coord Coordinate { point [-30 0 30, 30 0 30, 30 0 -30, -30 0 -30] } } "
      "}\n";
  const auto plane = [](const std::string& points) {
    return "geometry IndexedFaceSet { solid FALSE coordIndex [0 1 2 3 -1] coord Coordinate { point [" + points + "] } } }\n";
  };
  const std::pair<const char*, std::string> scenes[] = {
      {"no casters", ground},
      {"no receivers", "geometry IndexedFaceSet { } }\n"},
      {"one triangle",
       "geometry IndexedFaceSet { solid FALSE coordIndex [0 1 2 -1] coord Coordinate { point [0 0 0, 2 0 1, 0 2 0] } } }\n"},
      {"flat on x", plane("0 -2 -2, 0 2 -2, 0 2 2, 0 -2 2")},
      {"flat on y", plane("-2 0 -2, -2 0 2, 2 0 2, 2 0 -2")},
      {"flat on z", plane("-2 -2 0, 2 -2 0, 2 2 0, -2 2 0")},
      {"all in one point", plane("1 1 1, 1 1 1, 1 1 1, 1 1 1")},
      {"a line", plane("0 0 0, 1 1 1, 2 2 2, 3 3 3")},
      {"coordinates of 1e30", plane("-1e30 0 -1e30, -1e30 0 1e30, 1e30 0 1e30, 1e30 0 -1e30") + shape("Box { }")},
      {"coordinates of 1e-30", plane("-1e-30 0 -1e-30, -1e-30 0 1e-30, 1e-30 0 1e-30, 1e-30 0 -1e-30") + shape("Box { }")},
      {"a light inside a mesh",
       ground + "Transform { translation 4 9 6 children Shape { appearance USE Grey geometry Sphere { radius 2 } } }\n"},
      {"zero scale", ground + "Transform { scale 0 0 0 children " + shape("Box { }") + "}\n"},
      {"flattened", ground + "Transform { translation 0 2 0 scale 1 0 1 children " + shape("Box { }") + "}\n"},
      {"mirrored", ground + "Transform { translation 0 2 0 scale -1 1 1 children " + shape("Box { }") + "}\n"},
      {"scaled by 1e30", ground + "Transform { scale 1e30 1e30 1e30 children " + shape("Box { }") + "}\n"},
  };
  for (const auto& [what, text] : scenes) {
    Stage stage(head + text, {}, kSide, true);
    expect_defined(stage, what);
  }
}

std::vector<double> values_of(const Stage& stage, std::string_view field) {
  for (const PackedSlotName* slot : *stage.scene().slot_names()) {
    if (slot->name()->string_view() != field) continue;
    const auto values = stage.slots().values(slot->slot());
    return {values.begin(), values.end()};
  }
  return {};
}

/// Each component of each field in turn, and all of a field together, become numbers that nobody can mean.
void expect_defined_with_odd_numbers(Stage& stage, const std::vector<std::string>& fields) {
  const double odd[] = {0, -1, 1e-7, 1e-38, 1e30, -1e30, 1e300, kInfinity, -kInfinity, kNan};
  for (const std::string& field : fields) {
    const std::vector<double> before = values_of(stage, field);
    for (const double value : odd) {
      for (std::size_t i = 0; i <= before.size(); ++i) {
        std::vector<double> changed = before;
        if (i < before.size()) changed[i] = value;
        if (i == before.size()) changed.assign(before.size(), value);
        stage.set(field, changed);
        expect_defined(stage, field + " component " + std::to_string(i) + " is " + std::to_string(value));
      }
    }
    stage.set(field, before);
  }
}

TEST_P(Degenerate, Numbers) {
  const bool sun = GetParam() == kSun;
  std::vector<std::string> fields = {"Lamp.direction",    "Lamp.projectionNear", "Lamp.projectionFar", "Lamp.up",
                                     "Whole.scale",       "Whole.rotation",      "Whole.translation",  "Tower.scale",
                                     "Tower.translation", "Ground.scale",        "Map.scale",          "Map.bias",
                                     "Near.position"};
  for (const char* const field : {"Lamp.projectionRectangle", "Lamp.projectionLocation"}) {
    if (sun) fields.emplace_back(field);
  }
  for (const char* const field : {"Lamp.location", "Lamp.cutOffAngle", "Lamp.projectionAngle", "Lamp.radius"}) {
    if (!sun) fields.emplace_back(field);
  }
  Stage stage(boxes_scene(GetParam()), fields, kSide, true);
  expect_defined_with_odd_numbers(stage, fields);
}

TEST(ShadowStability, NumbersOfAPointLight) {
  const std::vector<std::string> fields = {"Lamp.location", "Lamp.projectionNear",  "Lamp.projectionFar",
                                           "Lamp.radius",   "Lamp.shadowIntensity", "Map.scale",
                                           "Map.bias"};
  Stage stage(boxes_scene(kBulb), fields, kSide, true);
  expect_defined_with_odd_numbers(stage, fields);
}

TEST_P(Degenerate, UpParallelToTheDirection) {
  Stage stage(boxes_scene(GetParam()), {"Lamp.direction", "Lamp.up"});
  for (const glm::dvec3& direction : {glm::dvec3(0, -1, 0), glm::dvec3(-0.55, -1, -0.4)}) {
    stage.set("Lamp.direction", {direction.x, direction.y, direction.z});
    for (const double aside : {0.0, 1e-7, -1e-7, 1e-3}) {
      for (const double sign : {1.0, -1.0}) {
        stage.set("Lamp.up", {sign * direction.x + aside, sign * direction.y, sign * direction.z + aside});
        EXPECT_LE(stage.judge().error(), 0.5) << aside;
      }
    }
  }
}

TEST_P(Degenerate, FarBeforeNearIsComputedInstead) {
  Stage plain(boxes_scene(GetParam()), {}, kSide, true);
  Stage odd(boxes_scene(GetParam()), {"Lamp.projectionNear", "Lamp.projectionFar"}, kSide, true);
  odd.set("Lamp.projectionNear", {9});
  for (const double far : {1.0, 9.0}) {
    odd.set("Lamp.projectionFar", {far});
    EXPECT_EQ(odd.draw().values, plain.draw().values);
  }
}

TEST_P(Degenerate, MapSizes) {
  for (const char* const size : {"1", "17", "31", "32", "33", "100"}) {
    Stage stage(boxes_scene(with_map(GetParam(), size, "")), {}, kSide, true);
    expect_defined(stage, size);
    EXPECT_THAT(stage.said(), IsEmpty()) << size;
  }
}

class MapSize : public testing::TestWithParam<std::pair<const char*, const char*>> {};  // light, method
INSTANTIATE_TEST_SUITE_P(ShadowStability, MapSize,
                         testing::Values(std::pair(kSun, "BILINEAR"), std::pair(kSun, "HARD"), std::pair(kSun, "PCF3"),
                                         std::pair(kSun, "VSM"), std::pair(kSpot, "EVSM"), std::pair(kSpot, "MSM"),
                                         std::pair(kBulb, "BILINEAR"), std::pair(kBulb, "PCF3")),
                         [](const auto& one) { return std::to_string(one.index) + "_" + one.param.second; });

TEST_P(MapSize, OneAndSeventeenAreDrawnWithoutAWord) {
  const auto& [light, method] = GetParam();
  for (const char* const size : {"1", "17"}) {
    Stage stage(boxes_scene(with_map(light, size, method)), {}, kSide, true);
    expect_defined(stage, size);
    EXPECT_THAT(stage.said(), IsEmpty()) << size;
  }
}

TEST_P(MapSize, ZeroIsToldAndOneTexelDrawn) {
  const auto& [light, method] = GetParam();
  Stage stage(boxes_scene(with_map(light, "0", method)), {}, kSide, true);
  EXPECT_EQ(stage.scene().shadow_maps()->Get(0)->size(), 1U);
  expect_defined(stage, "size 0");
  EXPECT_THAT(stage.said(), ElementsAre(HasSubstr("field-range `size` of `GeneratedShadowMap` is 0, but should be >0")));
}

TEST_P(MapSize, AboveWhatOpenGlCanIsCutAndTold) {
  const auto& [light, method] = GetParam();
  const SmallTextures limit(64, 48);
  const bool cube = light == kBulb;
  Stage cut(boxes_scene(with_map(light, "100", method)), {}, kSide, true);
  Stage meant(boxes_scene(with_map(light, cube ? "48" : "64", method)), {}, kSide, true);
  expect_defined(cut, "size 100");
  EXPECT_THAT(cut.said(), ElementsAre(HasSubstr(std::string("cannot have the size 100: it gets ") + (cube ? "48" : "64"))));
  EXPECT_EQ(cut.draw().values, meant.draw().values);
  EXPECT_THAT(meant.said(), IsEmpty());
}

/// Nothing is left of the shadows that the frame before had.
TEST(ShadowStability, WhatCannotBeTracedIsLitAndTold) {
  Stage stage(boxes_scene(with_map(kSun, "16", "TRACED") + with_map(kSpot, "16", "TRACED")), {}, kSide, true);
  const FloatPicture lit = stage.draw(false);
  EXPECT_NE(stage.draw().values, lit.values);
  const IncompleteTargets none;
  EXPECT_EQ(stage.draw().values, lit.values);
  EXPECT_THAT(stage.said(), Contains("shadows cannot be traced at 32 by 32, so all is lit"));
}

TEST_P(MapSize, AboveEveryLimitIsCutByTheCompilerAndTold) {
  const auto& [light, method] = GetParam();
  const Compiled compiled = compile_text(boxes_scene(with_map(light, "100000", method)));
  const std::uint32_t size = compiled.package->scenes()->Get(0)->shadow_maps()->Get(0)->size();
  const bool moments = std::string_view(method).ends_with("SM");
  EXPECT_EQ(size, moments ? 4096U : 8192U);
  EXPECT_THAT(compiled.messages(), Contains(HasSubstr("field-range a shadow map of size 100000 cannot be; 8192 is used")));
}

TEST_P(Degenerate, EffectsThatMakeNoNumbers) {
  // written as fields would be: the compiler must not know that it is zero
  const std::string effect =
      "DEF Odd Effect { language \"GLSL\" inputOutput SFFloat zero 0 parts EffectPart { type \"VERTEX\" url "
      "\"data:text/plain,\n"
      "uniform float zero;\n"
      "void PLUG_vertex_object_space_change(inout vec4 vertex_object, inout vec3 normal_object)\n"
      "{ if (vertex_object.x > 0.5) vertex_object.y += zero / zero; }\" } }";
  const std::string sphere =
      "Transform { translation 0 2 0 children Shape { geometry Sphere {} appearance Appearance { material Material { "
      "ambientIntensity 0 } effects " +
      effect + " } } }\n";
  Stage stage(boxes_scene(GetParam(), sphere), {"Odd.zero"}, kSide, true);
  expect_defined(stage, "zero over zero");
  stage.set("Odd.zero", {1e-30});
  expect_defined(stage, "a number again");
}

}  // namespace
}  // namespace plugc

#include <gtest/gtest.h>

#include "glsl/stage.h"

namespace plugc {
namespace {

TEST(Stage, NamesStagesAndTargets) {
  EXPECT_EQ(to_text(ShaderStage::vertex), "vertex");
  EXPECT_EQ(to_text(ShaderStage::geometry), "geometry");
  EXPECT_EQ(to_text(ShaderStage::fragment), "fragment");
  for (const Target target : {Target::glsl330, Target::essl300, Target::spirv}) {
    EXPECT_EQ(target_named(to_text(target)), target);
  }
  EXPECT_EQ(target_named("GLSL330"), std::nullopt);
  EXPECT_EQ(target_named(""), std::nullopt);
}

}  // namespace
}  // namespace plugc

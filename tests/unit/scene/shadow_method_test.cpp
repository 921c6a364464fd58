#include "scene/shadow_method.h"

#include <gmock/gmock.h>

#include "scene/shadow_defaults.h"

namespace plugc {
namespace {

TEST(ShadowMethods, AreReadByTheirNames) {
  for (std::size_t i = 0; i < shadow_method_names().size(); ++i) {
    const auto method = static_cast<ShadowMethod>(i);
    EXPECT_EQ(shadow_method_named(to_text(method)), method);
  }
  EXPECT_EQ(shadow_method_named("PCF3"), ShadowMethod::pcf3);
  EXPECT_EQ(shadow_method_named(""), std::nullopt);
  EXPECT_EQ(shadow_method_named("pcf"), std::nullopt);
}

TEST(ShadowMethods, AskForMoreBiasTheWiderTheirKernelAndMomentsForLess) {
  const std::pair<ShadowMethod, double> wanted[] = {
      {ShadowMethod::hard, 2},   {ShadowMethod::bilinear, 2},  {ShadowMethod::pcf2, 3},     {ShadowMethod::pcf3, 4},
      {ShadowMethod::pcf4, 5},   {ShadowMethod::pcf4_taps, 5}, {ShadowMethod::sharp3, 2.5}, {ShadowMethod::vsm, 0.5},
      {ShadowMethod::evsm, 0.5}, {ShadowMethod::msm, 0.5}};
  for (const auto& [method, scale] : wanted) EXPECT_EQ(automatic_slope_scale(method), scale) << to_text(method);
}

TEST(ShadowMethods, OnTheCommandLineMayHaveASize) {
  EXPECT_EQ(read_shadow_defaults("evsm").shadows.method, ShadowMethod::evsm);
  EXPECT_EQ(read_shadow_defaults("evsm").shadows.size, 0U);
  EXPECT_EQ(read_shadow_defaults("evsm,512").shadows.size, 512U);
  for (const std::string_view odd : {"", ",", "pcf3,", "pcf3,x", "pcf3,-1", "pcf3,12.5", "pcf3,99999999999", "pcf3,1,1"})
    EXPECT_NE(read_shadow_defaults(odd).error, "") << odd;
}

}  // namespace
}  // namespace plugc

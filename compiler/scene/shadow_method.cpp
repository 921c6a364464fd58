#include "scene/shadow_method.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace plugc {
namespace {

struct MethodInfo {
  std::string_view name;
  double kernel;  ///< Bilinear look-ups along a side of the kernel, as the bias counts them; 0 for none.
};

constexpr auto kMethods = std::to_array<MethodInfo>({{"hard", 0},
                                                     {"bilinear", 1},
                                                     {"pcf2", 2},
                                                     {"pcf3", 3},
                                                     {"pcf4", 4},
                                                     {"pcf2_taps", 2},
                                                     {"pcf3_taps", 3},
                                                     {"pcf4_taps", 4},
                                                     {"sharp3", 1.5},
                                                     {"poisson", 3},
                                                     {"traced", 0},
                                                     {"vsm", 0},
                                                     {"evsm", 0},
                                                     {"msm", 0}});

constexpr double kMomentSlopeScale = 0.5;

constexpr auto make_names() {
  std::array<std::string_view, kMethods.size()> names{};
  for (std::size_t i = 0; i < kMethods.size(); ++i) names[i] = kMethods[i].name;
  return names;
}
constexpr auto kNames = make_names();

bool equal_letters(std::string_view small, std::string_view any) {
  return std::ranges::equal(small, any, [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

}  // namespace

std::span<const std::string_view> shadow_method_names() {
  return kNames;
}

std::string_view to_text(ShadowMethod method) {
  return kNames[static_cast<std::size_t>(method)];
}

std::optional<ShadowMethod> shadow_method_named(std::string_view name) {
  const auto found = std::ranges::find_if(kNames, [&](std::string_view known) { return equal_letters(known, name); });
  if (found == kNames.end()) return std::nullopt;
  return static_cast<ShadowMethod>(found - kNames.begin());
}

ShadowMethod method_for_cube(ShadowMethod method) {
  switch (method) {
    case ShadowMethod::hard:
    case ShadowMethod::bilinear:
    case ShadowMethod::traced:
    case ShadowMethod::poisson: return method;
    default: return ShadowMethod::pcf3;
  }
}

double automatic_slope_scale(ShadowMethod method) {
  if (keeps_moments(method)) return kMomentSlopeScale;
  return std::max(2.0, kMethods[static_cast<std::size_t>(method)].kernel + 1);
}

}  // namespace plugc

// Names of stages and targets, each list in the order of its enumeration.

#include "glsl/stage.h"

#include <array>

namespace plugc {
namespace {

constexpr std::array<std::string_view, kStageCount> kStageNames = {"vertex", "geometry", "fragment"};
constexpr std::array<std::string_view, 3> kTargetNames = {"glsl330", "essl300", "spirv"};

}  // namespace

std::string_view to_text(ShaderStage stage) {
  return kStageNames[static_cast<std::size_t>(stage)];
}

std::string_view to_text(Target target) {
  return kTargetNames[static_cast<std::size_t>(target)];
}

std::optional<Target> target_named(std::string_view name) {
  for (std::size_t i = 0; i < kTargetNames.size(); ++i) {
    if (kTargetNames[i] == name) return static_cast<Target>(i);
  }
  return std::nullopt;
}

}  // namespace plugc

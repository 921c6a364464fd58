#pragma once
// The words that every room behind glsl shares: shader stages and output dialects.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace plugc {

enum class ShaderStage : std::uint8_t { vertex, geometry, fragment };
inline constexpr std::size_t kStageCount = 3;
std::string_view to_text(ShaderStage stage);  ///< "vertex", ...

/// What composed text is written for.
enum class Target : std::uint8_t { glsl330, essl300, spirv };
std::string_view to_text(Target target);  ///< "glsl330", ...
std::optional<Target> target_named(std::string_view name);

}  // namespace plugc

#pragma once
// The numbers by which the stages of a SPIR-V program meet each other and the application (docs/targets.md). GLSL meets by
// name, so glslang has none to give: the numbers follow from the names, and are the same in all stages.

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "glsl/stage.h"
#include "validate/verdict.h"

namespace plugc {

/// One stage as SPIR-V.
struct SpirvStage {
  ShaderStage stage = ShaderStage::vertex;
  std::vector<std::uint32_t> words;
};

/// Decorates every variable that has none of its author's with its location, and opaque uniforms and blocks with their
/// binding. Returns the names of the inputs and outputs that got a location. May throw what SPIRV-Cross throws.
std::set<std::string> assign_interface(std::vector<SpirvStage>& stages);

/// Writes location and binding of each uniform and attribute that the stages have.
void note_interface(const std::vector<SpirvStage>& stages, std::vector<ReflectedVariable>& uniforms,
                    std::vector<ReflectedVariable>& attributes);

}  // namespace plugc

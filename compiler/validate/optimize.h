#pragma once
// A program that does less and draws the same: what no stage behind reads is computed by none before.

#include <string>
#include <vector>

#include "validate/spirv_interface.h"
#include "validate/verdict.h"

namespace plugc {

/// Optimises all stages in place, with what assign_interface() has numbered. Returns what went wrong, or "".
std::string optimize(std::vector<SpirvStage>& stages);

/// Counted in modules that nothing calls into any more: unoptimised ones count helpers once however often they are called.
ProgramCost cost_of(const std::vector<SpirvStage>& stages);

/// A stage as GLSL 3.30 or ESSL 3.00 text. `unnumbered` are inputs and outputs whose location the text does not say. May throw
/// what SPIRV-Cross throws.
std::string write_glsl(const SpirvStage& stage, Target target, const std::set<std::string>& unnumbered);

}  // namespace plugc

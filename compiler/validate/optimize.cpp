// SPIRV-Tools' performance passes (spirv-opt -O) see one stage at a time and must keep what another may read. So the stages
// are taken from the last to the first: once a stage is optimised, the locations that it still reads are known, all other
// outputs of the stage before it become private, and its passes find out what those alone have kept alive.
//
//     fragment: never reads castle_normal_eye   ->   vertex: no castle_normal_eye, no castle_Normal, no castle_NormalMatrix

#include "validate/optimize.h"

#include <spirv-tools/optimizer.hpp>

#include "validate/demote_outputs.h"
#include "validate/spirv_words.h"

namespace plugc {
namespace {

constexpr spv_target_env kEnvironment = SPV_ENV_OPENGL_4_5;

/// The message of the first error, or "".
std::string run_performance_passes(std::vector<std::uint32_t>& words) {
  spvtools::Optimizer optimizer(kEnvironment);
  std::string error;
  optimizer.SetMessageConsumer([&](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
    if (level <= SPV_MSG_ERROR && error.empty()) error = message;
  });
  optimizer.RegisterPerformancePasses();
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);  // it is glslang's output, and what comes of it is judged again
  const bool done = optimizer.Run(words.data(), words.size(), &words, options);
  if (!done && error.empty()) error = "SPIRV-Tools gives no reason";
  return done ? "" : error;
}

bool reads_texture(spv::Op opcode) {
  return (opcode >= spv::OpImageSampleImplicitLod && opcode <= spv::OpImageDrefGather) || opcode == spv::OpImageRead;
}

}  // namespace

std::string optimize(std::vector<SpirvStage>& stages) {
  for (std::size_t i = stages.size(); i-- > 0;) {
    SpirvStage& stage = stages[i];
    if (i + 1 < stages.size()) {
      const SpirvStage& reader = stages[i + 1];
      demote_outputs(stage.words, read_locations(reader.words, reader.stage == ShaderStage::geometry));
    }
    if (std::string error = run_performance_passes(stage.words); !error.empty()) return error;
  }
  return "";
}

ProgramCost cost_of(const std::vector<SpirvStage>& stages) {
  ProgramCost cost;
  for (const SpirvStage& stage : stages) {
    std::uint32_t& instructions = stage.stage == ShaderStage::vertex     ? cost.vertex_instructions
                                  : stage.stage == ShaderStage::geometry ? cost.geometry_instructions
                                                                         : cost.fragment_instructions;
    bool inside = false;
    for_each_instruction(stage.words, [&](const SpirvInstruction& instruction) {
      if (instruction.opcode == spv::OpFunctionEnd) inside = false;
      if (inside) ++instructions;
      if (inside && reads_texture(instruction.opcode)) ++cost.texture_reads;
      if (instruction.opcode == spv::OpFunction) inside = true;
    });
    if (stage.stage == ShaderStage::fragment)
      cost.varyings = static_cast<std::uint32_t>(read_locations(stage.words, false).size());
  }
  return cost;
}

}  // namespace plugc

// SPIRV-Cross with the options of plugc's two GLSL targets. Inputs and outputs meet by name in both, so locations that only
// assign_interface() gave are taken away again: the application has its own for attributes.

#include <spirv_cross/spirv_glsl.hpp>

#include <utility>

#include "validate/optimize.h"

namespace plugc {
namespace {

spirv_cross::CompilerGLSL::Options options_for(Target target) {
  spirv_cross::CompilerGLSL::Options options;
  options.es = target == Target::essl300;
  options.version = options.es ? 300 : 330;
  options.enable_420pack_extension = false;
  options.fragment.default_float_precision = spirv_cross::CompilerGLSL::Options::Highp;
  options.fragment.default_int_precision = spirv_cross::CompilerGLSL::Options::Highp;
  return options;
}

/// Gathers that compare are known to SPIRV-Cross in GLSL 4.00 only; 3.30 has them by an extension.
class GatheringWriter : public spirv_cross::CompilerGLSL {
 public:
  using CompilerGLSL::CompilerGLSL;

 protected:
  void emit_texture_op(const spirv_cross::Instruction& instruction, bool sparse) override {
    if (instruction.op != spv::OpImageDrefGather || options.es) return CompilerGLSL::emit_texture_op(instruction, sparse);
    const auto version = std::exchange(options.version, 400);
    require_extension_internal("GL_ARB_gpu_shader5");
    CompilerGLSL::emit_texture_op(instruction, sparse);
    options.version = version;
  }
};

}  // namespace

std::string write_glsl(const SpirvStage& stage, Target target, const std::set<std::string>& unnumbered) {
  GatheringWriter writer(stage.words);
  writer.set_common_options(options_for(target));
  for (const auto id : writer.get_active_interface_variables()) {
    if (unnumbered.contains(writer.get_name(id))) writer.unset_decoration(id, spv::DecorationLocation);
  }
  return writer.compile();
}

}  // namespace plugc

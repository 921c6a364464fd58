// SPIRV-Cross with the options of plugc's two GLSL targets. Inputs and outputs meet by name in both, so locations that only
// assign_interface() gave are taken away again: the application has its own for attributes.

#include <spirv_cross/spirv_glsl.hpp>

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

}  // namespace

std::string write_glsl(const SpirvStage& stage, Target target, const std::set<std::string>& unnumbered) {
  spirv_cross::CompilerGLSL writer(stage.words);
  writer.set_common_options(options_for(target));
  for (const auto id : writer.get_active_interface_variables()) {
    if (unnumbered.contains(writer.get_name(id))) writer.unset_decoration(id, spv::DecorationLocation);
  }
  return writer.compile();
}

}  // namespace plugc

#pragma once
// What a linked program reads: uniforms, attributes, and inputs that nobody writes.

#include <string>
#include <vector>

#include "validate/verdict.h"

namespace glslang {
class TIntermediate;
class TProgram;
}  // namespace glslang

namespace plugc {

/// Active uniforms in name order, those of blocks as `Block.member`. buildReflection() has been called.
std::vector<ReflectedVariable> reflect_uniforms(const glslang::TProgram& program);
/// Active inputs of the first stage in name order, built-in ones left out.
std::vector<ReflectedVariable> reflect_attributes(const glslang::TProgram& program);

/// A message for each input that `reader` uses and `writer`, the stage before it, does not declare as output.
std::vector<VerdictMessage> find_unwritten_inputs(const glslang::TIntermediate& writer, const glslang::TIntermediate& reader,
                                                  ShaderStage reader_stage, ShaderStage writer_stage);
/// A message for each input of the fragment stage that `writer`, the stage before it, declares with another interpolation.
std::vector<VerdictMessage> find_unequal_interpolation(const glslang::TIntermediate& writer,
                                                       const glslang::TIntermediate& fragment, ShaderStage writer_stage);

}  // namespace plugc

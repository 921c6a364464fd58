#pragma once
// What goes to glslang and what comes back, as plain data and as bytes. The bytes travel to the worker and lie in the
// cache; they are the same for equal content, so requests are compared by comparing them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "validate/validate.h"

namespace plugc {

/// A program without the map that leads to its authors: all that a verdict depends on.
struct Candidate {
  struct Stage {
    ShaderStage stage = ShaderStage::vertex;
    std::string text;
  };
  Target target = Target::glsl330;
  bool optimize = false;
  std::vector<Stage> stages;
};

/// One error. `token` is what the text is about, as glslang quotes it; line 0: no line. glslang names no columns; where one
/// has been found it is the token's first byte, from 1.
struct VerdictMessage {
  ShaderStage stage = ShaderStage::vertex;
  std::uint32_t line = 0;
  std::string token;
  std::string text;
  std::uint32_t column = 0;
};

/// Valid exactly when there is no message; the rest is empty otherwise.
struct Verdict {
  std::vector<VerdictMessage> messages;
  std::vector<ReflectedVariable> uniforms;
  std::vector<ReflectedVariable> attributes;
  std::vector<std::vector<std::uint32_t>> spirv;  // per stage; for Target::spirv only
  std::vector<std::string> optimized_texts;       // per stage, when optimised; not for Target::spirv
  std::optional<ProgramCost> cost;                // when optimised
  std::string not_optimized;                      // why not, though it was asked for
  bool valid() const { return messages.empty(); }
};

std::string encode(const Candidate& candidate);
std::string encode(const ProgramText& program);  ///< As the Candidate of the same texts.
std::string encode(const Verdict& verdict);

/// nullopt when the bytes are none, or none of this version.
std::optional<Candidate> decode_candidate(std::string_view bytes);
std::optional<Verdict> decode_verdict(std::string_view bytes);

}  // namespace plugc

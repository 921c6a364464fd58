#pragma once
// A SPIR-V module as instructions: five words of head, then each instruction with its length in its first word.

#include <spirv_cross/spirv.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace plugc {

struct SpirvInstruction {
  spv::Op opcode = spv::OpNop;
  std::span<const std::uint32_t> words;  ///< The first holds the opcode and the number of words.
};

/// Ends early where a length is impossible.
template <typename Function>
void for_each_instruction(const std::vector<std::uint32_t>& module, Function function) {
  constexpr std::size_t kHeadWords = 5;
  const std::span<const std::uint32_t> words(module);
  for (std::size_t at = kHeadWords; at < words.size();) {
    const std::size_t length = words[at] >> spv::WordCountShift;
    if (length == 0 || length > words.size() - at) return;
    function(SpirvInstruction{static_cast<spv::Op>(words[at] & spv::OpCodeMask), words.subspan(at, length)});
    at += length;
  }
}

}  // namespace plugc

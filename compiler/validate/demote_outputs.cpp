// A variable's storage class stands in the variable, in the type of the pointer to it, and in the types of the pointers that
// access chains make of it. So all three are rewritten; a pointer type that is not there yet is put behind the one that it
// replaces. Only inputs and outputs belong to an entry point's interface (SPIR-V 1.0, 2.3), and only they have locations and
// interpolation, so the entry point's list and the decorations lose the variable.
//
//     OpDecorate %h Location 0                 |
//     %h = OpVariable %ptr_Output_float Output |  %h = OpVariable %ptr_Private_float Private

#include "validate/demote_outputs.h"

#include <spirv_cross/spirv_cross.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include "validate/spirv_words.h"

namespace plugc {
namespace {

using Words = std::vector<std::uint32_t>;
constexpr auto kOutput = static_cast<std::uint32_t>(spv::StorageClassOutput);
constexpr auto kPrivate = static_cast<std::uint32_t>(spv::StorageClassPrivate);

std::set<std::uint32_t> locations_of(const spirv_cross::Compiler& module, std::uint32_t id, bool array_of_vertices) {
  std::set<std::uint32_t> locations;
  if (!module.has_decoration(id, spv::DecorationLocation)) return locations;
  const spirv_cross::SPIRType& type = module.get_type_from_variable(id);
  std::uint32_t size =
      type.basetype == spirv_cross::SPIRType::Struct ? static_cast<std::uint32_t>(type.member_types.size()) : type.columns;
  for (std::size_t i = 0; i + (array_of_vertices ? 1 : 0) < type.array.size(); ++i) size *= std::max(type.array[i], 1U);
  for (std::uint32_t i = 0; i < size; ++i) locations.insert(module.get_decoration(id, spv::DecorationLocation) + i);
  return locations;
}

std::set<std::uint32_t> unread_outputs(const Words& words, const std::set<std::uint32_t>& read) {
  const spirv_cross::Compiler module(words);
  std::set<std::uint32_t> unread;
  for_each_instruction(words, [&](const SpirvInstruction& instruction) {
    if (instruction.opcode != spv::OpVariable || instruction.words[3] != kOutput) return;
    const std::set<std::uint32_t> locations = locations_of(module, instruction.words[2], false);
    const bool is_read = std::ranges::any_of(locations, [&](std::uint32_t location) { return read.contains(location); });
    if (!locations.empty() && !is_read) unread.insert(instruction.words[2]);
  });
  return unread;
}

class Demoter {
 public:
  Demoter(const Words& words, std::set<std::uint32_t> demoted) : words_(words), pointers_(std::move(demoted)) {}
  Words run();

 private:
  void copy(const SpirvInstruction& instruction);
  void copy_pointer_type(const SpirvInstruction& instruction);
  void copy_entry_point(const SpirvInstruction& instruction);
  void append(std::span<const std::uint32_t> words) { result_.insert(result_.end(), words.begin(), words.end()); }

  const Words& words_;
  std::set<std::uint32_t> pointers_;                // demoted variables, and what access chains make of them
  std::map<std::uint32_t, std::uint32_t> instead_;  // of a pointer type to an output: the private one
  Words result_;
};

/// Every pointer type to outputs gets a private twin, be there another already: pointer types need not be unique (SPIR-V 1.0,
/// 2.8), and the optimiser drops those that nobody uses.
void Demoter::copy_pointer_type(const SpirvInstruction& instruction) {
  append(instruction.words);
  if (instruction.words[2] != kOutput) return;
  const std::uint32_t bound = result_[3]++;
  instead_[instruction.words[1]] = bound;
  append(std::vector<std::uint32_t>{instruction.words[0], bound, kPrivate, instruction.words[3]});
}

void Demoter::copy_entry_point(const SpirvInstruction& instruction) {
  constexpr std::size_t kName = 3;
  std::size_t interface = kName;
  while (interface < instruction.words.size() && instruction.words[interface] >> 24U != 0) ++interface;
  const std::size_t begin = result_.size();
  for (std::size_t i = 0; i < instruction.words.size(); ++i) {
    if (i <= interface || !pointers_.contains(instruction.words[i])) result_.push_back(instruction.words[i]);
  }
  const auto length = static_cast<std::uint32_t>(result_.size() - begin);
  result_[begin] = length << spv::WordCountShift | static_cast<std::uint32_t>(spv::OpEntryPoint);
}

void Demoter::copy(const SpirvInstruction& instruction) {
  const auto& words = instruction.words;
  const bool is_chain = instruction.opcode == spv::OpAccessChain || instruction.opcode == spv::OpInBoundsAccessChain ||
                        instruction.opcode == spv::OpCopyObject;
  if (instruction.opcode == spv::OpEntryPoint) return copy_entry_point(instruction);
  if (instruction.opcode == spv::OpTypePointer) return copy_pointer_type(instruction);
  if (instruction.opcode == spv::OpDecorate && pointers_.contains(words[1])) return;
  const std::size_t begin = result_.size();
  append(words);
  if (instruction.opcode == spv::OpVariable && pointers_.contains(words[2])) {
    result_[begin + 1] = instead_.at(words[1]);
    result_[begin + 3] = kPrivate;
  } else if (is_chain && pointers_.contains(words[3])) {
    pointers_.insert(words[2]);
    result_[begin + 1] = instead_.at(words[1]);
  }
}

Words Demoter::run() {
  constexpr std::size_t kHeadWords = 5;
  result_.assign(words_.begin(), words_.begin() + static_cast<std::ptrdiff_t>(std::min(kHeadWords, words_.size())));
  for_each_instruction(words_, [&](const SpirvInstruction& instruction) { copy(instruction); });
  return std::move(result_);
}

}  // namespace

std::set<std::uint32_t> read_locations(const std::vector<std::uint32_t>& words, bool array_of_vertices) {
  const spirv_cross::Compiler module(words);
  std::set<std::uint32_t> read;
  for (const auto id : module.get_active_interface_variables()) {
    if (module.get_storage_class(id) == spv::StorageClassInput) read.merge(locations_of(module, id, array_of_vertices));
  }
  return read;
}

void demote_outputs(std::vector<std::uint32_t>& words, const std::set<std::uint32_t>& read) {
  std::set<std::uint32_t> unread = unread_outputs(words, read);
  if (!unread.empty()) words = Demoter(words, std::move(unread)).run();
}

}  // namespace plugc

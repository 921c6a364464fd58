// All variables of a program are listed first; those that meet (an output and the next stage's input, a uniform of two
// stages) have one name and get one number. Numbers are dealt out in the order of names, each to the first run of free
// numbers that is long enough; what an author numbered himself keeps its number.
// The decorations go in front of the first type, where SPIR-V has them (SPIR-V 1.0, 2.4). Types and names are read by
// SPIRV-Cross.

#include "validate/spirv_interface.h"

#include <spirv_cross/spirv_cross.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "validate/spirv_words.h"

namespace plugc {
namespace {

using spirv_cross::Compiler;
using spirv_cross::SPIRType;

/// The renderer's attributes have the same location in every program, which are those of the runtime.
constexpr std::uint32_t kFirstTexCoord = 4, kFirstCustom = 12, kFogCoord = 15;

std::optional<std::uint32_t> renderer_location(std::string_view attribute) {
  constexpr std::string_view kNames[] = {"castle_Vertex", "castle_Normal", "castle_ColorPerVertex", "castle_Tangent"};
  const auto found = std::ranges::find(kNames, attribute);
  if (found != std::end(kNames)) return static_cast<std::uint32_t>(found - std::begin(kNames));
  if (attribute == "castle_FogCoord") return kFogCoord;
  constexpr std::string_view kTexCoord = "castle_MultiTexCoord";
  const bool one_digit = attribute.size() == kTexCoord.size() + 1 && attribute.starts_with(kTexCoord);
  const char digit = one_digit ? attribute.back() : '?';
  if (digit < '0' || digit > '7') return std::nullopt;
  return kFirstTexCoord + static_cast<std::uint32_t>(digit - '0');
}

/// What a variable is numbered among.
enum class Group : std::uint8_t { attribute, into_geometry, into_fragment, output, uniform, opaque, block };

struct Variable {
  std::uint32_t id = 0;
  std::string name;
  Group group = Group::uniform;
  std::uint32_t size = 1;  ///< Numbers that it takes.
  spv::Decoration decoration = spv::DecorationLocation;
  std::optional<std::uint32_t> given;  ///< By its author, or for good.
  bool has_decoration = false;
};

std::uint32_t elements(const SPIRType& type, std::size_t outer_dimensions_left_out = 0) {
  std::uint32_t count = 1;
  for (std::size_t i = 0; i + outer_dimensions_left_out < type.array.size(); ++i) count *= std::max(type.array[i], 1U);
  return count;
}

/// An input or output takes a location a column, a uniform one a leaf (GLSL 4.60, 4.4.1 to 4.4.3).
std::uint32_t locations(const Compiler& module, const SPIRType& type, bool is_uniform, bool is_array_of_vertices = false) {
  std::uint32_t one = is_uniform ? 1 : type.columns;
  if (type.basetype == SPIRType::Struct) {
    one = 0;
    for (const auto member : type.member_types) one += locations(module, module.get_type(member), is_uniform);
  }
  return one * elements(type, is_array_of_vertices ? 1 : 0);
}

/// The variables of one stage that meet something outside it.
using Variables = std::vector<Variable>;

class VariableLister {
 public:
  VariableLister(const SpirvStage& stage, bool before_geometry, bool keeps_zero)
      : module_(stage.words), stage_(stage.stage), before_geometry_(before_geometry), keeps_zero_(keeps_zero) {
    for_each_instruction(stage.words, [&](const SpirvInstruction& instruction) {
      if (instruction.opcode == spv::OpVariable)
        add(instruction.words[2], static_cast<spv::StorageClass>(instruction.words[3]));
    });
  }
  Variables take() { return std::move(variables_); }

 private:
  void add(std::uint32_t id, spv::StorageClass storage);
  void add_numbered(Variable variable, Group group, spv::Decoration decoration, std::uint32_t size);
  bool is_built_in(std::uint32_t id) const;
  Group input_group() const;

  Compiler module_;
  ShaderStage stage_;
  bool before_geometry_;
  bool keeps_zero_;
  Variables variables_;
};

bool VariableLister::is_built_in(std::uint32_t id) const {
  if (module_.has_decoration(id, spv::DecorationBuiltIn)) return true;
  const SPIRType& type = module_.get_type_from_variable(id);
  return type.basetype == SPIRType::Struct && module_.has_member_decoration(type.self, 0, spv::DecorationBuiltIn);
}

Group VariableLister::input_group() const {
  if (stage_ == ShaderStage::vertex) return Group::attribute;
  return stage_ == ShaderStage::geometry ? Group::into_geometry : Group::into_fragment;
}

void VariableLister::add_numbered(Variable variable, Group group, spv::Decoration decoration, std::uint32_t size) {
  variable.group = group;
  variable.decoration = decoration;
  variable.size = size;
  if (module_.has_decoration(variable.id, decoration)) variable.given = module_.get_decoration(variable.id, decoration);
  variable.has_decoration = variable.given.has_value();
  // glslang gives every sampler that has none of its author's the binding 0
  if (group == Group::opaque && variable.given == 0U && !keeps_zero_) variable.given.reset();
  if (!variable.given && group == Group::attribute) variable.given = renderer_location(variable.name);
  variables_.push_back(std::move(variable));
}

void VariableLister::add(std::uint32_t id, spv::StorageClass storage) {
  const bool is_in = storage == spv::StorageClassInput;
  const bool is_uniform = storage == spv::StorageClassUniform || storage == spv::StorageClassUniformConstant;
  if ((!is_in && !is_uniform && storage != spv::StorageClassOutput) || is_built_in(id)) return;
  const SPIRType& type = module_.get_type_from_variable(id);
  const bool is_block = module_.has_decoration(type.self, spv::DecorationBlock);
  const Variable variable{id, is_block ? module_.get_name(type.self) : module_.get_name(id), {}, 1, {}, {}};
  if (is_uniform && is_block) return add_numbered(variable, Group::block, spv::DecorationBinding, elements(type));
  if (is_uniform) {
    const bool is_opaque = type.basetype == SPIRType::SampledImage || type.basetype == SPIRType::Image;
    if (is_opaque) add_numbered(variable, Group::opaque, spv::DecorationBinding, elements(type));
    return add_numbered(variable, Group::uniform, spv::DecorationLocation, locations(module_, type, true));
  }
  const Group out = stage_ == ShaderStage::fragment ? Group::output
                    : before_geometry_              ? Group::into_geometry
                                                    : Group::into_fragment;
  const bool of_vertices = is_in && stage_ == ShaderStage::geometry;
  add_numbered(variable, is_in ? input_group() : out, spv::DecorationLocation, locations(module_, type, false, of_vertices));
}

/// Deals out the numbers of one group.
class Numbers {
 public:
  void ask(const Variable& variable) {
    std::uint32_t& size = sizes_[variable.name];
    size = std::max(size, variable.size);
    if (variable.given) given_[variable.name] = *variable.given;
  }
  void assign(std::uint32_t first) {
    for (const auto& [name, number] : given_) take(name, number);
    for (const auto& [name, size] : sizes_) {
      if (!given_.contains(name)) take(name, free_run(first, size));
    }
  }
  std::uint32_t of(const std::string& name) const { return numbers_.at(name); }

 private:
  void take(const std::string& name, std::uint32_t number) {
    numbers_[name] = number;
    taken_.emplace(number, std::uint64_t{number} + sizes_.at(name));
  }
  std::uint32_t free_run(std::uint64_t number, std::uint64_t size) const {
    for (const auto& [begin, end] : taken_) {
      if (number + size <= begin) break;
      number = std::max(number, end);
    }
    return static_cast<std::uint32_t>(number);
  }

  std::map<std::string, std::uint32_t> sizes_, given_, numbers_;
  std::multimap<std::uint32_t, std::uint64_t> taken_;  // where a run begins, and where it has ended
};

using Words = std::vector<std::uint32_t>;

Words decoration_words(const Variable& variable, std::uint32_t number) {
  constexpr std::uint32_t kLength = 4;
  return {kLength << spv::WordCountShift | static_cast<std::uint32_t>(spv::OpDecorate), variable.id,
          static_cast<std::uint32_t>(variable.decoration), number};
}

/// Changes a decoration that is there.
void replace_decoration(Words& words, const Variable& variable, std::uint32_t number) {
  const auto decoration = static_cast<std::uint32_t>(variable.decoration);
  std::size_t place = 0;
  for_each_instruction(words, [&](const SpirvInstruction& instruction) {
    const bool is_it =
        instruction.opcode == spv::OpDecorate && instruction.words[1] == variable.id && instruction.words[2] == decoration;
    if (is_it) place = static_cast<std::size_t>(&instruction.words[3] - words.data());
  });
  if (place != 0) words[place] = number;
}

void insert_decorations(Words& words, const Words& decorations) {
  std::size_t first_type = words.size();
  for_each_instruction(words, [&](const SpirvInstruction& instruction) {
    const bool is_type = instruction.opcode >= spv::OpTypeVoid && instruction.opcode <= spv::OpTypeForwardPointer;
    if (is_type) first_type = std::min(first_type, static_cast<std::size_t>(instruction.words.data() - words.data()));
  });
  words.insert(words.begin() + static_cast<std::ptrdiff_t>(first_type), decorations.begin(), decorations.end());
}

/// With `keeps_zero`, the modules have all their numbers.
std::vector<Variables> list_variables(const std::vector<SpirvStage>& stages, bool keeps_zero) {
  const bool has_geometry = std::ranges::find(stages, ShaderStage::geometry, &SpirvStage::stage) != stages.end();
  std::vector<Variables> listed;
  for (const SpirvStage& stage : stages) {
    listed.push_back(VariableLister(stage, has_geometry && stage.stage == ShaderStage::vertex, keeps_zero).take());
  }
  return listed;
}

}  // namespace

std::set<std::string> assign_interface(std::vector<SpirvStage>& stages) {
  const std::vector<Variables> listed = list_variables(stages, false);
  std::map<Group, Numbers> numbers;
  for (const Variables& variables : listed) {
    for (const Variable& variable : variables) numbers[variable.group].ask(variable);
  }
  for (auto& [group, dealt] : numbers) dealt.assign(group == Group::attribute ? kFirstCustom : 0);
  std::set<std::string> numbered;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    Words inserted;
    for (const Variable& variable : listed[i]) {
      const std::uint32_t number = numbers[variable.group].of(variable.name);
      if (variable.has_decoration) {
        replace_decoration(stages[i].words, variable, number);
        continue;
      }
      const Words decoration = decoration_words(variable, number);
      inserted.insert(inserted.end(), decoration.begin(), decoration.end());
      if (variable.group <= Group::output) numbered.insert(variable.name);
    }
    insert_decorations(stages[i].words, inserted);
  }
  return numbered;
}

namespace {

void note(const Variables& variables, Group group, std::vector<ReflectedVariable>& reflected,
          std::uint32_t ReflectedVariable::*member) {
  for (const Variable& variable : variables) {
    if (variable.group != group || !variable.given) continue;
    const auto found = std::ranges::find(reflected, variable.name, &ReflectedVariable::name);
    if (found != reflected.end()) (*found).*member = *variable.given;
  }
}

}  // namespace

void note_interface(const std::vector<SpirvStage>& stages, std::vector<ReflectedVariable>& uniforms,
                    std::vector<ReflectedVariable>& attributes) {
  for (const Variables& variables : list_variables(stages, true)) {
    note(variables, Group::uniform, uniforms, &ReflectedVariable::location);
    note(variables, Group::opaque, uniforms, &ReflectedVariable::binding);
    note(variables, Group::attribute, attributes, &ReflectedVariable::location);
  }
}

}  // namespace plugc

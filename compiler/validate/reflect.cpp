// Uniforms and attributes come from glslang's reflection, which follows calls from main() and so lists active ones only.
// Unwritten inputs are found in the syntax trees: the outputs that a stage declares are among its linker objects (the
// globals, used or not); the inputs that the next stage uses are symbols anywhere else in its tree. A block counts by its
// block name, everything else by its own; a variable with a layout location is matched by location, so it is left alone.
// An input is interpolated as the output of its name says (GLSL 3.30 and ESSL 3.00, 4.3): drivers refuse to link what differs.

#include "validate/reflect.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace plugc {
namespace {

/// `d`, `i`, `u`, `b` before `vec3`; nothing for floats.
std::string vector_prefix(glslang::TBasicType type) {
  switch (type) {
    case glslang::EbtDouble: return "d";
    case glslang::EbtInt: return "i";
    case glslang::EbtUint: return "u";
    case glslang::EbtBool: return "b";
    default: return "";
  }
}

std::string spell(const glslang::TType& type) {
  if (type.getBasicType() == glslang::EbtSampler) return std::string(type.getSampler().getString().c_str());
  const std::string prefix = vector_prefix(type.getBasicType());
  if (type.isMatrix()) {
    const int columns = type.getMatrixCols();
    const int rows = type.getMatrixRows();
    return columns == rows ? fmt::format("{}mat{}", prefix, columns) : fmt::format("{}mat{}x{}", prefix, columns, rows);
  }
  if (type.isVector() && type.getVectorSize() > 1) return fmt::format("{}vec{}", prefix, type.getVectorSize());
  return type.getBasicTypeString().c_str();
}

bool is_built_in(std::string_view name) {
  return name.starts_with("gl_");
}

ReflectedVariable reflected(const glslang::TObjectReflection& object) {
  ReflectedVariable variable{object.name, spell(*object.getType()), 1};
  if (variable.name.ends_with("[0]")) variable.name.resize(variable.name.size() - 3);
  // The size that reflection tells is one more than the highest index used; this is the declared one.
  if (object.getType()->isSizedArray()) variable.count = static_cast<std::uint32_t>(object.getType()->getOuterArraySize());
  return variable;
}

void sort_by_name(std::vector<ReflectedVariable>& variables) {
  std::ranges::sort(variables, {}, &ReflectedVariable::name);
}

/// What two stages match by.
std::string interface_name(const glslang::TIntermSymbol& symbol) {
  const glslang::TType& type = symbol.getType();
  return type.getBasicType() == glslang::EbtBlock ? type.getTypeName().c_str() : symbol.getName().c_str();
}

/// Collects the inputs in use, each with the line of its first use.
struct InputCollector : glslang::TIntermTraverser {
  std::map<std::string, std::uint32_t> first_lines;
  bool has_located_inputs = false;

  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    return node->getOp() != glslang::EOpLinkerObjects;
  }

  void visitSymbol(glslang::TIntermSymbol* symbol) override {
    const glslang::TQualifier& qualifier = symbol->getQualifier();
    const std::string name = interface_name(*symbol);
    if (qualifier.storage != glslang::EvqVaryingIn || qualifier.hasLocation() || is_built_in(name)) return;
    first_lines.emplace(name, static_cast<std::uint32_t>(symbol->getLoc().line));
  }
};

/// What a qualifier says of interpolation; nothing said is `smooth`.
std::string_view interpolation(const glslang::TQualifier& qualifier) {
  if (qualifier.flat) return "flat";
  return qualifier.nopersp ? "noperspective" : "smooth";
}

/// The inputs or outputs that a stage declares, with their interpolation.
std::map<std::string, std::string_view> declared(const glslang::TIntermediate& tree, glslang::TStorageQualifier storage) {
  std::map<std::string, std::string_view> variables;
  for (TIntermNode* node : tree.findLinkerObjects()->getSequence()) {
    const glslang::TIntermSymbol* symbol = node->getAsSymbolNode();
    if (symbol != nullptr && symbol->getQualifier().storage == storage)
      variables.emplace(interface_name(*symbol), interpolation(symbol->getQualifier()));
  }
  return variables;
}

}  // namespace

std::vector<ReflectedVariable> reflect_uniforms(const glslang::TProgram& program) {
  std::vector<ReflectedVariable> uniforms;
  for (int i = 0; i < program.getNumUniformVariables(); ++i) {
    const glslang::TObjectReflection& object = program.getUniform(i);
    if (!is_built_in(object.name)) uniforms.push_back(reflected(object));
  }
  sort_by_name(uniforms);
  return uniforms;
}

std::vector<ReflectedVariable> reflect_attributes(const glslang::TProgram& program) {
  std::vector<ReflectedVariable> attributes;
  for (int i = 0; i < program.getNumPipeInputs(); ++i) {
    const glslang::TObjectReflection& object = program.getPipeInput(i);
    if (!is_built_in(object.name)) attributes.push_back(reflected(object));
  }
  sort_by_name(attributes);
  return attributes;
}

std::vector<VerdictMessage> find_unequal_interpolation(const glslang::TIntermediate& writer,
                                                       const glslang::TIntermediate& fragment, ShaderStage writer_stage) {
  const std::map<std::string, std::string_view> outputs = declared(writer, glslang::EvqVaryingOut);
  std::vector<VerdictMessage> messages;
  for (const auto& [name, said] : declared(fragment, glslang::EvqVaryingIn)) {
    const auto output = outputs.find(name);
    if (is_built_in(name) || output == outputs.end() || output->second == said) continue;
    messages.push_back({ShaderStage::fragment, 0, name,
                        fmt::format("`{}`: interpolation is `{}` here, but `{}` in the {} stage", name, said, output->second,
                                    to_text(writer_stage))});
  }
  return messages;
}

std::vector<VerdictMessage> find_unwritten_inputs(const glslang::TIntermediate& writer, const glslang::TIntermediate& reader,
                                                  ShaderStage reader_stage, ShaderStage writer_stage) {
  InputCollector inputs;
  reader.getTreeRoot()->traverse(&inputs);
  const std::map<std::string, std::string_view> outputs = declared(writer, glslang::EvqVaryingOut);
  std::vector<VerdictMessage> messages;
  for (const auto& [name, line] : inputs.first_lines) {
    if (outputs.contains(name)) continue;
    messages.push_back({reader_stage, line, name,
                        fmt::format("`{}`: the {} stage reads it, but the {} stage has no such output", name,
                                    to_text(reader_stage), to_text(writer_stage))});
  }
  return messages;
}

}  // namespace plugc

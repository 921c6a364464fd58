#include "package/pack_program.h"

#include <map>

#include "base/check.h"
#include "package/pack_attributes.h"
#include "package/target_variables.h"

namespace plugc {
namespace {

PackedUniformType pack_type(std::string_view type) {
  static const std::map<std::string_view, PackedUniformType> kTypes = {
      {"bool", PackedUniformType::bool_},
      {"int", PackedUniformType::int_},
      {"float", PackedUniformType::float_},
      {"vec2", PackedUniformType::vec2},
      {"vec3", PackedUniformType::vec3},
      {"vec4", PackedUniformType::vec4},
      {"ivec2", PackedUniformType::ivec2},
      {"ivec3", PackedUniformType::ivec3},
      {"ivec4", PackedUniformType::ivec4},
      {"mat3", PackedUniformType::mat3},
      {"mat4", PackedUniformType::mat4},
      {"sampler2D", PackedUniformType::sampler2D},
      {"sampler3D", PackedUniformType::sampler3D},
      {"samplerCube", PackedUniformType::samplerCube},
      {"sampler2DShadow", PackedUniformType::sampler2DShadow},
      {"samplerCubeShadow", PackedUniformType::samplerCubeShadow}};
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? PackedUniformType::float_ : found->second;
}

std::unique_ptr<PackedTargetProgramT> pack_target(const ValidatedProgram& program, SourceList& sources) {
  auto packed = std::make_unique<PackedTargetProgramT>();
  packed->target = static_cast<PackedTarget>(program.target());
  for (std::size_t i = 0; i < program.stages().size(); ++i) {
    auto stage = std::make_unique<PackedStageT>();
    stage->kind = static_cast<PackedStageKind>(program.stages()[i].stage);
    stage->text = program.stages()[i].text.text();
    stage->origins = sources.origins(program.stages()[i].text);
    stage->columns = sources.columns(program.stages()[i].text, stage->origins);
    if (i < program.spirv().size()) stage->spirv = program.spirv()[i];
    packed->stages.push_back(std::move(stage));
  }
  return packed;
}

/// What the uniform's declaration gives it; nothing where that does not fit its type.
std::vector<double> initial_of(const UniformOfTargets& uniform, PackedUniformType type) {
  const FieldUniform* field = uniform.fed.field;
  const bool fits = field != nullptr && field->initial.size() == uniform.variable.count * component_count(type);
  return fits ? field->initial : std::vector<double>();
}

std::unique_ptr<PackedUniformT> pack_uniform(const UniformOfTargets& uniform) {
  auto packed = std::make_unique<PackedUniformT>();
  packed->name = uniform.variable.name;
  packed->type = pack_type(uniform.variable.type);
  packed->count = uniform.variable.count;
  packed->targets = static_cast<std::uint8_t>(uniform.targets);
  packed->initial = initial_of(uniform, packed->type);
  packed->location = pack_number(uniform.variable.location);
  packed->binding = pack_number(uniform.variable.binding);
  return packed;
}

}  // namespace

std::unique_ptr<PackedProgramT> pack_program(const ValidRecipe& recipe, std::string name, SourceList& sources) {
  PLUGC_CHECK(!recipe.targets.empty(), "only valid programs are packed");
  auto packed = std::make_unique<PackedProgramT>();
  packed->recipe = std::move(name);
  packed->name = packed->recipe.substr(0, packed->recipe.find(';'));
  for (const TargetProgram& target : recipe.targets) packed->targets.push_back(pack_target(target.program, sources));
  const TargetProgram& first = recipe.targets.front();
  for (const UniformOfTargets& uniform : all_uniforms(recipe)) packed->uniforms.push_back(pack_uniform(uniform));
  packed->attributes = pack_attributes(all_attributes(recipe), recipe.used.screen_pass != ScreenPass::none);
  packed->plugs_filled = first.composed.plugs_filled;
  packed->plugs_empty = first.composed.plugs_empty;
  return packed;
}

std::string program_content(const ValidRecipe& recipe) {
  std::string content;
  for (const TargetProgram& target : recipe.targets) {
    for (const StageText& stage : target.program.stages()) {
      content += static_cast<char>('0' + static_cast<int>(target.program.target()));
      content += static_cast<char>('0' + static_cast<int>(stage.stage));
      content += stage.text.text();
      content += '\0';
    }
    for (const FieldUniform& field : target.composed.fields) {
      for (const double number : field.initial) content.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  }
  // Equal texts of two recipes may be fed differently from target to target: then their lists of uniforms differ.
  for (const UniformOfTargets& uniform : all_uniforms(recipe)) content += static_cast<char>('0' + uniform.targets);
  return content;
}

}  // namespace plugc

// Two targets share a uniform where its declaration and what feeds it are the same; the numbers that only SPIR-V has are kept.

#include "package/target_variables.h"

#include <algorithm>

namespace plugc {
namespace {

/// Numbers are those of the target that has some.
void merge_numbers(ReflectedVariable& into, const ReflectedVariable& from) {
  into.location = std::min(into.location, from.location);
  into.binding = std::min(into.binding, from.binding);
}

bool same_declaration(const ReflectedVariable& a, const ReflectedVariable& b) {
  return a.name == b.name && a.type == b.type && a.count == b.count;
}

UniformNote find_note(const ComposedProgram& program, std::string_view uniform) {
  const auto field = std::ranges::find(program.fields, uniform, &FieldUniform::name);
  const auto switched = std::ranges::find(program.switches, uniform, &SwitchUniform::name);
  return {field == program.fields.end() ? nullptr : &*field, switched == program.switches.end() ? nullptr : &*switched};
}

bool same_field(const FieldUniform* a, const FieldUniform* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->owner == b->owner && a->of_shader == b->of_shader && a->field == b->field;
}

bool same_switch(const SwitchUniform* a, const SwitchUniform* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->of_light == b->of_light && a->index == b->index;
}

}  // namespace

std::vector<UniformOfTargets> all_uniforms(const ValidRecipe& recipe) {
  std::vector<UniformOfTargets> all;
  for (const TargetProgram& target : recipe.targets) {
    const unsigned bit = 1U << static_cast<unsigned>(target.program.target());
    for (const ReflectedVariable& variable : target.program.uniforms()) {
      const UniformNote fed = find_note(target.composed, variable.name);
      const auto same = std::ranges::find_if(all, [&](const UniformOfTargets& other) {
        return same_declaration(other.variable, variable) && same_field(other.fed.field, fed.field) &&
               same_switch(other.fed.switched, fed.switched);
      });
      if (same == all.end()) {
        all.push_back({variable, fed, bit});
      } else {
        same->targets |= bit;
        merge_numbers(same->variable, variable);
      }
    }
  }
  return all;
}

std::vector<ReflectedVariable> all_attributes(const ValidRecipe& recipe) {
  std::vector<ReflectedVariable> all;
  for (const TargetProgram& target : recipe.targets) {
    for (const ReflectedVariable& variable : target.program.attributes()) {
      const auto same = std::ranges::find(all, variable.name, &ReflectedVariable::name);
      same == all.end() ? all.push_back(variable) : merge_numbers(*same, variable);
    }
  }
  return all;
}

}  // namespace plugc

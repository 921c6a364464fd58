// Chapter 1: which code a program has, in which order.
//
// Order at one plug: the effects of the light or texture itself, then of the Appearance, then of the groups from the outermost
// in; within a list in list order. Lights count thus: headlight, directional lights, then point and spot lights in document
// order, without those that are off for good. An effect that is off leaves no trace; one in a language other than GLSL is
// passed over. An EffectPart that is USEd twice in an effect is one definition. LIGHT means the stage that computes the
// lighting: the fragment stage under Phong shading and the vertex stage under Gouraud.

#include <algorithm>

#include "oracle/program_model.h"

namespace plugc::oracle {

std::vector<std::vector<int>> numbered_lights(const EffectSet& set) {
  std::vector<std::vector<int>> lights;
  if (set.headlight) lights.emplace_back();
  for (const bool directional : {true, false}) {
    for (const LightModel& light : set.lights) {
      if (light.on && (light.node == "DirectionalLight") == directional) lights.push_back(light.effects);
    }
  }
  return lights;
}

namespace {

Stage stage_of(PartType type, const ShapeModel& shape) {
  if (type == PartType::light) return shape.gouraud ? Stage::vertex : Stage::fragment;
  return type == PartType::vertex ? Stage::vertex : Stage::fragment;
}

void place_effects(ProgramModel& program, const std::vector<int>& effects, Scope scope, const std::set<int>& left_out) {
  for (const int index : effects) {
    const EffectModel& effect = program.set.effects[static_cast<std::size_t>(index)];
    if (!effect.enabled || effect.language != "GLSL" || left_out.contains(index)) continue;
    const int placement = program.pieces.empty() ? 0 : program.pieces.back().placement + 1;
    std::set<int> placed;
    for (const int part : effect.parts) {
      if (!placed.insert(part).second) continue;
      const PartModel& code = program.set.parts[static_cast<std::size_t>(part)];
      program.pieces.push_back({index, placement, &code, stage_of(code.type, program.shape), scope});
    }
  }
}

}  // namespace

void place_pieces(ProgramModel& program, const std::set<int>& left_out) {
  if (program.shape.lit) {
    const auto lights = numbered_lights(program.set);
    for (std::size_t i = 0; i < lights.size(); ++i) {
      place_effects(program, lights[i], {ScopeKind::light, static_cast<int>(i)}, left_out);
    }
  }
  for (std::size_t i = 0; i < program.shape.textures.size(); ++i) {
    place_effects(program, program.shape.textures[i].effects, {ScopeKind::texture, static_cast<int>(i)}, left_out);
  }
  place_effects(program, program.shape.effects, {}, left_out);
  std::vector<int> groups;
  for (int group = program.shape.group; group >= 0; group = program.set.groups[static_cast<std::size_t>(group)].parent) {
    groups.insert(groups.begin(), group);
  }
  for (const int group : groups)
    place_effects(program, program.set.groups[static_cast<std::size_t>(group)].effects, {}, left_out);
}

}  // namespace plugc::oracle

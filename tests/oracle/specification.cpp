// The frame around the chapters. A faulty effect is found and left out, with those that need its functions, varyings or
// markers, and the rest of the shape's effects still work: so a program is made again without those, until none is faulty.

#include "oracle/specification.h"

#include "oracle/program_model.h"

namespace plugc::oracle {
namespace {

/// Those that need what has gone go too, and so on; each is told at its node.
void leave_out_dependents(const ProgramModel& program, std::set<int>& left_out, std::set<std::string>& said) {
  for (bool grew = true; grew;) {
    grew = false;
    for (const Need& need : program.needs) {
      if (!left_out.contains(need.provider) || !left_out.insert(need.effect).second) continue;
      const EffectModel& effect = program.set.effects[static_cast<std::size_t>(need.effect)];
      say(said, effect.language_line - 1, "effect-left-out-too");
      grew = true;
    }
  }
}

ProgramTrace expect_program(const EffectSet& set, const ShapeModel& shape, std::set<std::string>& said) {
  std::set<int> left_out;
  while (true) {
    ProgramModel program{set, shape, {}, {}, {}, {}};
    place_pieces(program, left_out);
    offer_plugs(program);
    fill_plugs(program, said);
    check_names(program, said);
    if (program.faulty.empty()) return trace_program(program);
    left_out.merge(program.faulty);
    leave_out_dependents(program, left_out, said);
  }
}

void check_effect(const EffectModel& effect, const EffectSet& set, std::set<std::string>& said) {
  if (!effect.enabled) return;
  if (effect.language != "GLSL") return say(said, effect.language_line, "effect-unknown-language");
  check_fields(effect, set, said);
}

}  // namespace

Outcome expect_outcome(const EffectSet& set) {
  Outcome outcome;
  for (const EffectModel& effect : set.effects) check_effect(effect, set, outcome.said);
  for (const ShapeModel& shape : set.shapes) outcome.programs.push_back(expect_program(set, shape, outcome.said));
  return outcome;
}

}  // namespace plugc::oracle

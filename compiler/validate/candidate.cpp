#include "validate/candidate.h"

#include <algorithm>
#include <chrono>

#include "validate/effect_needs.h"

namespace plugc {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

ProgramText take_text(ComposedProgram& composed, Target target, bool optimize) {
  ProgramText text;
  text.target = target;
  text.optimize = optimize;
  for (ComposedStage& stage : composed.stages) text.stages.push_back({stage.stage, std::move(stage.text)});
  composed.stages.clear();
  return text;
}

}  // namespace

Recipe CandidateChecker::without(const ProgramCandidate& candidate, const std::set<int>& gone, bool shader_gone,
                                 Diagnostics& diagnostics) const {
  std::set<int> kept;
  for (const int effect : all_effects(candidate.recipe)) kept.insert(effect);
  for (const int effect : gone) {
    kept.erase(effect);
    report_doubts(input_.effects[static_cast<std::size_t>(effect)], diagnostics);
  }
  Recipe recipe = candidate.recipe;
  if (shader_gone) {
    report_doubts(input_.shaders[static_cast<std::size_t>(recipe.shader)], diagnostics);
    recipe.shader = -1;
  }
  for (const EffectNeed& need : lost_needs(gone, shader_gone, candidate.composed.needs)) {
    if (kept.erase(need.effect) != 0) report_lost_need(need, input_.scene, diagnostics);
  }
  return with_effects(std::move(recipe), kept);
}

void CandidateChecker::compose_candidate(ProgramCandidate& candidate, Diagnostics& diagnostics) {
  const auto start = Clock::now();
  while (true) {
    candidate.composed = compose(candidate.recipe, input_, candidate.target, diagnostics);
    ++statistics_.compositions;
    const bool shader_fails = candidate.composed.faulty_shader && candidate.recipe.shader >= 0;
    const auto& faulty = candidate.composed.faulty_effects;
    if (!shader_fails && faulty.empty()) break;
    candidate.recipe = without(candidate, {faulty.begin(), faulty.end()}, shader_fails, diagnostics);
  }
  statistics_.compose_milliseconds += milliseconds_since(start);
}

void CandidateChecker::validate(std::vector<ProgramCandidate>& candidates) {
  const auto start = Clock::now();
  std::vector<ProgramText> texts;
  for (ProgramCandidate& candidate : candidates)
    texts.push_back(take_text(candidate.composed, candidate.target, candidate.optimize));
  std::vector<ValidationResult> results = validator_.validate(std::move(texts));
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].result = std::move(results[i]);
  statistics_.validate_milliseconds += milliseconds_since(start);
}

ProgramCandidate CandidateChecker::recheck(Recipe recipe, Target target, Diagnostics& diagnostics) {
  std::vector<ProgramCandidate> one(1);
  one[0].recipe = std::move(recipe);
  one[0].target = target;
  compose_candidate(one[0], diagnostics);
  validate(one);
  ++statistics_.rechecks;
  return std::move(one[0]);
}

}  // namespace plugc

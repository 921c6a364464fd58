// The common case is one batch: compose everything, validate everything. A recipe that fails is then taken by itself: the
// effects at fault are searched for (fault_search.cpp), the latest of them is left out with those that need it, and all
// repeats until the rest is valid. A ComposedShader that fails with no effects at all gives way to the base shader.

#include "validate/validate_recipes.h"

#include <fmt/format.h>

#include "validate/candidate.h"
#include "validate/fault_report.h"
#include "validate/fault_search.h"

namespace plugc {
namespace {

class RecipeRepair {
 public:
  /// `many_targets`: an effect may be left out of one target alone, so messages name it.
  RecipeRepair(CandidateChecker& checker, bool many_targets, Diagnostics& diagnostics)
      : checker_(checker),
        many_targets_(many_targets),
        diagnostics_(diagnostics),
        search_(checker, diagnostics.sources(), kMaxRechecks) {}

  void run(ProgramCandidate& candidate);

 private:
  const Scene& scene() const { return checker_.scene(); }
  const SceneEffect& effect(int index) const { return scene().effects[static_cast<std::size_t>(index)]; }
  void say(const Fault& fault, const ProgramCandidate& candidate, const Span& culprit) const;
  void leave_out_last(ProgramCandidate& candidate, const Fault& fault);
  void leave_out_all(ProgramCandidate& candidate, const Fault& fault);
  bool replace_shader(ProgramCandidate& candidate);

  CandidateChecker& checker_;
  const bool many_targets_;
  Diagnostics& diagnostics_;
  FaultSearch search_;
};

void RecipeRepair::say(const Fault& fault, const ProgramCandidate& candidate, const Span& culprit) const {
  if (fault.died) {
    diagnostics_.report(DiagnosticId::validation_died, culprit,
                        fmt::format("the program `{}` cannot be validated: {}", to_text(candidate.recipe, scene()),
                                    fault.messages.front().text));
    return;
  }
  std::vector<const SceneEffect*> authors;
  for (const int index : fault.effects) authors.push_back(&effect(index));
  const bool of_shader = fault.effects.empty() && candidate.recipe.shader >= 0;
  if (of_shader) authors.push_back(&scene().shaders[static_cast<std::size_t>(candidate.recipe.shader)]);
  report_messages(fault.messages, authors, culprit, diagnostics_);
}

void RecipeRepair::leave_out_last(ProgramCandidate& candidate, const Fault& fault) {
  const int left_out = fault.effects.back();
  say(fault, candidate, effect(left_out).span);
  const std::string where = many_targets_ ? fmt::format(" of target `{}`", to_text(candidate.target)) : "";
  report_left_out(fault.effects, left_out, where, scene(), diagnostics_);
  candidate = checker_.recheck(checker_.without(candidate, {left_out}, false, diagnostics_), candidate.target, diagnostics_);
}

/// When the rechecks are spent: every effect that is left goes.
void RecipeRepair::leave_out_all(ProgramCandidate& candidate, const Fault& fault) {
  say(fault, candidate, {});
  for (const int index : all_effects(candidate.recipe)) {
    diagnostics_.report(
        DiagnosticId::effect_left_out, effect(index).span,
        fmt::format("effect `{}` is left out: the program stays invalid, and {} checks did not show which effects are at fault",
                    effect(index).label, kMaxRechecks));
  }
  candidate = checker_.recheck(with_effects(candidate.recipe, {}), candidate.target, diagnostics_);
}

bool RecipeRepair::replace_shader(ProgramCandidate& candidate) {
  if (candidate.recipe.shader < 0) return false;
  const SceneShader& shader = scene().shaders[static_cast<std::size_t>(candidate.recipe.shader)];
  diagnostics_.report(DiagnosticId::shader_replaced, shader.span,
                      fmt::format("`{}` is not valid; {}", shader.label, without_shader(candidate.recipe)));
  candidate = checker_.recheck(checker_.without(candidate, {}, true, diagnostics_), candidate.target, diagnostics_);
  return true;
}

/// Leaves effects out until the program is valid or nothing is left to leave out.
void RecipeRepair::run(ProgramCandidate& candidate) {
  while (!candidate.result.program) {
    const Fault fault = search_.find(candidate);
    if (!fault.is_sure) {
      leave_out_all(candidate, fault);
    } else if (!fault.effects.empty()) {
      leave_out_last(candidate, fault);
    } else {
      const int shader = candidate.recipe.shader;
      say(fault, candidate, shader < 0 ? Span() : scene().shaders[static_cast<std::size_t>(shader)].span);
      if (!replace_shader(candidate)) return;
    }
  }
}

/// Repairing tries programs as they are composed; what it ended with is optimised now.
void optimize_repaired(ProgramCandidate& candidate, CandidateChecker& checker, Diagnostics& diagnostics) {
  if (!candidate.result.program) return;
  if (!candidate.optimize) {
    std::vector<ProgramCandidate> one(1);
    one[0].recipe = candidate.recipe;
    one[0].target = candidate.target;
    one[0].optimize = true;
    checker.compose_candidate(one[0], diagnostics);
    checker.validate(one);
    candidate = std::move(one[0]);
  }
  if (candidate.result.not_optimized.empty()) return;
  diagnostics.report(DiagnosticId::not_optimized, {},
                     fmt::format("program `{}` stays as composed for target {}: {}", to_text(candidate.recipe, checker.scene()),
                                 to_text(candidate.target), candidate.result.not_optimized));
}

std::vector<ProgramCandidate> make_candidates(const std::vector<Recipe>& recipes, const ProgramOptions& options,
                                              CandidateChecker& checker, Diagnostics& diagnostics) {
  std::vector<ProgramCandidate> candidates;
  for (const Recipe& recipe : recipes) {
    for (const Target target : options.targets) {
      ProgramCandidate& candidate = candidates.emplace_back();
      candidate.recipe = recipe;
      candidate.target = target;
      candidate.optimize = options.optimize;
      checker.compose_candidate(candidate, diagnostics);
    }
  }
  checker.validate(candidates);
  return candidates;
}

}  // namespace

std::vector<ValidRecipe> validate_recipes(const std::vector<Recipe>& recipes, const ComposeInput& input,
                                          const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                                          ValidationStatistics& statistics) {
  CandidateChecker checker(input, validator, statistics);
  const std::vector<Target>& targets = options.targets;
  std::vector<ProgramCandidate> candidates = make_candidates(recipes, options, checker, diagnostics);
  std::vector<ValidRecipe> valid(recipes.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ProgramCandidate& candidate = candidates[i];
    RecipeRepair(checker, targets.size() > 1, diagnostics).run(candidate);
    if (options.optimize) optimize_repaired(candidate, checker, diagnostics);
    ValidRecipe& result = valid[i / targets.size()];
    if (i % targets.size() == 0) result.used = candidate.recipe;
    if (candidate.result.program)
      result.targets.push_back({std::move(*candidate.result.program), std::move(candidate.composed)});
  }
  return valid;
}

}  // namespace plugc

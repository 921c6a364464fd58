// The common case is one batch: compose everything, validate everything. A recipe that fails is then taken by itself. An
// effect that glslang's messages point at is tried alone first; if that does not fail, a minimal failing set is found by
// bisection: the shortest list of effects (in call order, beside those already found) that fails ends with a member, and the
// search goes on in front of it. The latest member is left out, and all repeats until the rest is valid. What trials find
// is not reported: an effect may miss another one there that it does not miss in the end. A ComposedShader that fails with
// no effects at all gives way to the base shader.

#include "validate/validate_recipes.h"

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

namespace plugc {
namespace {

using Clock = std::chrono::steady_clock;

/// Effects that glslang's messages name are tried alone, so many of them.
constexpr std::size_t kTriedAlone = 4;
/// Checks that no search may spend: those, one without effects, and what leaving out and the base shader cost in the end.
constexpr std::size_t kLastResorts = kTriedAlone + 4;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class RecipeValidator {
 public:
  RecipeValidator(const ComposeInput& input, Validator& validator, Diagnostics& diagnostics, ValidationStatistics& statistics)
      : input_(input), validator_(validator), diagnostics_(diagnostics), statistics_(statistics) {}

  std::vector<ValidRecipe> run(const std::vector<Recipe>& recipes, const ProgramOptions& options);

 private:
  struct Candidate {
    Recipe recipe;
    Target target = Target::glsl330;
    bool optimize = false;
    ComposedProgram composed;
    ValidationResult result;
  };

  void compose_candidate(Candidate& candidate, Diagnostics& diagnostics);
  void validate_candidates(std::vector<Candidate>& candidates);
  Candidate check(const Recipe& recipe, Target target, Diagnostics& diagnostics);
  bool fails(const Candidate& candidate, const std::set<int>& effects);
  void repair(Candidate& candidate);
  void optimize(Candidate& candidate);
  void leave_out(Candidate& candidate, const std::vector<int>& failing);
  void leave_out_all(Candidate& candidate);
  bool replace_shader(Candidate& candidate);
  std::vector<int> failing_set(const Candidate& candidate);
  std::vector<int> bisect(const Candidate& candidate);
  std::vector<int> suspects(const Candidate& candidate) const;
  void report_messages(const Candidate& candidate, const Span& culprit) const;
  void report_left_out(const std::vector<int>& failing, int left_out, Target target) const;
  std::string of_target(Target target) const;
  const SceneEffect& effect(int index) const { return input_.scene.effects[static_cast<std::size_t>(index)]; }
  const EffectCode& code(int index) const { return input_.effects[static_cast<std::size_t>(index)]; }

  const ComposeInput& input_;
  Validator& validator_;
  Diagnostics& diagnostics_;
  ValidationStatistics& statistics_;
  std::size_t rechecks_left_ = 0;
  std::size_t target_count_ = 1;
};

/// Composes; effects that composing itself finds at fault (their mistakes are reported by then) are left out at once.
void RecipeValidator::compose_candidate(Candidate& candidate, Diagnostics& diagnostics) {
  const auto start = Clock::now();
  while (true) {
    candidate.composed = compose(candidate.recipe, input_, candidate.target, diagnostics);
    ++statistics_.compositions;
    const bool shader_fails = candidate.composed.faulty_shader && candidate.recipe.shader >= 0;
    const auto& faulty = candidate.composed.faulty_effects;
    if (!shader_fails && faulty.empty()) break;
    if (shader_fails) candidate.recipe.shader = -1;
    std::vector<int> kept = all_effects(candidate.recipe);
    std::erase_if(kept, [&](int effect) { return std::find(faulty.begin(), faulty.end(), effect) != faulty.end(); });
    candidate.recipe = with_effects(std::move(candidate.recipe), {kept.begin(), kept.end()});
  }
  statistics_.compose_milliseconds += milliseconds_since(start);
}

ProgramText take_text(ComposedProgram& composed, Target target, bool optimize) {
  ProgramText text;
  text.target = target;
  text.optimize = optimize;
  for (ComposedStage& stage : composed.stages) text.stages.push_back({stage.stage, std::move(stage.text)});
  composed.stages.clear();
  return text;
}

void RecipeValidator::validate_candidates(std::vector<Candidate>& candidates) {
  const auto start = Clock::now();
  std::vector<ProgramText> texts;
  for (Candidate& candidate : candidates) texts.push_back(take_text(candidate.composed, candidate.target, candidate.optimize));
  std::vector<ValidationResult> results = validator_.validate(std::move(texts));
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].result = std::move(results[i]);
  statistics_.validate_milliseconds += milliseconds_since(start);
}

RecipeValidator::Candidate RecipeValidator::check(const Recipe& recipe, Target target, Diagnostics& diagnostics) {
  std::vector<Candidate> one(1);
  one[0].recipe = recipe;
  one[0].target = target;
  compose_candidate(one[0], diagnostics);
  validate_candidates(one);
  ++statistics_.rechecks;
  if (rechecks_left_ > 0) --rechecks_left_;
  return std::move(one[0]);
}

/// Whether the candidate fails with these of its effects alone.
bool RecipeValidator::fails(const Candidate& candidate, const std::set<int>& effects) {
  Diagnostics unheard(diagnostics_.sources());
  return !check(with_effects(candidate.recipe, effects), candidate.target, unheard).result.program.has_value();
}

/// Whether the place lies in the text of one of the effect's parts, wherever that was read from.
bool lies_in(const Span& span, const SceneEffect& effect) {
  return std::any_of(effect.parts.begin(), effect.parts.end(), [&](const ShaderSource& part) {
    const Span all = part.text.locate(0, part.text.size());
    const Span last = part.text.empty() ? Span{} : part.text.locate(part.text.size() - 1, part.text.size());
    return all.valid() && span.source == all.source && all.begin <= span.begin && span.begin <= std::max(all.end, last.end);
  });
}

/// Effects whose code cannot be taken apart or that glslang's messages point at, latest first.
std::vector<int> RecipeValidator::suspects(const Candidate& candidate) const {
  std::vector<int> found;
  for (const int index : all_effects(candidate.recipe)) {
    const auto& messages = candidate.result.messages;
    const bool named =
        code(index).has_problems || std::any_of(messages.begin(), messages.end(), [&](const ShaderMessage& message) {
          return message.span.valid() && lies_in(message.span, effect(index));
        });
    if (named) found.insert(found.begin(), index);
  }
  return found;
}

/// A set of effects that fail together and of which none can be spared, latest first; empty when the program fails
/// without any effect.
std::vector<int> RecipeValidator::failing_set(const Candidate& candidate) {
  const std::vector<int> all = all_effects(candidate.recipe);
  if (all.empty() || fails(candidate, {})) return {};
  if (all.size() == 1) return all;
  const std::vector<int> named = suspects(candidate);
  for (std::size_t i = 0; i < std::min(named.size(), kTriedAlone); ++i) {
    if (fails(candidate, {named[i]})) return {named[i]};
  }
  return bisect(candidate);
}

std::vector<int> RecipeValidator::bisect(const Candidate& candidate) {
  std::vector<int> list = all_effects(candidate.recipe);
  std::vector<int> found;
  const auto first_and_found = [&](std::size_t count) {
    std::set<int> effects(found.begin(), found.end());
    effects.insert(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count));
    return effects;
  };
  while (!list.empty() && rechecks_left_ > kLastResorts && (found.empty() || !fails(candidate, first_and_found(0)))) {
    std::size_t passes = 0, failing = list.size();
    while (failing - passes > 1 && rechecks_left_ > kLastResorts) {
      const std::size_t middle = passes + (failing - passes) / 2;
      (fails(candidate, first_and_found(middle)) ? failing : passes) = middle;
    }
    found.push_back(list[failing - 1]);
    list.resize(failing - 1);
  }
  return found.empty() ? list : found;
}

/// Where glslang gives no place at all, the culprit's is shown; beside messages with a place those add nothing.
void RecipeValidator::report_messages(const Candidate& candidate, const Span& culprit) const {
  if (candidate.result.died) {
    diagnostics_.report(
        DiagnosticId::validation_died, culprit,
        fmt::format("validating the program `{}` crashed or took too long", to_text(candidate.recipe, input_.scene)));
  }
  const auto& messages = candidate.result.messages;
  const bool any_place =
      std::any_of(messages.begin(), messages.end(), [](const ShaderMessage& message) { return message.span.valid(); });
  for (const ShaderMessage& message : messages) {
    if (message.span.valid()) {
      diagnostics_.report(DiagnosticId::shader_invalid, message.span, message.text);
    } else if (!any_place) {
      diagnostics_.report(DiagnosticId::shader_invalid, culprit,
                          fmt::format("{} (in the composed {} stage)", message.text, to_text(message.stage)));
    }
  }
}

/// ` of target `essl300``, where there are others.
std::string RecipeValidator::of_target(Target target) const {
  return target_count_ < 2 ? "" : fmt::format(" of target `{}`", to_text(target));
}

void RecipeValidator::report_left_out(const std::vector<int>& failing, int left_out, Target target) const {
  if (failing.size() == 1) {
    diagnostics_.report(
        DiagnosticId::effect_left_out, effect(left_out).span,
        fmt::format("effect `{}` is left out{}: the program is not valid with it", effect(left_out).label, of_target(target)));
    return;
  }
  std::vector<RelatedPlace> related;
  std::string names;
  for (const int index : failing) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", effect(index).label);
    if (index != left_out) related.push_back({effect(index).span, "together with this effect"});
  }
  diagnostics_.report(DiagnosticId::effect_left_out, effect(left_out).span,
                      fmt::format("effect `{}` is left out{}: the effects {} fail together, and it is the last of them",
                                  effect(left_out).label, of_target(target), names),
                      std::move(related));
}

bool RecipeValidator::replace_shader(Candidate& candidate) {
  if (candidate.recipe.shader < 0) return false;
  const SceneShader& shader = input_.scene.shaders[static_cast<std::size_t>(candidate.recipe.shader)];
  diagnostics_.report(DiagnosticId::shader_replaced, shader.span,
                      fmt::format("`{}` is not valid; the base shader is used instead", shader.label));
  candidate.recipe.shader = -1;
  return true;
}

void RecipeValidator::leave_out(Candidate& candidate, const std::vector<int>& failing) {
  const int left_out = failing.front();
  // what glslang makes of code whose brackets do not match says nothing beyond that
  if (!code(left_out).has_problems) report_messages(candidate, effect(left_out).span);
  report_left_out({failing.rbegin(), failing.rend()}, left_out, candidate.target);
  candidate = check(without_effect(candidate.recipe, left_out), candidate.target, diagnostics_);
}

/// When the rechecks are spent: every effect that is left goes.
void RecipeValidator::leave_out_all(Candidate& candidate) {
  report_messages(candidate, {});
  for (const int index : all_effects(candidate.recipe)) {
    diagnostics_.report(
        DiagnosticId::effect_left_out, effect(index).span,
        fmt::format("effect `{}` is left out: the program stays invalid, and {} checks did not show which effects are at fault",
                    effect(index).label, kMaxRechecks));
  }
  candidate = check(with_effects(candidate.recipe, {}), candidate.target, diagnostics_);
}

/// Leaves effects out until the program is valid or nothing is left to leave out.
void RecipeValidator::repair(Candidate& candidate) {
  rechecks_left_ = kMaxRechecks;
  while (!candidate.result.program) {
    const std::vector<int> failing = rechecks_left_ > kLastResorts ? failing_set(candidate) : all_effects(candidate.recipe);
    const bool is_sure = failing.size() == 1 || rechecks_left_ > kLastResorts;
    if (failing.empty()) {
      report_messages(candidate, {});
      if (!replace_shader(candidate)) return;
      candidate = check(candidate.recipe, candidate.target, diagnostics_);
    } else {
      is_sure ? leave_out(candidate, failing) : leave_out_all(candidate);
    }
  }
}

/// Repairing tries programs as they are composed; what it ended with is optimised now.
void RecipeValidator::optimize(Candidate& candidate) {
  if (!candidate.result.program) return;
  if (!candidate.optimize) {
    std::vector<Candidate> one(1);
    one[0].recipe = candidate.recipe;
    one[0].target = candidate.target;
    one[0].optimize = true;
    compose_candidate(one[0], diagnostics_);
    validate_candidates(one);
    candidate = std::move(one[0]);
  }
  if (candidate.result.not_optimized.empty()) return;
  diagnostics_.report(DiagnosticId::not_optimized, {},
                      fmt::format("program `{}` stays as composed for target {}: {}", to_text(candidate.recipe, input_.scene),
                                  to_text(candidate.target), candidate.result.not_optimized));
}

std::vector<ValidRecipe> RecipeValidator::run(const std::vector<Recipe>& recipes, const ProgramOptions& options) {
  const std::vector<Target>& targets = options.targets;
  target_count_ = targets.size();
  std::vector<Candidate> candidates;
  for (const Recipe& recipe : recipes) {
    for (const Target target : targets) {
      candidates.emplace_back();
      candidates.back().recipe = recipe;
      candidates.back().target = target;
      candidates.back().optimize = options.optimize;
      compose_candidate(candidates.back(), diagnostics_);
    }
  }
  validate_candidates(candidates);
  std::vector<ValidRecipe> valid(recipes.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Candidate& candidate = candidates[i];
    repair(candidate);
    if (options.optimize) optimize(candidate);
    ValidRecipe& result = valid[i / targets.size()];
    if (i % targets.size() == 0) result.used = candidate.recipe;
    if (candidate.result.program)
      result.targets.push_back({std::move(*candidate.result.program), std::move(candidate.composed)});
  }
  return valid;
}

}  // namespace

std::vector<ValidRecipe> validate_recipes(const std::vector<Recipe>& recipes, const ComposeInput& input,
                                          const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                                          ValidationStatistics& statistics) {
  return RecipeValidator(input, validator, diagnostics, statistics).run(recipes, options);
}

}  // namespace plugc

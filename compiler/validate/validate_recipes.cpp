// The common case is one batch: compose everything, validate everything. A recipe that fails is then taken by itself:
// the effects that glslang's messages point at are tried first, each by leaving it out; if that does not help, the list of
// effects is shrunk one by one to a minimal failing set (every member needed), of which the latest in order is left out. This
// repeats until the rest is valid. A ComposedShader that fails with no effects at all gives way to the base shader.

#include "validate/validate_recipes.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace plugc {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class RecipeValidator {
 public:
  RecipeValidator(const ComposeInput& input, Validator& validator, Diagnostics& diagnostics, ValidationStatistics& statistics)
      : input_(input), validator_(validator), diagnostics_(diagnostics), statistics_(statistics) {}

  std::vector<ValidRecipe> run(const std::vector<Recipe>& recipes, const std::vector<Target>& targets);

 private:
  struct Candidate {
    Recipe recipe;
    Target target = Target::glsl330;
    ComposedProgram composed;
    ValidationResult result;
  };

  void compose_candidate(Candidate& candidate);
  void validate_candidates(std::vector<Candidate>& candidates);
  bool is_valid(const Recipe& recipe, Target target);
  bool spend_recheck();
  void repair(Candidate& candidate);
  bool replace_shader(Candidate& candidate);
  std::vector<int> failing_set(const Candidate& candidate);
  std::vector<int> suspects(const Candidate& candidate) const;
  void report_messages(const Candidate& candidate) const;
  void report_left_out(const std::vector<int>& failing, int left_out) const;
  const SceneEffect& effect(int index) const { return input_.scene.effects[static_cast<std::size_t>(index)]; }

  const ComposeInput& input_;
  Validator& validator_;
  Diagnostics& diagnostics_;
  ValidationStatistics& statistics_;
  std::size_t rechecks_left_ = 0;
};

/// Composes; effects that composing itself finds at fault (their mistakes are reported by then) are left out at once.
void RecipeValidator::compose_candidate(Candidate& candidate) {
  const auto start = Clock::now();
  while (true) {
    candidate.composed = compose(candidate.recipe, input_, candidate.target, diagnostics_);
    ++statistics_.compositions;
    if (candidate.composed.faulty_shader && candidate.recipe.shader >= 0) {
      candidate.recipe.shader = -1;
    } else if (!candidate.composed.faulty_effects.empty()) {
      for (const int faulty : candidate.composed.faulty_effects) candidate.recipe = without_effect(candidate.recipe, faulty);
    } else {
      break;
    }
  }
  statistics_.compose_milliseconds += milliseconds_since(start);
}

ProgramText take_text(ComposedProgram& composed, Target target) {
  ProgramText text;
  text.target = target;
  for (ComposedStage& stage : composed.stages) text.stages.push_back({stage.stage, std::move(stage.text)});
  composed.stages.clear();
  return text;
}

void RecipeValidator::validate_candidates(std::vector<Candidate>& candidates) {
  const auto start = Clock::now();
  std::vector<ProgramText> texts;
  for (Candidate& candidate : candidates) texts.push_back(take_text(candidate.composed, candidate.target));
  std::vector<ValidationResult> results = validator_.validate(std::move(texts));
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].result = std::move(results[i]);
  statistics_.validate_milliseconds += milliseconds_since(start);
}

bool RecipeValidator::spend_recheck() {
  if (rechecks_left_ == 0) return false;
  --rechecks_left_;
  ++statistics_.rechecks;
  return true;
}

bool RecipeValidator::is_valid(const Recipe& recipe, Target target) {
  std::vector<Candidate> one(1);
  one[0].recipe = recipe;
  one[0].target = target;
  compose_candidate(one[0]);
  validate_candidates(one);
  return one[0].result.program.has_value();
}

bool lies_in(const Span& span, const SceneEffect& effect) {
  return std::any_of(effect.parts.begin(), effect.parts.end(), [&](const ShaderSource& part) {
    return span.source == part.span.source && part.span.begin <= span.begin && span.begin <= part.span.end;
  });
}

/// Effects that glslang's messages point at, latest first.
std::vector<int> RecipeValidator::suspects(const Candidate& candidate) const {
  std::vector<int> found;
  for (const int index : all_effects(candidate.recipe)) {
    const auto& messages = candidate.result.messages;
    const bool named = std::any_of(messages.begin(), messages.end(), [&](const ShaderMessage& message) {
      return message.span.valid() && lies_in(message.span, effect(index));
    });
    if (named) found.insert(found.begin(), index);
  }
  return found;
}

/// A set of effects that fail together and of which none can be spared; empty when the program fails without any effect.
std::vector<int> RecipeValidator::failing_set(const Candidate& candidate) {
  for (const int suspect : suspects(candidate)) {
    Recipe alone = candidate.recipe;
    for (const int other : all_effects(candidate.recipe)) {
      if (other != suspect) alone = without_effect(alone, other);
    }
    if (spend_recheck() && !is_valid(alone, candidate.target)) {
      Recipe none = without_effect(alone, suspect);
      if (spend_recheck() && is_valid(none, candidate.target)) return {suspect};
      return {};
    }
  }
  Recipe failing = candidate.recipe;
  for (const int index : all_effects(candidate.recipe)) {
    const Recipe smaller = without_effect(failing, index);
    if (spend_recheck() && !is_valid(smaller, candidate.target)) failing = smaller;
  }
  return all_effects(failing);
}

void RecipeValidator::report_messages(const Candidate& candidate) const {
  if (candidate.result.died) {
    diagnostics_.report(DiagnosticId::validation_died, {},
                        fmt::format("validating the program `{}` crashed or took too long", to_text(candidate.recipe, input_.scene)));
  }
  for (const ShaderMessage& message : candidate.result.messages) {
    const std::string where = message.span.valid() ? "" : fmt::format(" (in the composed {} stage)", to_text(message.stage));
    diagnostics_.report(DiagnosticId::shader_invalid, message.span, message.text + where);
  }
}

void RecipeValidator::report_left_out(const std::vector<int>& failing, int left_out) const {
  if (failing.size() == 1) {
    diagnostics_.report(DiagnosticId::effect_left_out, effect(left_out).span,
                        fmt::format("effect `{}` is left out: the program is not valid with it", effect(left_out).label));
    return;
  }
  std::vector<RelatedPlace> related;
  std::string names;
  for (const int index : failing) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", effect(index).label);
    if (index != left_out) related.push_back({effect(index).span, "together with this effect"});
  }
  diagnostics_.report(DiagnosticId::effect_left_out, effect(left_out).span,
                      fmt::format("effect `{}` is left out: the effects {} fail together, and it is the last of them",
                                  effect(left_out).label, names),
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

/// Leaves effects out until the program is valid or nothing is left to leave out.
void RecipeValidator::repair(Candidate& candidate) {
  rechecks_left_ = kMaxRechecks;
  while (!candidate.result.program) {
    report_messages(candidate);
    std::vector<int> failing = failing_set(candidate);
    if (rechecks_left_ == 0) failing = all_effects(candidate.recipe);
    if (failing.empty() && !replace_shader(candidate)) return;
    if (!failing.empty()) {
      report_left_out(failing, failing.back());
      candidate.recipe = without_effect(candidate.recipe, failing.back());
    }
    std::vector<Candidate> one(1);
    one[0].recipe = candidate.recipe;
    one[0].target = candidate.target;
    compose_candidate(one[0]);
    validate_candidates(one);
    candidate = std::move(one[0]);
  }
}

std::vector<ValidRecipe> RecipeValidator::run(const std::vector<Recipe>& recipes, const std::vector<Target>& targets) {
  std::vector<Candidate> candidates;
  for (const Recipe& recipe : recipes) {
    for (const Target target : targets) {
      candidates.emplace_back();
      candidates.back().recipe = recipe;
      candidates.back().target = target;
      compose_candidate(candidates.back());
    }
  }
  validate_candidates(candidates);
  std::vector<ValidRecipe> valid(recipes.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Candidate& candidate = candidates[i];
    repair(candidate);
    ValidRecipe& result = valid[i / targets.size()];
    if (i % targets.size() == 0) result.used = candidate.recipe;
    if (candidate.result.program) result.targets.push_back({std::move(*candidate.result.program), std::move(candidate.composed)});
  }
  return valid;
}

}  // namespace

std::vector<ValidRecipe> validate_recipes(const std::vector<Recipe>& recipes, const ComposeInput& input,
                                          const std::vector<Target>& targets, Validator& validator, Diagnostics& diagnostics,
                                          ValidationStatistics& statistics) {
  return RecipeValidator(input, validator, diagnostics, statistics).run(recipes, targets);
}

}  // namespace plugc

// Effects that glslang's messages point at are tried alone first. If none of them fails so, a minimal failing set is found by
// bisection: the shortest list of effects that fails, beside those already found, ends with a member, and the search goes
// on in front of it. The list has each effect behind those without whose functions or varyings its code is not valid, so that
// every beginning of it stands by itself; and an effect is tried with those, after they have been tried without it.
//
//     [a b c d e] fails, [a b] does not, [a b c d] fails, [a b c] does not   ->   d is a member; then {d} + [a b c] ...

#include "validate/fault_search.h"

#include <algorithm>

#include "validate/effect_needs.h"
#include "validate/fault_report.h"

namespace plugc {
namespace {

/// Effects that glslang's messages name are tried alone, so many of them.
constexpr std::size_t kTriedAlone = 4;
/// Checks that no search may spend: those (with their providers), one without effects, and what leaving out costs in the end.
constexpr std::size_t kLastResorts = 2 * kTriedAlone + 4;

}  // namespace

const FaultSearch::Trial& FaultSearch::try_effects(const ProgramCandidate& candidate, std::set<int> effects) {
  effects = with_providers(std::move(effects), candidate.composed.needs);
  const auto [found, added] = trials_.try_emplace({candidate.recipe.shader, effects});
  if (added) {
    Diagnostics unheard(sources_);
    ProgramCandidate trial = checker_.recheck(with_effects(candidate.recipe, effects), candidate.target, unheard);
    found->second = {!trial.result.program, trial.result.died, std::move(trial.result.messages)};
  }
  return found->second;
}

/// Whether the effect fails with what it needs, which does not fail without it.
bool FaultSearch::fails_by_itself(const ProgramCandidate& candidate, int effect) {
  std::set<int> providers = with_providers({effect}, candidate.composed.needs);
  providers.erase(effect);
  return try_effects(candidate, {effect}).fails && (providers.empty() || !try_effects(candidate, providers).fails);
}

/// Effects that glslang's messages point at, those that need no other first, else latest first.
std::vector<int> FaultSearch::suspects(const ProgramCandidate& candidate) const {
  std::vector<int> found;
  for (const int index : all_effects(candidate.recipe)) {
    const SceneEffect& effect = checker_.scene().effects[static_cast<std::size_t>(index)];
    const auto& messages = candidate.result.messages;
    const bool named = std::any_of(messages.begin(), messages.end(),
                                   [&](const ShaderMessage& message) { return lies_in(message.span, effect); });
    if (named) found.insert(found.begin(), index);
  }
  std::stable_sort(found.begin(), found.end(), [&](int a, int b) {
    return with_providers({a}, candidate.composed.needs).size() < with_providers({b}, candidate.composed.needs).size();
  });
  return found;
}

std::set<int> FaultSearch::bisect(const ProgramCandidate& candidate, bool& is_sure) {
  std::vector<int> list = providers_first(all_effects(candidate.recipe), candidate.composed.needs);
  std::set<int> found;
  const auto fails_with = [&](std::size_t count) {
    std::set<int> effects = found;
    effects.insert(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count));
    return try_effects(candidate, std::move(effects)).fails;
  };
  while (!list.empty() && rechecks_left() > kLastResorts && (found.empty() || !fails_with(0))) {
    std::size_t passes = 0, failing = list.size();
    while (failing - passes > 1 && rechecks_left() > kLastResorts) {
      const std::size_t middle = passes + (failing - passes) / 2;
      (fails_with(middle) ? failing : passes) = middle;
    }
    found.insert(list[failing - 1]);
    list.resize(failing - 1);
  }
  is_sure = rechecks_left() > kLastResorts;
  return found;
}

/// A provider at which glslang points too is part of the fault; any other is only there for the sake of it.
Fault FaultSearch::fault_of(const ProgramCandidate& candidate, std::set<int> effects) {
  Fault fault;
  const Trial& trial = try_effects(candidate, effects);
  fault.messages = trial.fails ? trial.messages : candidate.result.messages;
  fault.died = trial.fails ? trial.died : candidate.result.died;
  for (const int provider : with_providers(effects, candidate.composed.needs)) {
    const SceneEffect& author = checker_.scene().effects[static_cast<std::size_t>(provider)];
    const bool named = std::any_of(fault.messages.begin(), fault.messages.end(),
                                   [&](const ShaderMessage& message) { return lies_in(message.span, author); });
    if (named) effects.insert(provider);
  }
  for (const int effect : all_effects(candidate.recipe)) {
    if (effects.contains(effect)) fault.effects.push_back(effect);
  }
  return fault;
}

Fault FaultSearch::find(const ProgramCandidate& candidate) {
  const std::vector<int> all = all_effects(candidate.recipe);
  if (all.empty()) return {{}, candidate.result.messages, candidate.result.died, true};
  if (rechecks_left() <= kLastResorts) return {all, candidate.result.messages, candidate.result.died, false};
  if (try_effects(candidate, {}).fails) return fault_of(candidate, {});
  const std::vector<int> named = suspects(candidate);
  for (std::size_t i = 0; i < std::min(named.size(), kTriedAlone); ++i) {
    if (fails_by_itself(candidate, named[i])) return fault_of(candidate, {named[i]});
  }
  bool is_sure = true;
  const std::set<int> found = bisect(candidate, is_sure);
  Fault fault = fault_of(candidate, found);
  fault.is_sure = is_sure;
  return fault;
}

}  // namespace plugc

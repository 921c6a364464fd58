// Best first. The error of a map falls as one over its size, so each measurement says which size should do: before the first
// one of a method, the floor times what is usual for the method. The branch (a method) that may cost least is tried; the search
// ends where no branch could beat the best by more than a little. Where no method seems to get there, what came nearest is
// tried as large as can be. So a method that does worse here than usual (thin features vanish under a wide kernel) gives way to
// the next by itself.

#include "runtime/measure/shadow_search.h"

#include <algorithm>
#include <cmath>

#include "runtime/measure/shadow_cost.h"

namespace plugc {
namespace {

constexpr double kAim = 0.96;          // of the budget: chance decides where texels lie, and a miss costs another try
constexpr double kWorthWhile = 0.95;   // of the best cost: what saves less is not tried
constexpr double kHope = 0.8;          // of the usual error: what a method that was not tried yet may do better here
constexpr double kCloseEnough = 0.92;  // of the size that satisfies: smaller steps are not tried
constexpr double kHopeless = 2;        // times the largest size: a method that seems to need more is not tried
constexpr std::size_t kMostTrials = 24;

std::uint32_t rounded_up(double size, std::uint32_t largest) {
  const double steps = std::ceil(std::clamp(size, 1.0, double(largest)) / kSizeStep);
  return std::clamp(static_cast<std::uint32_t>(steps) * kSizeStep, std::min(kSmallestSize, largest), largest);
}

}  // namespace

ShadowSearch::ShadowSearch(ShadowTask task) : task_(std::move(task)) {
  for (const ShadowCandidate& candidate : task_.candidates) {
    const double error = expected_error_factor(candidate.method) * task_.floor_of_texel;
    branches_.push_back({candidate, task_.size ? *task_.size : size_for(error, candidate), 0, {}});
  }
}

std::uint32_t ShadowSearch::size_for(double error_of_texel, const ShadowCandidate& candidate) const {
  const double size = error_of_texel / (kAim * task_.budget);
  return size > kHopeless * candidate.largest ? 0 : rounded_up(size, candidate.largest);
}

double ShadowSearch::hoped_cost(const Branch& branch) const {
  const bool tried = branch.fails > 0 || branch.satisfies;
  const double size = tried || task_.size ? branch.size : kHope * branch.size;
  return shadow_cost(branch.candidate.method, static_cast<std::uint32_t>(size), task_.receiver_pixels, task_.faces);
}

const ShadowSearch::Branch* ShadowSearch::cheapest_branch() const {
  const Branch* cheapest = nullptr;
  for (const Branch& branch : branches_) {
    if (branch.size == 0) continue;
    if (cheapest == nullptr || hoped_cost(branch) < hoped_cost(*cheapest)) cheapest = &branch;
  }
  return cheapest;
}

std::optional<ShadowConfiguration> ShadowSearch::next() const {
  const Branch* branch = cheapest_branch();
  if (trials_.size() >= kMostTrials) return std::nullopt;
  if (branch == nullptr) return best() != nullptr ? std::nullopt : last_resort();
  if (best() != nullptr && hoped_cost(*branch) >= kWorthWhile * best()->cost) return std::nullopt;
  return ShadowConfiguration{branch->candidate.method, branch->size, branch->candidate.scale};
}

std::optional<ShadowConfiguration> ShadowSearch::last_resort() const {
  if (branches_.empty() || task_.size) return std::nullopt;
  const ShadowTrial* const tried = nearest();
  const auto usually_best = std::ranges::min_element(
      branches_, {}, [](const Branch& branch) { return expected_error_factor(branch.candidate.method); });
  const auto method = tried != nullptr ? tried->configuration.method : usually_best->candidate.method;
  for (const Branch& branch : branches_) {
    if (branch.candidate.method != method || branch.fails == branch.candidate.largest) continue;
    return ShadowConfiguration{method, branch.candidate.largest, branch.candidate.scale};
  }
  return std::nullopt;
}

void ShadowSearch::go_on(Branch& branch, double error) const {
  const std::uint32_t tried = branch.size;
  branch.size = 0;
  if (task_.size) return;
  const bool satisfied = error <= task_.budget;
  if (satisfied)
    branch.satisfies = std::min(tried, branch.satisfies.value_or(tried));
  else
    branch.fails = std::max(tried, branch.fails);
  std::uint32_t size = size_for(error * tried, branch.candidate);
  if (branch.satisfies && branch.fails > 0)
    size = rounded_up(std::sqrt(double(branch.fails) * *branch.satisfies), branch.candidate.largest);
  if (size > 0) size = std::max(size, rounded_up(branch.fails + 1.0, branch.candidate.largest));
  if (size <= branch.fails) return;
  if (branch.satisfies && size > kCloseEnough * *branch.satisfies) return;
  branch.size = size;
}

void ShadowSearch::record(const ShadowConfiguration& configuration, double error) {
  trials_.push_back(
      {configuration, error, shadow_cost(configuration.method, configuration.size, task_.receiver_pixels, task_.faces)});
  Branch* const branch = branch_of(configuration);
  if (branch == nullptr) return;
  branch->size = configuration.size;
  go_on(*branch, error);
}

void ShadowSearch::correct(const ShadowConfiguration& configuration, double error) {
  const auto trial = std::ranges::find(trials_, configuration, &ShadowTrial::configuration);
  Branch* const branch = branch_of(configuration);
  if (trial == trials_.end() || branch == nullptr) return;
  trial->error = error;
  branch->satisfies.reset();
  branch->size = configuration.size;
  go_on(*branch, error);
}

ShadowSearch::Branch* ShadowSearch::branch_of(const ShadowConfiguration& configuration) {
  const auto found = std::ranges::find_if(branches_, [&](const Branch& branch) {
    return branch.candidate.method == configuration.method && branch.candidate.scale == configuration.scale;
  });
  return found == branches_.end() ? nullptr : &*found;
}

const ShadowTrial* ShadowSearch::best() const {
  const ShadowTrial* best = nullptr;
  for (const ShadowTrial& trial : trials_) {
    if (trial.error <= task_.budget && (best == nullptr || trial.cost < best->cost)) best = &trial;
  }
  return best;
}

const ShadowTrial* ShadowSearch::nearest() const {
  const auto found = std::ranges::min_element(trials_, {}, &ShadowTrial::error);
  return found == trials_.end() ? nullptr : &*found;
}

}  // namespace plugc

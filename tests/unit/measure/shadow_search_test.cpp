// The search against made-up errors: it must find what trying everything would find, and try little.

#include "runtime/measure/shadow_search.h"

#include <cmath>
#include <functional>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "runtime/measure/shadow_cost.h"

namespace plugc {
namespace {

using Method = PackedShadowMethod;
using ErrorOf = std::function<double(const ShadowConfiguration&)>;

constexpr std::uint32_t kLargest = 8192;

ShadowTask task_of(double budget) {
  ShadowTask task;
  task.budget = budget;
  task.floor_of_texel = 6;  // 0.59 % at 1024
  task.receiver_pixels = 600'000;
  for (const Method method : {Method::hard, Method::bilinear, Method::pcf2, Method::pcf3, Method::sharp3})
    task.candidates.push_back({method, 2, kLargest});
  return task;
}

ShadowSearch run(const ShadowTask& task, const ErrorOf& error_of) {
  ShadowSearch search(task);
  while (const auto configuration = search.next()) search.record(*configuration, error_of(*configuration));
  return search;
}

double cheapest_cost(const ShadowTask& task, const ErrorOf& error_of) {
  double cheapest = INFINITY;
  for (const ShadowCandidate& candidate : task.candidates) {
    for (std::uint32_t size = kSmallestSize; size <= kLargest; size += kSizeStep) {
      if (error_of({candidate.method, size, candidate.scale}) > task.budget) continue;
      cheapest = std::min(cheapest, shadow_cost(candidate.method, size, task.receiver_pixels, 1));
    }
  }
  return cheapest;
}

TEST(ShadowSearch, FindsWhatTryingAllFindsWhateverAMethodIsWorthInAScene) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> factor(0.7, 2.0);
  for (int scene = 0; scene < 200; ++scene) {
    std::map<Method, double> worth;
    for (const ShadowCandidate& candidate : task_of(1).candidates) worth[candidate.method] = factor(random);
    const auto error_of = [&](const ShadowConfiguration& c) {
      return 6 * expected_error_factor(c.method) * worth[c.method] / c.size;
    };
    for (const double budget : {0.0025, 0.005, 0.01, 0.02}) {
      const ShadowTask task = task_of(budget);
      const double cheapest = cheapest_cost(task, error_of);
      const ShadowSearch search = run(task, error_of);
      if (std::isinf(cheapest)) {
        EXPECT_EQ(search.best(), nullptr);
        continue;
      }
      ASSERT_NE(search.best(), nullptr);
      EXPECT_LE(search.best()->error, budget);
      EXPECT_LE(search.best()->cost, 1.3 * cheapest) << "scene " << scene << ", budget " << budget;
      EXPECT_LE(search.trials().size(), 14U);
    }
  }
}

TEST(ShadowSearch, TriesLittleWhereAllIsAsUsual) {
  const auto as_usual = [](const ShadowConfiguration& c) { return 6 * expected_error_factor(c.method) / c.size; };
  const ShadowSearch search = run(task_of(0.005), as_usual);
  ASSERT_NE(search.best(), nullptr);
  EXPECT_LE(search.trials().size(), 3U);
  EXPECT_LE(search.best()->cost, 1.05 * cheapest_cost(task_of(0.005), as_usual));
}

TEST(ShadowSearch, GoesOnToAnotherMethodWhereFeaturesVanishUnderTheKernel) {
  const auto thin = [](const ShadowConfiguration& c) {
    const bool filters = c.method != Method::hard && c.method != Method::bilinear;
    return (filters ? 0.02 : 0) + 6 * expected_error_factor(c.method) / c.size;
  };
  const ShadowSearch search = run(task_of(0.01), thin);
  ASSERT_NE(search.best(), nullptr);
  EXPECT_TRUE(search.best()->configuration.method == Method::hard || search.best()->configuration.method == Method::bilinear);
}

TEST(ShadowSearch, NamesTheNearestWhereNothingReachesTheBudget) {
  const ShadowSearch search = run(task_of(0.001), [](const ShadowConfiguration& c) { return 0.004 + 1.0 / c.size; });
  EXPECT_EQ(search.best(), nullptr);
  ASSERT_NE(search.nearest(), nullptr);
  EXPECT_EQ(search.nearest()->configuration.size, kLargest);
}

TEST(ShadowSearch, WastesNoTrialsOnWhatIsOutOfReach) {
  const ShadowSearch search = run(task_of(1e-6), [](const ShadowConfiguration& c) { return 6.0 / c.size; });
  EXPECT_EQ(search.trials().size(), 1U);
  EXPECT_EQ(search.nearest()->configuration.size, kLargest);
}

TEST(ShadowSearch, EndsWhereErrorsFollowNoRule) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 0.02);
  const ShadowSearch search = run(task_of(0.005), [&](const ShadowConfiguration&) { return any(random); });
  EXPECT_LE(search.trials().size(), 24U);
}

TEST(ShadowSearch, TakesTheSmallestMapWhereNothingIsShadowed) {
  ShadowTask task = task_of(0.005);
  task.floor_of_texel = 0;
  const ShadowSearch search = run(task, [](const ShadowConfiguration&) { return 0.0; });
  ASSERT_NE(search.best(), nullptr);
  EXPECT_EQ(search.best()->configuration, (ShadowConfiguration{Method::hard, kSmallestSize, 2}));
  EXPECT_EQ(search.trials().size(), 1U);
}

TEST(ShadowSearch, KeepsASizeThatIsWritten) {
  ShadowTask task = task_of(0.006);
  task.size = 777;
  const ShadowSearch search =
      run(task, [](const ShadowConfiguration& c) { return 6 * expected_error_factor(c.method) / c.size; });
  ASSERT_NE(search.best(), nullptr);
  for (const ShadowTrial& trial : search.trials()) EXPECT_EQ(trial.configuration.size, 777U);
  EXPECT_GT(search.trials().size(), 1U);
}

TEST(ShadowSearch, GoesOnWhereACloserLookFindsMoreErrors) {
  const ShadowTask task = task_of(0.005);
  ShadowSearch search = run(task, [](const ShadowConfiguration& c) { return 6 * expected_error_factor(c.method) / c.size; });
  const ShadowConfiguration first = search.best()->configuration;
  search.correct(first, 0.0055);
  for (int i = 0; i < 9; ++i) {
    const auto next = search.next();
    if (!next) break;
    search.record(*next, 6.9 * expected_error_factor(next->method) / next->size);
  }
  ASSERT_NE(search.best(), nullptr);
  EXPECT_NE(search.best()->configuration, first);
  EXPECT_LE(search.best()->error, task.budget);
}

TEST(ShadowSearch, HasNothingToMeasureWithoutCandidates) {
  ShadowTask task = task_of(0.005);
  task.candidates.clear();
  const ShadowSearch search(task);
  EXPECT_FALSE(search.next());
  EXPECT_EQ(search.nearest(), nullptr);
}

}  // namespace
}  // namespace plugc

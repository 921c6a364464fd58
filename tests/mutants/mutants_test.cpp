// Of every effect that there is, one token is deleted, repeated or changed at random. The compiler must survive it, say so at
// the mutated effect, and leave all others alone.
//
// PLUGC_MUTANTS=N makes N mutants instead of kMutants; PLUGC_MUTANT=I makes only number I and prints all that is said.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

#include "mutants/judge_mutant.h"
#include "support/compile_text.h"

namespace plugc::mutants {
namespace {

constexpr std::uint32_t kSeed = 1993;  // with it and its number, a mutant is the same everywhere
#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::size_t kMutants = 300;
#else
constexpr std::size_t kMutants = 2000;
#endif
constexpr double kLeastNamed = 0.99;
constexpr std::chrono::seconds kLongest{20};  // for one mutant, on a machine that does other things too

using Clock = std::chrono::steady_clock;

/// What is mutated: an author's code in a scene.
struct Subject {
  const EffectScene* scene = nullptr;
  const CheckedScene* before = nullptr;
  Author author;
  std::vector<Span> places;
};

/// Counts over all mutants, and the numbers of those that break the law.
struct Tally {
  std::size_t mutants = 0, refused = 0, named = 0, placed = 0, exact = 0;
  std::vector<std::string> unnamed, misplaced, outside, lost, uncaused, died, slow;
};

std::optional<std::size_t> number_from(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? std::nullopt : std::optional<std::size_t>(std::strtoull(value, nullptr, 10));
}

class Mutants : public testing::Test {
 protected:
  Mutants() {
    ValidatorOptions options;
    options.cache_folder = folder_.path();  // programs without the mutated effect are judged once
    validator_ = std::make_unique<Validator>(options);
  }

  CheckedScene check(const EffectScene& scene) {
    LayeredFiles files(scene);
    return check_scene(scene, files, *validator_);
  }

  void find_subjects();
  void run(std::size_t number, Tally& tally, bool verbose);

  SceneFolder folder_;
  std::unique_ptr<Validator> validator_;
  std::vector<EffectScene> scenes_ = find_effect_scenes(PLUGC_SOURCE_DIR);
  std::vector<CheckedScene> before_;
  std::vector<Subject> subjects_;
};

/// Authors at whom nothing is wrong, in scenes where nothing is.
void Mutants::find_subjects() {
  before_.reserve(scenes_.size());
  for (const EffectScene& scene : scenes_) {
    const CheckedScene& before = before_.emplace_back(check(scene));
    if (before.diagnostics->has_errors()) continue;
    for (const Author& author : before.authors()) {
      std::vector<Span> places = token_places(before, author);
      if (!places.empty()) subjects_.push_back({&scene, &before, author, std::move(places)});
    }
  }
}

std::string describe(const Subject& subject, std::size_t number, const Mutation& mutation) {
  constexpr std::string_view kKinds[] = {"deleted", "repeated", "changed"};
  const SourceSet& sources = *subject.before->sources;
  const Position at = sources.position(mutation.token.source, mutation.token.begin);
  return fmt::format("{}: {}, `{}` {}:{}: `{}` {}{}", number, subject.scene->name, subject.before->node(subject.author).label,
                     at.line, at.column, sources.text(mutation.token), kKinds[static_cast<std::size_t>(mutation.kind)],
                     mutation.kind == MutationKind::changed ? fmt::format(" to `{}`", mutation.replacement) : "");
}

void add(std::vector<std::string>& list, const std::string& what, const std::vector<std::string>& details) {
  list.push_back(details.empty() ? what : fmt::format("{}\n      {}", what, fmt::join(details, "\n      ")));
}

std::vector<std::string> all_messages(const CheckedScene& scene) {
  std::vector<std::string> lines;
  for (const Diagnostic& said : scene.diagnostics->all())
    lines.push_back(message_line(said, *scene.sources, scene.sources->name({0})));
  return lines;
}

void Mutants::run(std::size_t number, Tally& tally, bool verbose) {
  const Subject& subject = subjects_[number % subjects_.size()];
  std::mt19937 random(kSeed + static_cast<std::uint32_t>(number));
  const Mutation mutation = mutate(*subject.before->sources, subject.places, random);
  LayeredFiles files(*subject.scene);
  files.replace(std::string(subject.before->sources->name(mutation.token.source)), mutation.changed_text);
  const auto start = Clock::now();
  const CheckedScene after = check_scene(*subject.scene, files, *validator_);
  const bool slow = Clock::now() - start > kLongest;
  const Judgement judgement = judge(*subject.before, after, mutation);
  const std::string what = describe(subject, number, mutation);
  const std::vector<std::string> said = all_messages(after);
  ++tally.mutants;
  if (slow) tally.slow.push_back(what);
  if (judgement.died) add(tally.died, what, said);
  if (!judgement.outside.empty()) add(tally.outside, what, said);
  if (!judgement.lost.empty()) add(tally.lost, what, said);
  if (judgement.uncaused) add(tally.uncaused, what, said);
  if (verbose) std::cout << what << "\n" << fmt::format("{}\n", fmt::join(said, "\n"));
  if (!judgement.refused) return;
  ++tally.refused;
  tally.named += judgement.named;
  tally.placed += judgement.placed;
  tally.exact += judgement.exact;
  if (!judgement.named) add(tally.unnamed, what, said);
  if (judgement.named && !judgement.placed) add(tally.misplaced, what, said);
}

std::string shown(const std::vector<std::string>& list) {
  return fmt::format("{} mutants\n  {}", list.size(), fmt::join(list, "\n  "));
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 100 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

TEST_F(Mutants, AreNamedInPlaceAndLeaveOtherEffectsAlone) {
  find_subjects();
  ASSERT_FALSE(subjects_.empty());
  Tally tally;
  if (const auto one = number_from("PLUGC_MUTANT")) return run(*one, tally, true);
  const std::size_t count = number_from("PLUGC_MUTANTS").value_or(kMutants);
  for (std::size_t number = 0; number < count; ++number) run(number, tally, false);
  std::cout << fmt::format(
      "{} mutants of {} effects: {} refused, of these {:.1f} % named, {:.1f} % at the token's line or behind it in its part, "
      "{:.1f} % at its very line\n",
      tally.mutants, subjects_.size(), tally.refused, percent(tally.named, tally.refused), percent(tally.placed, tally.refused),
      percent(tally.exact, tally.refused));
  EXPECT_GE(percent(tally.named, tally.refused), 100 * kLeastNamed) << shown(tally.unnamed);
  EXPECT_GE(percent(tally.placed, tally.refused), 100 * kLeastNamed) << shown(tally.misplaced);
  EXPECT_TRUE(tally.outside.empty()) << "speak of others than the mutated effect: " << shown(tally.outside);
  EXPECT_TRUE(tally.lost.empty()) << "cost other effects: " << shown(tally.lost);
  EXPECT_LE(percent(tally.uncaused.size(), tally.refused), 100 - 100 * kLeastNamed)
      << "leave effects that need the mutated one without a cause: " << shown(tally.uncaused);
  EXPECT_TRUE(tally.died.empty()) << "kill the validating process: " << shown(tally.died);
  EXPECT_TRUE(tally.slow.empty()) << "take too long: " << shown(tally.slow);
}

}  // namespace
}  // namespace plugc::mutants

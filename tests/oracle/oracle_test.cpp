// Composing does what is specified: on many generated effect sets it says and calls what the second composer expects.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "oracle/effect_set.h"
#include "oracle/observe.h"
#include "oracle/specification.h"
#include "support/compile_text.h"

namespace plugc::oracle {
namespace {

// Every second set has planted mistakes.
#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::uint64_t kSets = 1'000, kValidatedSets = 20;
#else
constexpr std::uint64_t kSets = 10'000, kValidatedSets = 500;
#endif

std::string text_of(const Outcome& outcome) {
  std::string text;
  for (const std::string& said : outcome.said) text += "said " + said + "\n";
  for (std::size_t i = 0; i < outcome.programs.size(); ++i) {
    const ProgramTrace& program = outcome.programs[i];
    text += fmt::format("shape {} vertex {}\n", i, fmt::join(program.vertex, " "));
    text += fmt::format("shape {} fragment {}\n", i, fmt::join(program.fragment, " "));
    text += fmt::format("shape {} fills {}\n", i, fmt::join(program.plugs_filled, " "));
  }
  return text;
}

/// The shortest scene on which the two differ.
struct Disagreement {
  std::size_t count = 0;
  std::uint64_t seed = 0;
  std::string scene, expected, observed;
};

void compare_set(std::uint64_t seed, Disagreement& found) {
  EffectSet set = generate_effect_set(seed, seed % 2 == 0);
  const std::string scene = write_scene(set);
  const std::string expected = text_of(expect_outcome(set)), observed = text_of(observe_outcome(scene));
  if (expected == observed || (++found.count > 1 && scene.size() >= found.scene.size())) return;
  found = {found.count, seed, scene, expected, observed};
}

TEST(Oracle, AgreesWithComposeOnGeneratedEffectSets) {
  Disagreement found;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) compare_set(seed, found);
  EXPECT_EQ(found.count, 0U);
  EXPECT_EQ(found.expected, found.observed) << "seed " << found.seed << "\n" << found.scene;
}

TEST(Oracle, FindsNothingInAValidatedProgramThatComposingMissed) {
  for (std::uint64_t seed = 1; seed <= kValidatedSets; ++seed) {
    EffectSet set = generate_effect_set(seed, seed % 2 == 0);
    const std::string scene = write_scene(set);
    EXPECT_EQ(observe_messages(scene), expect_outcome(set).said) << "seed " << seed;
  }
}

}  // namespace
}  // namespace plugc::oracle

#include "runtime/script_machine.h"

#include <random>

#include <gmock/gmock.h>

#include "base/script_limits.h"

namespace plugc::test {
namespace {

using Op = PackedScriptOp;
using testing::ElementsAre;
using testing::IsEmpty;

/// One function of steps, each on the line of its number; variables of one number each.
class OneFunction {
 public:
  OneFunction(std::vector<PackedScriptStep> steps, std::size_t variables = 1) {
    PackedScriptT script;
    script.origin = std::make_unique<PackedLineOrigin>(0, 1);
    script.values.assign(variables, 0.0);
    for (std::size_t i = 0; i < variables; ++i) script.variables.emplace_back(static_cast<std::uint32_t>(i), 1, -1);
    script.functions.emplace_back(-1, kNoSlot, kNoSlot, 0, static_cast<std::uint32_t>(steps.size()));
    script.steps = std::move(steps);
    script.origin = std::make_unique<PackedLineOrigin>(0, 9);
    builder_.Finish(CreatePackedScript(builder_, &script));
    packed_ = flatbuffers::GetRoot<PackedScript>(builder_.GetBufferPointer());
    start_script(*packed_, memory);
  }

  void run() {
    AwakeScript awake{*packed_, memory, work_left};
    run_script_function(awake, *packed_->functions()->Get(0), {}, 0);
    stored = awake.stored;
  }
  /// The first variable takes an event's value.
  void give(const std::vector<double>& value) {
    AwakeScript awake{*packed_, memory, work_left};
    give_script(awake, 0, value);
  }
  /// What the memory says that the variables hold is counted anew.
  std::size_t held() const {
    std::size_t numbers = 0;
    for (const ScriptValue& variable : memory.variables) numbers += variable.size();
    EXPECT_EQ(memory.held, numbers);
    return numbers;
  }

  ScriptMemory memory;
  std::uint64_t work_left = kMaxFrameScriptWork;
  std::set<std::uint32_t> stored;

 private:
  flatbuffers::FlatBufferBuilder builder_;
  const PackedScript* packed_ = nullptr;
};

std::string message_of(std::vector<PackedScriptStep> steps) {
  OneFunction function(std::move(steps));
  function.run();
  EXPECT_EQ(function.memory.stopped, !function.memory.message.empty());
  return function.memory.message;
}

TEST(ScriptMachine, StopsALoopWithoutEnd) {
  OneFunction function({{0, 1, Op::jump}});
  function.run();
  EXPECT_EQ(function.memory.message, "line 1: the script is stopped: it goes on without end");
  EXPECT_TRUE(function.memory.stopped);
}

TEST(ScriptMachine, BoundsItsStackAndItsLists) {
  EXPECT_EQ(message_of({{0, 1, Op::load}, {0, 2, Op::jump}}), "line 1: the script is stopped: it goes on without end");
  OneFunction hoard({{0, 1, Op::load}, {0, 1, Op::load}, {1, 1, Op::resize}, {1, 2, Op::store}, {2, 3, Op::store}}, 3);
  hoard.give({600'000});
  hoard.run();
  EXPECT_EQ(hoard.memory.message, "line 3: the script is stopped: its variables would hold more than 1000000 numbers");
  EXPECT_THAT(hoard.stored, ElementsAre(1));
}

TEST(ScriptMachine, NeverRunsAgainWhatItHasStopped) {
  OneFunction function({{0, 1, Op::random}, {0, 2, Op::store}, {0, 3, Op::drop}, {0, 4, Op::drop}});
  function.run();
  EXPECT_EQ(function.memory.message, "line 4: the script is stopped: its code is damaged: a value is missing");
  EXPECT_THAT(function.stored, ElementsAre(0)) << "what was stored before stays";
  function.run();
  EXPECT_THAT(function.stored, IsEmpty());
}

TEST(ScriptMachine, StopsWhoWantsMoreThanIsLeftOfAFrame) {
  OneFunction function({{0, 1, Op::load}, {0, 2, Op::drop}});
  function.work_left = 5;
  function.run();
  EXPECT_EQ(function.work_left, 3U);
  function.run();
  EXPECT_FALSE(function.memory.stopped);
  function.run();
  EXPECT_EQ(function.memory.message,
            "line 1: the script is stopped: the scripts of the scene do more between two frames than may be done");
  EXPECT_EQ(function.work_left, 1U);
}

TEST(ScriptMachine, CountsWhatEventsBring) {
  OneFunction function({{0, 1, Op::load}, {0, 2, Op::drop}});
  function.work_left = 5;
  function.give({1, 2, 3});
  EXPECT_EQ(function.work_left, 1U);
  function.give({1, 2, 3});
  EXPECT_EQ(function.memory.message,
            "line 9: the script is stopped: the scripts of the scene do more between two frames than may be done");
}

TEST(ScriptMachine, KeepsTheFirstThingToBeSaid) {
  OneFunction function({{0, 1, Op::drop}});
  function.memory.message = "line 7: something else";
  function.run();
  EXPECT_TRUE(function.memory.stopped);
  EXPECT_EQ(function.memory.message, "line 7: something else");
}

TEST(ScriptMachine, SaysWhatHasNoResult) {
  EXPECT_EQ(message_of({{0, 7, Op::load}, {0, 7, Op::load}, {1, 7, Op::modulo}}),
            "line 7: the script is stopped: it divides by zero");
  EXPECT_EQ(message_of({{0, 7, Op::load}, {0, 7, Op::load}, {2, 7, Op::element}}),
            "line 7: the script is stopped: it asks for element 0 of 0, counted from 0");
  EXPECT_EQ(message_of({{0, 7, Op::load}, {0, 7, Op::random_below}}),
            "line 7: the script is stopped: there is no random integer below 0");
  EXPECT_EQ(message_of({{0, 7, Op::load}, {0, 7, Op::load}, {0, 7, Op::cross}}),
            "line 7: the script is stopped: its code is damaged: values do not fit together");
}

TEST(ScriptMachine, PlaysTheSameRandomNumbersEachTime) {
  OneFunction first({{0, 1, Op::random}, {0, 1, Op::store}}), second({{0, 1, Op::random}, {0, 1, Op::store}});
  first.run();
  second.run();
  EXPECT_EQ(first.memory.variables, second.memory.variables);
  const double number = first.memory.variables[0][0];
  EXPECT_TRUE(number >= 0 && number < 1) << number;
  first.run();
  EXPECT_NE(first.memory.variables[0][0], number);
}

/// What open_package() lets through is any list of steps. Some of them run to their end, most have a fault; none holds more
/// than it may.
TEST(ScriptMachine, TakesAnyCode) {
  std::mt19937 random(7);
  constexpr std::uint32_t kVariables = 4;
  int stopped = 0, ended = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<PackedScriptStep> steps;
    for (std::uint32_t line = 1; line <= 40; ++line) {
      const auto op = line % 3 == 0 ? static_cast<Op>(random() % (static_cast<std::uint32_t>(Op::MAX) + 1)) : Op::load;
      const bool names_variable = op == Op::load || op == Op::store;
      steps.emplace_back(names_variable ? random() % kVariables : random() % 5, line, op);
    }
    OneFunction function(std::move(steps), kVariables);
    function.memory.variables = {{1, 2, 3, 4}, {5, 6, 7}, {2}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    function.memory.held = 17;
    function.run();
    EXPECT_EQ(function.memory.stopped, !function.memory.message.empty());
    EXPECT_LE(function.held(), kMaxScriptNumbers);
    EXPECT_GE(function.work_left, kMaxFrameScriptWork - kMaxScriptWork);
    (function.memory.stopped ? stopped : ended) += 1;
  }
  EXPECT_GT(stopped, 0);
  EXPECT_GT(ended, 0);
}

}  // namespace
}  // namespace plugc::test

#include "runtime/time_sensor.h"

#include <cmath>

#include <gtest/gtest.h>

namespace plugc {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

TimeSensorFields looping(double cycle_interval) {
  TimeSensorFields fields;
  fields.loop = true;
  fields.cycle_interval = cycle_interval;
  return fields;
}

TimeSensorFields once(double start, double cycle_interval) {
  TimeSensorFields fields;
  fields.start_time = start;
  fields.cycle_interval = cycle_interval;
  return fields;
}

TEST(TimeSensor, ALoopRunsFromTheBeginning) {
  const TimeSensorFields fields = looping(4);
  TimeSensorState state;
  TimeSensorEvents events = tick(fields, state, 0);
  EXPECT_EQ(events.is_active, true);
  EXPECT_EQ(events.fraction, 0);
  EXPECT_EQ(events.cycle_time, 0);
  events = tick(fields, state, 3);
  EXPECT_FALSE(events.is_active.has_value());
  EXPECT_EQ(events.fraction, 0.75);
  EXPECT_EQ(events.elapsed_time, 3);
  EXPECT_EQ(events.time, 3);
  EXPECT_FALSE(events.cycle_time.has_value());
}

TEST(TimeSensor, ACycleEndsAtOneAndTheNextBeginsBehindIt) {
  const TimeSensorFields fields = looping(4);
  TimeSensorState state;
  tick(fields, state, 0);
  TimeSensorEvents events = tick(fields, state, 4);
  EXPECT_EQ(events.fraction, 1);
  EXPECT_EQ(events.cycle_time, 4);
  events = tick(fields, state, 9);
  EXPECT_EQ(events.fraction, 0.25);
  EXPECT_EQ(events.elapsed_time, 9);
}

TEST(TimeSensor, WithoutALoopItRunsOnceFromItsStartTime) {
  const TimeSensorFields fields = once(2, 4);
  TimeSensorState state;
  EXPECT_FALSE(tick(fields, state, 0).is_active.has_value());
  EXPECT_EQ(next_moment(fields, state, 0, false), 2);
  EXPECT_EQ(tick(fields, state, 2).is_active, true);
  EXPECT_EQ(next_moment(fields, state, 2, false), 6);
  const TimeSensorEvents last = tick(fields, state, 6);
  EXPECT_EQ(last.fraction, 1);
  EXPECT_EQ(last.is_active, false);
  EXPECT_FALSE(tick(fields, state, 7).is_active.has_value());
  EXPECT_EQ(next_moment(fields, state, 7, false), kNever);
}

TEST(TimeSensor, WhatIsOverBeforeItWasSeenDoesNotRun) {
  TimeSensorState state;
  EXPECT_FALSE(tick(once(2, 4), state, 6).is_active.has_value());
}

TEST(TimeSensor, TheDefaultStartTimeWaitsForAnEvent) {
  TimeSensorFields fields = once(0, 4);
  TimeSensorState state;
  EXPECT_FALSE(tick(fields, state, 0).is_active.has_value());
  fields.start_sent = true;
  EXPECT_EQ(tick(fields, state, 0).is_active, true);
}

TEST(TimeSensor, StopsAtItsStopTimeUnlessThatLiesInFrontOfTheStart) {
  TimeSensorFields fields = looping(4);
  fields.start_time = 1;
  fields.stop_time = 3;
  TimeSensorState state;
  tick(fields, state, 1);
  EXPECT_EQ(next_moment(fields, state, 1, false), 3);
  const TimeSensorEvents last = tick(fields, state, 3);
  EXPECT_EQ(last.is_active, false);
  EXPECT_EQ(last.fraction, 0.5);
  EXPECT_FALSE(tick(fields, state, 4).is_active.has_value());

  fields.stop_time = 1;
  state = {};
  tick(fields, state, 1);
  EXPECT_FALSE(tick(fields, state, 8).is_active.has_value());
}

TEST(TimeSensor, LosesNoTimeWhilePaused) {
  TimeSensorFields fields = looping(10);
  fields.pause_time = 3;
  fields.resume_time = 5;
  TimeSensorState state;
  tick(fields, state, 0);
  EXPECT_EQ(next_moment(fields, state, 0, false), 3);
  EXPECT_EQ(tick(fields, state, 3).is_paused, true);
  EXPECT_FALSE(tick(fields, state, 4).fraction.has_value());
  EXPECT_EQ(next_moment(fields, state, 4, false), 5);
  const TimeSensorEvents resumed = tick(fields, state, 5);
  EXPECT_EQ(resumed.is_paused, false);
  EXPECT_EQ(resumed.elapsed_time, 3);
  EXPECT_EQ(tick(fields, state, 8).elapsed_time, 6);
}

TEST(TimeSensor, DisabledItStopsAtOnce) {
  TimeSensorFields fields = looping(4);
  TimeSensorState state;
  tick(fields, state, 0);
  fields.enabled = false;
  EXPECT_EQ(tick(fields, state, 1).is_active, false);
  EXPECT_FALSE(tick(fields, state, 2).is_active.has_value());
}

TEST(TimeSensor, EndsItsCycleWhenItNoLongerLoops) {
  TimeSensorFields fields = looping(4);
  TimeSensorState state;
  tick(fields, state, 0);
  tick(fields, state, 5);
  fields.loop = false;
  EXPECT_FALSE(tick(fields, state, 6).is_active.has_value());
  EXPECT_EQ(next_moment(fields, state, 6, false), 8);
  EXPECT_EQ(tick(fields, state, 8).is_active, false);
}

TEST(TimeSensor, TakesNoStartTimeWhileItRuns) {
  TimeSensorFields fields = once(1, 4);
  TimeSensorState state;
  tick(fields, state, 1);
  fields.start_time = 3;
  fields.start_sent = true;
  EXPECT_EQ(tick(fields, state, 3).elapsed_time, 2);
  fields.start_sent = false;
  EXPECT_EQ(tick(fields, state, 5).is_active, false);
  EXPECT_FALSE(tick(fields, state, 6).is_active.has_value());
  fields.start_time = 6.5;
  EXPECT_EQ(tick(fields, state, 6.5).is_active, true);
}

TEST(TimeSensor, NeverRunsWithoutACycle) {
  for (const double interval : {0.0, -1.0, std::nan("")}) {
    TimeSensorState state;
    EXPECT_FALSE(tick(looping(interval), state, 1).is_active.has_value()) << interval;
    EXPECT_EQ(next_moment(looping(interval), state, 1, true), kNever) << interval;
  }
}

}  // namespace
}  // namespace plugc

#include "runtime/time_sensor.h"

#include <algorithm>
#include <cmath>

namespace plugc {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Seconds that a sum of times may be too small by.
constexpr double kRounding = 1e-9;

/// A stopTime before the startTime says nothing.
bool is_stopped(const TimeSensorFields& fields, double start, double now) {
  return fields.stop_time > start && now >= fields.stop_time;
}

/// A sensor that does not loop runs once from its startTime on. A default of 0 is no such time: the scene was loaded at 0.
bool may_start(const TimeSensorFields& fields, const TimeSensorState& state, double now) {
  const double start = fields.start_time;
  if (!fields.enabled || !(fields.cycle_interval > 0) || !(now >= start) || start == state.refused_start) return false;
  if (is_stopped(fields, start, now)) return false;
  return fields.loop || ((start > 0 || fields.start_sent) && now < start + fields.cycle_interval);
}

/// Without its pauses.
double elapsed(const TimeSensorState& state, double now) {
  return now - state.start - state.paused_for;
}

void update_pause(const TimeSensorFields& fields, TimeSensorState& state, double now, TimeSensorEvents& events) {
  const bool resumes = fields.resume_time > fields.pause_time && now >= fields.resume_time;
  if (!state.paused && fields.pause_time > std::max(state.start, 0.0) && now >= fields.pause_time && !resumes) {
    state.paused = true;
    state.paused_since = now;
    events.is_paused = true;
  } else if (state.paused && resumes) {
    state.paused = false;
    state.paused_for += now - state.paused_since;
    events.is_paused = false;
  }
}

/// fraction_changed is 1 at the end of a cycle, not 0, which only the first one begins with.
double fraction_of(const TimeSensorState& state, double seconds, bool ends) {
  const double cycles = seconds / state.interval;
  const double fraction = cycles - std::floor(cycles);
  return ends || (fraction == 0 && seconds > 0) ? 1 : fraction;
}

void run(const TimeSensorFields& fields, TimeSensorState& state, double now, TimeSensorEvents& events) {
  const double seconds = elapsed(state, now);
  const bool last_cycle_over = !fields.loop && seconds + kRounding >= (state.cycles + 1) * state.interval;
  const bool stops = last_cycle_over || !fields.enabled || is_stopped(fields, state.start, now);
  events.fraction = fraction_of(state, seconds, last_cycle_over);
  events.elapsed_time = seconds;
  events.time = now;
  const double whole = std::floor((seconds + kRounding) / state.interval);
  if (fields.loop && whole > state.cycles) {
    state.cycles = whole;
    events.cycle_time = now;
  }
  if (!stops) return;
  state.active = false;
  events.is_active = false;
}

void start(const TimeSensorFields& fields, TimeSensorState& state, double now, TimeSensorEvents& events) {
  const double refused = state.refused_start;
  state = {};
  state.active = true;
  state.start = fields.start_time;
  state.interval = fields.cycle_interval;
  state.refused_start = refused;
  state.cycles = fields.loop ? std::floor(elapsed(state, now) / state.interval) : 0;
  events.is_active = true;
  events.cycle_time = now;
}

}  // namespace

TimeSensorEvents tick(const TimeSensorFields& fields, TimeSensorState& state, double now) {
  TimeSensorEvents events;
  if (!state.active) {
    if (!may_start(fields, state, now)) return events;
    start(fields, state, now, events);
  } else if (fields.start_time != state.start) {
    state.refused_start = fields.start_time;
  }
  const bool was_paused = state.paused;
  update_pause(fields, state, now, events);
  if (state.paused && was_paused) {
    if (fields.enabled && !is_stopped(fields, state.start, now)) return events;
    state.active = state.paused = false;
    events.is_paused = events.is_active = false;
    return events;
  }
  run(fields, state, now, events);
  return events;
}

double next_moment(const TimeSensorFields& fields, const TimeSensorState& state, double now, bool cycles_count) {
  double next = kNever;
  const auto consider = [&](double moment) {
    if (moment > now) next = std::min(next, moment);
  };
  if (!state.active) {
    if (fields.enabled && fields.cycle_interval > 0 && fields.start_time != state.refused_start) consider(fields.start_time);
    return next;
  }
  if (fields.stop_time > state.start) consider(fields.stop_time);
  if (state.paused) {
    if (fields.resume_time > fields.pause_time) consider(fields.resume_time);
    return next;
  }
  if (fields.pause_time > std::max(state.start, 0.0)) consider(fields.pause_time);
  if (!fields.loop || cycles_count) consider(state.start + state.paused_for + (state.cycles + 1) * state.interval);
  return next;
}

}  // namespace plugc

#pragma once
// A clock of the scene: X3D 4.1, clauses 8.2.4 and 8.4.1. Seconds count from when the scene was loaded.

#include <limits>
#include <optional>

namespace plugc {

/// The fields of a TimeSensor as they are now.
struct TimeSensorFields {
  bool enabled = true, loop = false;
  double cycle_interval = 1;
  double start_time = 0, stop_time = 0, pause_time = 0, resume_time = 0;
  bool start_sent = false;  ///< An event sets start_time at this moment.
};

/// What a TimeSensor remembers.
struct TimeSensorState {
  bool active = false, paused = false;
  double start = 0, interval = 1;  ///< While it is active: those that it began with; later events cannot change them.
  double paused_since = 0;         ///< While it is paused.
  double paused_for = 0;           ///< Seconds of its pauses that are over.
  double cycles = 0;               ///< Whole cycles so far.
  /// A startTime that came while the sensor was active, and so never counts.
  double refused_start = std::numeric_limits<double>::quiet_NaN();
};

struct TimeSensorEvents {
  std::optional<bool> is_active, is_paused;
  std::optional<double> fraction, elapsed_time, time, cycle_time;
};

/// What happens at `now`; times never go back.
TimeSensorEvents tick(const TimeSensorFields& fields, TimeSensorState& state, double now);

/// When the sensor will next start, stop, pause or resume by itself, or begin a cycle if `cycles_count`; infinity: never.
double next_moment(const TimeSensorFields& fields, const TimeSensorState& state, double now, bool cycles_count);

}  // namespace plugc

#pragma once
// The child process that judges, and its replacement when it dies.

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/stage.h"
#include "validate/socket.h"

namespace plugc {

/// Forks once, when it is made; whatever is forked later is forked by that child. So the owner may start threads after
/// it is made. Not to be used by two threads at a time. Leaves no process behind, however the owner ends.
class Worker {
 public:
  /// The worker warms glslang up for these targets when it starts.
  explicit Worker(const std::vector<Target>& warm_targets);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Lets the worker start while the owner does something else; else it starts when it is first asked. Costs a processor
  /// for some 25 ms, so it is not for owners who may never ask.
  void start();

  enum class Outcome { answered, crashed, late, unavailable };
  struct Reply {
    Outcome outcome = Outcome::unavailable;
    std::string verdict;  ///< Encoded; when answered.
  };
  /// One candidate, encoded. The time does not count the start of the worker. After any outcome the next call works.
  Reply ask(std::string_view candidate, std::chrono::milliseconds timeout);

 private:
  bool connect();
  void replace();
  Reply ask_once(std::string_view candidate, std::chrono::milliseconds timeout);

  Descriptor spawner_;  // where fresh workers come from
  pid_t spawner_id_ = -1;
  Descriptor worker_;      // not valid before it has greeted
  bool awaiting_ = false;  // a fresh one is on its way
  bool used_ = false;      // the worker has judged something before
};

}  // namespace plugc

// The owner's side. Two kinds of child: the spawner, forked here while the owner is still single-threaded, stays small and
// clean and does nothing but fork workers; a worker warms glslang up, says so, and judges.
//
//     owner --"another"--> spawner --fork--> worker
//       ^------------- its socket ----------/          then   owner <--candidate, verdict--> worker
//
// When a worker dies or is late, the owner asks for another at once, so that it warms up while the owner goes on. A verdict
// must not depend on what was judged before: a candidate at which a used worker crashed gets a second chance in a fresh
// one. The owner's end of the spawner's socket is its life line: the spawner goes, with its worker, when that closes.

#include "validate/worker.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "validate/worker_process.h"

namespace plugc {
namespace {

/// Far more than a start takes even under a debugger; a machine on which it takes longer has other troubles.
constexpr std::chrono::seconds kStartTime{30};

Deadline after(std::chrono::milliseconds time) {
  return std::chrono::steady_clock::now() + time;
}

}  // namespace

Worker::Worker(const std::vector<Target>& warm_targets) {
  auto [own, theirs] = make_socket_pair();
  if (!own.valid()) return;
  spawner_id_ = fork();
  if (spawner_id_ == 0) run_spawner(std::move(theirs), warm_targets);
  if (spawner_id_ > 0) spawner_ = std::move(own);
}

Worker::~Worker() {
  if (spawner_id_ <= 0) return;
  worker_ = Descriptor();
  // Another child of the owner may hold a copy of this end: closing it alone would not be noticed.
  shutdown(spawner_.get(), SHUT_RDWR);
  while (waitpid(spawner_id_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Worker::start() {
  if (!worker_.valid() && !awaiting_) replace();
}

/// Waits for the fresh worker and its word that it is warm.
bool Worker::connect() {
  if (worker_.valid()) return true;
  if (!spawner_.valid()) return false;
  start();
  const Deadline deadline = after(kStartTime);
  worker_ = receive_descriptor(spawner_, deadline);
  awaiting_ = false;
  std::string greeting;
  if (worker_.valid() && receive_message(worker_, greeting, deadline) == Transfer::done) return true;
  worker_ = Descriptor();
  return false;
}

void Worker::replace() {
  worker_ = Descriptor();
  used_ = false;
  awaiting_ = send(spawner_.get(), "+", 1, MSG_NOSIGNAL) == 1;
}

Worker::Reply Worker::ask_once(std::string_view candidate, std::chrono::milliseconds timeout) {
  if (!connect()) return {Outcome::unavailable, {}};
  const Deadline deadline = after(timeout);
  Reply reply;
  Transfer transfer = send_message(worker_, candidate, deadline);
  if (transfer == Transfer::done) transfer = receive_message(worker_, reply.verdict, deadline);
  reply.outcome = transfer == Transfer::done   ? Outcome::answered
                  : transfer == Transfer::late ? Outcome::late
                                               : Outcome::crashed;
  if (transfer != Transfer::done) replace();
  return reply;
}

Worker::Reply Worker::ask(std::string_view candidate, std::chrono::milliseconds timeout) {
  const bool was_used = used_;
  Reply reply = ask_once(candidate, timeout);
  if (reply.outcome == Outcome::crashed && was_used) reply = ask_once(candidate, timeout);
  if (reply.outcome == Outcome::answered) used_ = true;
  return reply;
}

}  // namespace plugc

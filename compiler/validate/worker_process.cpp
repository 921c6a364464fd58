// Both children start as copies of the owner and first drop what they got with it: open files (a held pipe would keep its
// reader waiting), signal handlers and blocked signals, core dumps. They leave through _exit(), as the owner's atexit
// handlers and buffered output are not theirs.
// The worker then limits itself: memory to kMemory above what it starts with, processor time for each candidate as a last
// resort should nobody be left to kill it. A sanitizer reserves terabytes of addresses, so memory is not limited there.

#include "validate/worker_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

#include "validate/judge.h"

namespace plugc {
namespace {

constexpr rlim_t kMemory = rlim_t{2} << 30;
constexpr rlim_t kProcessorSeconds = 120;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Keeps only `kept`, and /dev/null as input and output; a sanitizer keeps stderr for its report.
Descriptor drop_descriptors(Descriptor kept) {
  constexpr int kPlace = 3;
  if (kept.get() != kPlace) kept = Descriptor(dup2(kept.get(), kPlace));
  close_range(kPlace + 1, ~0U, 0);
  const int null = open("/dev/null", O_RDWR);
  for (int standard = STDIN_FILENO; null >= 0 && standard <= (kIsSanitized ? STDOUT_FILENO : STDERR_FILENO); ++standard) {
    dup2(null, standard);
  }
  if (null > kPlace) close(null);
  return kept;
}

void reset_signals() {
  for (const int signal_number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGCHLD, SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU}) {
    signal(signal_number, SIG_DFL);
  }
  if (!kIsSanitized) {
    for (const int signal_number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) signal(signal_number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void lower_limit(__rlimit_resource_t resource, rlim_t value) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY || value < limit.rlim_max ? value : limit.rlim_max;
  setrlimit(resource, &limit);
}

/// The size of this process's address space now, or 0.
rlim_t address_space_in_use() {
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  unsigned long pages = 0;
  const bool read = std::fscanf(file, "%lu", &pages) == 1;
  std::fclose(file);
  return read ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit_memory() {
  const rlim_t used = address_space_in_use();
  if (!kIsSanitized && used != 0) lower_limit(RLIMIT_AS, used + kMemory);
}

/// The limit counts from the start of the process, so it moves on with each candidate.
void limit_time_for_next_candidate() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  lower_limit(RLIMIT_CPU, static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + kProcessorSeconds);
}

/// Kills the worker and takes its exit status, so that it leaves no zombie.
void end_worker(pid_t worker) {
  if (worker <= 0) return;
  kill(worker, SIGKILL);
  while (waitpid(worker, nullptr, 0) < 0 && errno == EINTR) {
  }
}

/// Forks a worker and tells the owner where to reach it; the worker's id, or -1.
pid_t start_worker(Descriptor& owner, const std::vector<Target>& warm_targets) {
  auto [for_owner, for_worker] = make_socket_pair();
  const pid_t spawner = getpid();
  const pid_t worker = for_worker.valid() ? fork() : -1;
  if (worker == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != spawner) _exit(0);  // it went before the line above
    owner = Descriptor();
    for_owner = Descriptor();
    run_worker(drop_descriptors(std::move(for_worker)), warm_targets);
  }
  if (worker < 0) for_owner = Descriptor();
  send_descriptor(owner, for_owner);
  return worker;
}

/// The owner's next byte; false when it has gone.
bool wait_for_owner(const Descriptor& owner) {
  char byte = 0;
  ssize_t count = 0;
  do {
    count = recv(owner.get(), &byte, 1, 0);
  } while (count < 0 && errno == EINTR);
  return count == 1;
}

}  // namespace

void run_spawner(Descriptor owner, const std::vector<Target>& warm_targets) {
  prctl(PR_SET_NAME, "plugc-spawner");
  owner = drop_descriptors(std::move(owner));
  reset_signals();
  lower_limit(RLIMIT_CORE, 0);
  pid_t worker = -1;
  while (wait_for_owner(owner)) {
    end_worker(worker);
    worker = start_worker(owner, warm_targets);
  }
  end_worker(worker);
  _exit(0);
}

void run_worker(Descriptor owner, const std::vector<Target>& warm_targets) {
  prctl(PR_SET_NAME, "plugc-validator");
  limit_memory();
  for (const Target target : warm_targets) warm_up(target);
  if (send_message(owner, {}, kNoDeadline) != Transfer::done) _exit(0);
  std::string request;
  while (true) {
    limit_time_for_next_candidate();
    if (receive_message(owner, request, kNoDeadline) != Transfer::done) break;
    const std::optional<Candidate> candidate = decode_candidate(request);
    if (!candidate || send_message(owner, encode(judge(*candidate)), kNoDeadline) != Transfer::done) break;
  }
  _exit(0);
}

}  // namespace plugc

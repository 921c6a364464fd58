#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include "tests/unit/validate/programs.h"
#include "validate/judge.h"

namespace plugc {
namespace {

using std::chrono::milliseconds;

/// Of this process's children and theirs.
std::set<pid_t> descendants(pid_t parent) {
  std::set<pid_t> found;
  std::ifstream list(fmt::format("/proc/{0}/task/{0}/children", parent));
  for (pid_t child = 0; list >> child;) {
    found.insert(child);
    found.merge(descendants(child));
  }
  return found;
}

ValidatorOptions short_options() {
  ValidatorOptions options;
  options.timeout = milliseconds(1000);
  return options;
}

TEST(Worker, ACrashCostsOnlyItsProgram) {
  std::vector<ProgramText> programs;
  programs.push_back(plain_program());
  programs.push_back(crashing_program());
  programs.push_back(plain_program("a;"));
  programs.push_back(good_program());
  Validator validator({});
  const std::vector<ValidationResult> results = validator.validate(std::move(programs));
  EXPECT_TRUE(results[0].program.has_value());
  EXPECT_FALSE(results[1].program.has_value());
  EXPECT_TRUE(results[1].died);
  EXPECT_EQ(results[1].messages.front().text, "glslang crashed on this program");
  EXPECT_FALSE(results[2].died);
  EXPECT_EQ(results[2].messages.front().text, "`a`: undeclared identifier");
  EXPECT_TRUE(results[3].program.has_value());
}

TEST(Worker, AnEndlessProgramIsEndedInTime) {
  Validator validator(short_options());
  std::vector<ProgramText> programs;
  programs.push_back(endless_program());
  programs.push_back(good_program());
  const auto start = std::chrono::steady_clock::now();
  const std::vector<ValidationResult> results = validator.validate(std::move(programs));
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(20'000));
  EXPECT_TRUE(results[0].died);
  EXPECT_EQ(results[0].messages.front().text, "glslang took longer than 1000 ms on this program");
  EXPECT_TRUE(results[1].program.has_value());
}

TEST(Worker, AMemoryBombIsEndedByAnyLimit) {
  Validator validator(short_options());
  EXPECT_TRUE(validate_one(validator, memory_bomb()).died);
  EXPECT_TRUE(validate_one(validator, good_program()).program.has_value());
}

TEST(Worker, IsReplacedWhileThreadsRun) {
  Validator validator({});
  std::atomic<bool> stop = false;
  std::thread busy([&] {
    while (!stop) delete new std::string(1000, 'x');
  });
  EXPECT_TRUE(validate_one(validator, crashing_program()).died);
  EXPECT_TRUE(validate_one(validator, good_program()).program.has_value());
  stop = true;
  busy.join();
}

TEST(Worker, LeavesNoProcessBehind) {
  const std::set<pid_t> before = descendants(getpid());
  {
    Validator validator(short_options());
    EXPECT_TRUE(validate_one(validator, crashing_program()).died);
    EXPECT_TRUE(validate_one(validator, good_program()).program.has_value());
    EXPECT_EQ(descendants(getpid()).size(), before.size() + 2);
    Validator moved(std::move(validator));
    EXPECT_TRUE(validate_one(moved, good_program()).program.has_value());
  }
  EXPECT_EQ(descendants(getpid()), before);
}

TEST(Worker, GoesWhenItsOwnerIsKilled) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t owner = fork();
  if (owner == 0) {
    Validator validator({});
    const bool good = validate_one(validator, good_program()).program.has_value();
    const std::set<pid_t> processes = descendants(getpid());
    for (const pid_t process : processes) {
      if (write(ends[1], &process, sizeof process) != sizeof process) _exit(1);
    }
    kill(getpid(), good ? SIGKILL : SIGTERM);
  }
  close(ends[1]);
  int status = 0;
  ASSERT_EQ(waitpid(owner, &status, 0), owner);
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
  std::set<pid_t> processes;
  // The pipe ends only when no process holds its other end: the children have dropped it.
  for (pid_t process = 0; read(ends[0], &process, sizeof process) == sizeof process;) processes.insert(process);
  close(ends[0]);
  EXPECT_EQ(processes.size(), 2u);
  const auto is_alive = [](pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    std::string text;
    std::getline(file, text);
    const std::size_t state = text.rfind(") ");
    return state != std::string::npos && text[state + 2] != 'Z';
  };
  for (int i = 0; i < 500 && std::ranges::any_of(processes, is_alive); ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(std::ranges::none_of(processes, is_alive));
}

TEST(Worker, TwoLiveSideBySide) {
  Validator first({});
  auto second = std::make_unique<Validator>(ValidatorOptions{});
  EXPECT_TRUE(validate_one(*second, good_program()).program.has_value());
  EXPECT_TRUE(validate_one(first, good_program()).program.has_value());
  second.reset();
  EXPECT_TRUE(validate_one(first, plain_program()).program.has_value());
}

TEST(Worker, AnswersAsJudgingHereDoes) {
  Validator validator({});
  for (const ProgramText& program : {good_program(), program_of(kVertex, kFragment, Target::spirv)}) {
    const Verdict here = judge(*decode_candidate(encode(program)));
    const ValidationResult there = validate_one(validator, program);
    ASSERT_TRUE(there.program.has_value());
    EXPECT_EQ(shown(there.program->uniforms()), shown(here.uniforms));
    EXPECT_EQ(there.program->spirv(), here.spirv);
  }
}

}  // namespace
}  // namespace plugc

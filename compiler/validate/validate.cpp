// Each program is encoded, which makes equal programs equal strings; each different string is judged once: by the cache, or
// else by the worker, whose valid verdicts go to the cache. Then every program gets its result: its own texts with the
// verdict's facts, or the verdict's messages placed in its own texts, as equal texts may come from different authors.
// The workers start early where the cache is empty, as they will be asked for certain; else at the first miss. Of several
// workers each is asked by a thread of its own, which takes the next string that nobody has taken.

#include "validate/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <thread>

#include "base/check.h"
#include "base/limits.h"
#include "validate/place_message.h"
#include "validate/verdict_cache.h"
#include "validate/worker.h"

namespace plugc {
namespace {

/// A verdict, or the worker's death. `messages` is not empty when it died.
struct Judgement {
  Verdict verdict;
  bool died = false;
};

void check_stages(const ProgramText& program) {
  for (std::size_t i = 1; i < program.stages.size(); ++i) {
    PLUGC_CHECK(program.stages[i - 1].stage < program.stages[i].stage, "stages are each there once, in pipeline order");
  }
}

/// The message for a stage that is not given to glslang at all.
std::optional<Judgement> too_large(const ProgramText& program) {
  for (const StageText& stage : program.stages) {
    if (stage.text.size() <= kMaxStageBytes) continue;
    Judgement judgement;
    judgement.verdict.messages.push_back(
        {stage.stage, 0, {}, fmt::format("the text has {} bytes, plugc takes {}", stage.text.size(), kMaxStageBytes)});
    return judgement;
  }
  return std::nullopt;
}

Judgement death(const ProgramText& program, std::string text) {
  Judgement judgement;
  judgement.died = true;
  const ShaderStage stage = program.stages.empty() ? ShaderStage::vertex : program.stages.front().stage;
  judgement.verdict.messages.push_back({stage, 0, {}, std::move(text)});
  return judgement;
}

}  // namespace

/// A program that is judged, and its encoded texts.
struct Question {
  const ProgramText* program = nullptr;
  const std::string* candidate = nullptr;
  Judgement judgement;
};

struct Validator::State {
  explicit State(ValidatorOptions given) : options(std::move(given)), cache(options.cache_folder) {
    for (std::size_t i = 0; i < std::max<std::size_t>(options.workers, 1); ++i)
      workers.push_back(std::make_unique<Worker>(options.warm_targets));
    if (!cache.empty()) return;
    for (const auto& worker : workers) worker->start();
  }

  Judgement ask(Worker& worker, const ProgramText& program, const std::string& candidate) const;
  Judgement judge(Worker& worker, const ProgramText& program, const std::string& candidate) const;
  Judgement judge_unoptimized(Worker& worker, ProgramText program, const std::string& reason) const;
  void judge_all(std::vector<Question>& questions);
  static ValidationResult result(ProgramText program, const Judgement& judgement);

  ValidatorOptions options;
  VerdictCache cache;
  std::vector<std::unique_ptr<Worker>> workers;
};

Judgement Validator::State::ask(Worker& worker, const ProgramText& program, const std::string& candidate) const {
  const Worker::Reply reply = worker.ask(candidate, options.timeout);
  switch (reply.outcome) {
    case Worker::Outcome::answered:
      if (std::optional<Verdict> verdict = decode_verdict(reply.verdict)) return {std::move(*verdict), false};
      return death(program, "glslang's process answered with nonsense");
    case Worker::Outcome::crashed: return death(program, "glslang crashed on this program");
    case Worker::Outcome::late:
      return death(program, fmt::format("glslang took longer than {} ms on this program", options.timeout.count()));
    case Worker::Outcome::unavailable: return death(program, "no process for glslang can be started");
  }
  return death(program, "");
}

/// Whatever took the worker down may be at home in the optimiser: no author is to blame for that.
Judgement Validator::State::judge_unoptimized(Worker& worker, ProgramText program, const std::string& reason) const {
  program.optimize = false;
  Judgement judgement = judge(worker, program, encode(program));
  if (judgement.verdict.valid()) judgement.verdict.not_optimized = reason;
  return judgement;
}

Judgement Validator::State::judge(Worker& worker, const ProgramText& program, const std::string& candidate) const {
  if (std::optional<Judgement> judgement = too_large(program)) return *judgement;
  if (std::optional<Verdict> verdict = cache.find(candidate)) return {std::move(*verdict), false};
  Judgement judgement = ask(worker, program, candidate);
  if (judgement.died && program.optimize)
    judgement = judge_unoptimized(worker, program, judgement.verdict.messages.front().text);
  cache.store(candidate, judgement.verdict);
  return judgement;
}

void Validator::State::judge_all(std::vector<Question>& questions) {
  std::atomic<std::size_t> next{0};
  const auto work = [&](Worker& worker) {
    for (std::size_t i = next++; i < questions.size(); i = next++)
      questions[i].judgement = judge(worker, *questions[i].program, *questions[i].candidate);
  };
  std::vector<std::jthread> threads;
  const std::size_t busy = std::min(workers.size(), questions.size());
  for (std::size_t i = 1; i < busy; ++i) threads.emplace_back(work, std::ref(*workers[i]));
  work(*workers.front());
}

ValidationResult Validator::State::result(ProgramText program, const Judgement& judgement) {
  ValidationResult result;
  result.died = judgement.died;
  for (const VerdictMessage& message : judgement.verdict.messages) result.messages.push_back(place_message(message, program));
  if (!judgement.verdict.valid()) return result;
  ValidatedProgram& validated = result.program.emplace(ValidatedProgram());
  validated.target_ = program.target;
  validated.stages_ = std::move(program.stages);
  validated.spirv_ = judgement.verdict.spirv;
  validated.uniforms_ = judgement.verdict.uniforms;
  validated.attributes_ = judgement.verdict.attributes;
  validated.cost_ = judgement.verdict.cost;
  const std::vector<std::string>& texts = judgement.verdict.optimized_texts;
  for (std::size_t i = 0; i < texts.size(); ++i) {  // optimised text has no author any more
    MappedText& text = validated.stages_[i].text;
    text = MappedText();
    text.append_generated(texts[i]);
  }
  result.not_optimized = judgement.verdict.not_optimized;
  return result;
}

Validator::Validator(ValidatorOptions options) : state_(std::make_unique<State>(std::move(options))) {}
Validator::~Validator() = default;
Validator::Validator(Validator&&) noexcept = default;
Validator& Validator::operator=(Validator&&) noexcept = default;

std::vector<ValidationResult> Validator::validate(std::vector<ProgramText> programs) {
  std::map<std::string, std::size_t> known;  // which question it is
  std::vector<Question> questions;
  std::vector<std::size_t> question_of;
  for (const ProgramText& program : programs) {
    check_stages(program);
    const auto [entry, is_new] = known.try_emplace(encode(program), questions.size());
    if (is_new) questions.push_back({&program, &entry->first, {}});
    question_of.push_back(entry->second);
  }
  state_->judge_all(questions);
  std::vector<ValidationResult> results;
  for (std::size_t i = 0; i < programs.size(); ++i)
    results.push_back(State::result(std::move(programs[i]), questions[question_of[i]].judgement));
  return results;
}

}  // namespace plugc

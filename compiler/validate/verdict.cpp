// Counts and numbers as 32 bits in the machine's own order (the bytes never leave the machine), strings and lists behind
// their counts. The reader keeps a failed state, so that decoding reads like encoding and is judged once at the end.

#include "validate/verdict.h"

#include <cstring>

namespace plugc {
namespace {

struct Writer {
  std::string bytes;

  void number(std::size_t value) {
    const auto stored = static_cast<std::uint32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&stored), sizeof stored);
  }
  void text(std::string_view value) {
    number(value.size());
    bytes.append(value);
  }
};

struct Reader {
  std::string_view rest;
  bool failed = false;

  std::string_view take(std::size_t size) {
    if (size > rest.size()) {
      failed = true;
      return {};
    }
    const std::string_view taken = rest.substr(0, size);
    rest.remove_prefix(size);
    return taken;
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    const std::string_view stored = take(sizeof value);
    if (!failed) std::memcpy(&value, stored.data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(take(number())); }

  /// An enumerator below `count`.
  template <typename Enum>
  Enum enumerator(std::size_t count) {
    const std::uint32_t value = number();
    if (value >= count) failed = true;
    return failed ? Enum{} : static_cast<Enum>(value);
  }
  /// Calls `read` for each element of a list; an element takes at least four bytes, which bounds a wrong count.
  template <typename Function>
  void list(Function read) {
    const std::uint32_t count = number();
    if (count > rest.size() / sizeof count) failed = true;
    for (std::uint32_t i = 0; i < count && !failed; ++i) read();
  }
};

constexpr std::size_t kTargetCount = 3;

void write_variables(Writer& writer, const std::vector<ReflectedVariable>& variables) {
  writer.number(variables.size());
  for (const ReflectedVariable& variable : variables) {
    writer.text(variable.name);
    writer.text(variable.type);
    writer.number(variable.count);
    writer.number(variable.location);
    writer.number(variable.binding);
  }
}

std::vector<ReflectedVariable> read_variables(Reader& reader) {
  std::vector<ReflectedVariable> variables;
  reader.list([&] {
    ReflectedVariable& variable = variables.emplace_back();
    variable.name = reader.text();
    variable.type = reader.text();
    variable.count = reader.number();
    variable.location = reader.number();
    variable.binding = reader.number();
  });
  return variables;
}

VerdictMessage read_message(Reader& reader) {
  VerdictMessage message;
  message.stage = reader.enumerator<ShaderStage>(kStageCount);
  message.line = reader.number();
  message.token = reader.text();
  message.text = reader.text();
  message.column = reader.number();
  return message;
}

std::vector<std::uint32_t> read_words(Reader& reader) {
  const std::string_view bytes = reader.take(std::size_t{reader.number()} * sizeof(std::uint32_t));
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

constexpr std::uint32_t ProgramCost::*kCosts[] = {&ProgramCost::vertex_instructions, &ProgramCost::geometry_instructions,
                                                  &ProgramCost::fragment_instructions, &ProgramCost::texture_reads,
                                                  &ProgramCost::varyings};

void write_cost(Writer& writer, const std::optional<ProgramCost>& cost) {
  writer.number(cost ? 1 : 0);
  for (const auto member : kCosts) writer.number(cost ? (*cost).*member : 0);
}

std::optional<ProgramCost> read_cost(Reader& reader) {
  const bool known = reader.number() != 0;
  ProgramCost cost;
  for (const auto member : kCosts) cost.*member = reader.number();
  return known ? std::optional(cost) : std::nullopt;
}

template <typename Value>
std::optional<Value> finished(const Reader& reader, Value value) {
  return reader.failed || !reader.rest.empty() ? std::nullopt : std::optional<Value>(std::move(value));
}

}  // namespace

std::string encode(const Candidate& candidate) {
  Writer writer;
  writer.number(static_cast<std::size_t>(candidate.target));
  writer.number(candidate.optimize ? 1 : 0);
  writer.number(candidate.stages.size());
  for (const Candidate::Stage& stage : candidate.stages) {
    writer.number(static_cast<std::size_t>(stage.stage));
    writer.text(stage.text);
  }
  return std::move(writer.bytes);
}

std::string encode(const ProgramText& program) {
  Candidate candidate{program.target, program.optimize, {}};
  for (const StageText& stage : program.stages) candidate.stages.push_back({stage.stage, std::string(stage.text.text())});
  return encode(candidate);
}

std::string encode(const Verdict& verdict) {
  Writer writer;
  writer.number(verdict.messages.size());
  for (const VerdictMessage& message : verdict.messages) {
    writer.number(static_cast<std::size_t>(message.stage));
    writer.number(message.line);
    writer.text(message.token);
    writer.text(message.text);
    writer.number(message.column);
  }
  write_variables(writer, verdict.uniforms);
  write_variables(writer, verdict.attributes);
  writer.number(verdict.spirv.size());
  for (const std::vector<std::uint32_t>& words : verdict.spirv) {
    writer.number(words.size());
    writer.bytes.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t));
  }
  writer.number(verdict.optimized_texts.size());
  for (const std::string& text : verdict.optimized_texts) writer.text(text);
  write_cost(writer, verdict.cost);
  writer.text(verdict.not_optimized);
  return std::move(writer.bytes);
}

std::optional<Candidate> decode_candidate(std::string_view bytes) {
  Reader reader{bytes};
  Candidate candidate;
  candidate.target = reader.enumerator<Target>(kTargetCount);
  candidate.optimize = reader.number() != 0;
  reader.list([&] {
    const auto stage = reader.enumerator<ShaderStage>(kStageCount);
    candidate.stages.push_back({stage, reader.text()});
  });
  return finished(reader, std::move(candidate));
}

std::optional<Verdict> decode_verdict(std::string_view bytes) {
  Reader reader{bytes};
  Verdict verdict;
  reader.list([&] { verdict.messages.push_back(read_message(reader)); });
  verdict.uniforms = read_variables(reader);
  verdict.attributes = read_variables(reader);
  reader.list([&] { verdict.spirv.push_back(read_words(reader)); });
  reader.list([&] { verdict.optimized_texts.push_back(reader.text()); });
  verdict.cost = read_cost(reader);
  verdict.not_optimized = reader.text();
  return finished(reader, std::move(verdict));
}

}  // namespace plugc

// Any bytes as the code of a Script with a field of every kind: what is made of it names only steps, variables and fields that
// there are, and runs to an end.

#include <cstdint>
#include <string>

#include "base/check.h"
#include "base/script_limits.h"
#include "package/pack_script.h"
#include "runtime/script_machine.h"
#include "script/script.h"

namespace plugc {
namespace {

/// `boolean`, `boolean_list` and so on: those that are heard, too, by a function of their name.
std::vector<ScriptField> all_fields() {
  static const std::string names[] = {"boolean", "integer", "number", "text", "vec2", "vec3", "vec4", "mat3", "mat4", "other"};
  static const std::string list_names[] = {"booleans", "integers", "numbers", "texts", "vec2s",
                                           "vec3s",    "vec4s",    "mat3s",   "mat4s", "others"};
  std::vector<ScriptField> fields = {{"event", {ScriptKind::number, false}, true, false, {}}};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    const auto kind = static_cast<ScriptKind>(i + 1);
    fields.push_back({names[i], {kind, false}, true, true, {1}});
    fields.push_back({list_names[i], {kind, true}, true, true, {}});
  }
  return fields;
}

void check_program(const ScriptProgram& program, std::size_t field_count) {
  const auto is_field = [&](int field) { return field >= -1 && field < static_cast<int>(field_count); };
  for (const ScriptVariable& variable : program.variables) PLUGC_CHECK(is_field(variable.field), "a variable's field exists");
  for (const ScriptFunction& function : program.functions) {
    PLUGC_CHECK(is_field(function.field) && function.begin < function.end && function.end <= program.steps.size(),
                "a function's steps exist");
  }
  for (const ScriptStep& step : program.steps) {
    const bool names_variable = step.op == ScriptOp::load || step.op == ScriptOp::store;
    const bool jumps = step.op == ScriptOp::jump || step.op == ScriptOp::jump_if_not;
    PLUGC_CHECK(!names_variable || step.operand < program.variables.size(), "a step's variable exists");
    PLUGC_CHECK(!jumps || step.operand <= program.steps.size(), "a jump leads to a step");
  }
}

/// Every function twice, each on 16 numbers, whatever its type is.
void run_program(const ScriptProgram& program) {
  const auto made = pack_script(program, [](const Span& span) { return span.begin; });
  made->origin = std::make_unique<PackedLineOrigin>(0, 0);
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(CreatePackedScript(builder, made.get()));
  const PackedScript& script = *flatbuffers::GetRoot<PackedScript>(builder.GetBufferPointer());
  ScriptMemory memory;
  start_script(script, memory);
  std::uint64_t work_left = kMaxScriptWork;  // a fuzzer has no time for all of a frame's
  AwakeScript awake{script, memory, work_left};
  for (int round = 0; round < 2; ++round) {
    for (const PackedScriptFunction* function : *script.functions()) {
      const std::vector<double> value(16, round);
      run_script_function(awake, *function, value, round);
    }
  }
  PLUGC_CHECK(memory.stopped == !memory.message.empty(), "who is stopped says why");
  PLUGC_CHECK(memory.held <= kMaxScriptNumbers, "variables hold no more than they may");
}

}  // namespace
}  // namespace plugc

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plugc::SourceSet sources;
  const plugc::SourceId id = sources.add("code", std::string(reinterpret_cast<const char*>(data), size));
  plugc::Diagnostics diagnostics(sources);
  const std::vector<plugc::ScriptField> fields = plugc::all_fields();
  const plugc::MappedText code(sources, {id, 0, static_cast<std::uint32_t>(size)});
  const plugc::ScriptProgram program = plugc::compile_script(code, fields, diagnostics);
  plugc::check_program(program, fields.size());
  plugc::run_program(program);
  return 0;
}

// A candidate's stages are parsed one by one, so that each one's errors come; only then are they linked, checked for what
// glslang leaves to drivers, and reflected. Before glslang sees a text, its `#version` is read: that decides whether the
// text fits the target at all, and glslang is not to be asked for SPIR-V below 330 (it prints its built-ins by the
// thousand lines).
// What glslang does not check and drivers do: a fragment input that no earlier stage declares (GLSL 3.30, 4.3.4), or that one
// declares with another interpolation.
// Of a syntax error glslang tells the line only. Its token is found by parsing the text cut off behind one token of that line
// or another: as long as the one at fault is cut off too, glslang misses the end of the text instead. A `#line` directive
// shifts the lines of messages. A failing text that has one is parsed again with its directives made blank, for the places
// only.

#include "validate/judge.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <deque>
#include <memory>

#include "base/limits.h"
#include "glsl/scan.h"
#include "validate/expression_depth.h"
#include "validate/glslang_log.h"
#include "validate/optimize.h"
#include "validate/reflect.h"
#include "validate/version_directive.h"

namespace plugc {
namespace {

EShLanguage language(ShaderStage stage) {
  switch (stage) {
    case ShaderStage::vertex: return EShLangVertex;
    case ShaderStage::geometry: return EShLangGeometry;
    case ShaderStage::fragment: return EShLangFragment;
  }
  return EShLangVertex;
}

/// Without cascading errors glslang stops at the first.
EShMessages message_flags(Target target) {
  return static_cast<EShMessages>(EShMsgCascadingErrors | (target == Target::spirv ? EShMsgSpvRules : EShMsgDefault));
}

/// One parsed stage. glslang keeps pointers to the text: neither may move.
struct ParsedStage {
  ParsedStage(Target target, ShaderStage kind, std::string_view source) : stage(kind), text(source), shader(language(kind)) {
    const char* begin = text.data();
    const int size = static_cast<int>(text.size());
    shader.setStringsWithLengths(&begin, &size, 1);
    if (target == Target::spirv) {
      shader.setEnvInput(glslang::EShSourceGlsl, language(kind), glslang::EShClientOpenGL, 100);
      shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
      shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
      shader.setAutoMapBindings(true);   // else it gives each sampler 0, or asks for a location;
      shader.setAutoMapLocations(true);  // assign_interface() has the numbers
    }
    constexpr int kVersionWhereTheTextHasNone = 100;
    parsed = shader.parse(GetDefaultResources(), kVersionWhereTheTextHasNone, false, message_flags(target));
  }
  ParsedStage(const ParsedStage&) = delete;
  ParsedStage& operator=(const ParsedStage&) = delete;

  ShaderStage stage;
  std::string text;
  glslang::TShader shader;
  bool parsed = false;
};

/// A log's errors; a failure without a word is one all the same.
std::vector<VerdictMessage> errors_of(const char* log, ShaderStage stage) {
  std::vector<VerdictMessage> messages = read_glslang_log(log, stage);
  if (messages.empty()) messages.push_back({stage, 0, {}, "glslang rejects the program without saying why"});
  return messages;
}

bool fails_with(Target target, ShaderStage stage, std::string_view text, const VerdictMessage& message) {
  ParsedStage cut(target, stage, text);
  const std::vector<VerdictMessage> errors = read_glslang_log(cut.shader.getInfoLog(), stage);
  return std::ranges::any_of(
      errors, [&](const VerdictMessage& error) { return error.line == message.line && error.text == message.text; });
}

/// Gives a syntax error its token and column.
void find_token(Target target, ShaderStage stage, std::string_view text, VerdictMessage& message) {
  std::uint32_t begin = 0;
  for (std::uint32_t line = 1; line < message.line; ++line)
    begin = static_cast<std::uint32_t>(std::min(text.find('\n', begin), text.size() - 1) + 1);
  const auto end = static_cast<std::uint32_t>(std::min(text.find('\n', begin), text.size()));
  const std::vector<Token> tokens = scan_range(text, begin, end);
  if (tokens.empty() || !fails_with(target, stage, text.substr(0, tokens.back().end), message)) return;
  std::size_t passes = 0, fails = tokens.size();  // with so many of the line's tokens
  while (fails - passes > 1) {
    const std::size_t middle = passes + (fails - passes) / 2;
    (fails_with(target, stage, text.substr(0, tokens[middle - 1].end), message) ? fails : passes) = middle;
  }
  const Token& found = tokens[fails - 1];
  message.token = token_text(text, found);
  message.column = found.begin - begin + 1;
}

std::vector<VerdictMessage> placed_errors(Target target, ParsedStage& stage) {
  std::vector<VerdictMessage> errors = errors_of(stage.shader.getInfoLog(), stage.stage);
  for (VerdictMessage& error : errors) {
    const bool is_syntax_error = error.text.starts_with("syntax error, unexpected ");
    if (is_syntax_error && error.line != 0 && error.token.empty()) find_token(target, stage.stage, stage.text, error);
  }
  return errors;
}

std::vector<VerdictMessage> parse_errors(Target target, ParsedStage& stage) {
  if (stage.parsed) return {};
  if (std::optional<std::string> blanked = without_line_directives(stage.text)) {
    ParsedStage again(target, stage.stage, *blanked);
    // When it passes now, a directive itself was the mistake.
    if (!again.parsed) return placed_errors(target, again);
  }
  return placed_errors(target, stage);
}

/// What can be said without glslang.
std::optional<VerdictMessage> mistake_before_parsing(Target target, const Candidate::Stage& stage) {
  const std::size_t nul = stage.text.find('\0');
  if (nul != std::string::npos) {
    const auto line = 1 + std::count(stage.text.begin(), stage.text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
    return VerdictMessage{stage.stage, static_cast<std::uint32_t>(line), {}, "the text holds a zero byte"};
  }
  const WrittenVersion version = read_version_directive(stage.text);
  if (fits(version, target)) return std::nullopt;
  return VerdictMessage{stage.stage, version.line, "#version", mismatch_text(version, target)};
}

struct Linked {
  std::deque<ParsedStage> stages;
  glslang::TProgram program;  // after the stages: it points to them

  const glslang::TIntermediate* tree(std::size_t i) const { return program.getIntermediate(language(stages[i].stage)); }
};

/// Parses all stages and links them; returns what is wrong.
std::vector<VerdictMessage> link(const Candidate& candidate, Linked& linked) {
  std::vector<VerdictMessage> messages;
  for (const Candidate::Stage& stage : candidate.stages) {
    ParsedStage& parsed = linked.stages.emplace_back(candidate.target, stage.stage, stage.text);
    std::ranges::move(parse_errors(candidate.target, parsed), std::back_inserter(messages));
    linked.program.addShader(&parsed.shader);
  }
  if (!messages.empty()) return messages;
  if (!linked.program.link(message_flags(candidate.target)))
    return errors_of(linked.program.getInfoLog(), candidate.stages.back().stage);
  for (std::size_t i = 0; i < linked.stages.size(); ++i) {
    if (tree_depth(*linked.tree(i)) <= kMaxTreeDepth) continue;
    messages.push_back({linked.stages[i].stage,
                        0,
                        {},
                        fmt::format("an expression nests more than {} deep, which crashes drivers", kMaxTreeDepth)});
  }
  for (std::size_t i = 1; i < linked.stages.size(); ++i) {
    const ShaderStage before = linked.stages[i - 1].stage, stage = linked.stages[i].stage;
    std::ranges::move(find_unwritten_inputs(*linked.tree(i - 1), *linked.tree(i), stage, before), std::back_inserter(messages));
    if (stage != ShaderStage::fragment) continue;
    std::ranges::move(find_unequal_interpolation(*linked.tree(i - 1), *linked.tree(i), before), std::back_inserter(messages));
  }
  return messages;
}

/// A package takes no longer arrays; the last stage that names one declares it.
std::vector<VerdictMessage> find_long_arrays(const Candidate& candidate, const std::vector<ReflectedVariable>& uniforms) {
  std::vector<VerdictMessage> messages;
  for (const ReflectedVariable& uniform : uniforms) {
    if (uniform.count <= kMaxUniformElements) continue;
    const auto named = [&](const Candidate::Stage& stage) { return stage.text.find(uniform.name) != std::string::npos; };
    const auto stage = std::find_if(candidate.stages.rbegin(), candidate.stages.rend(), named);
    messages.push_back(
        {stage == candidate.stages.rend() ? candidate.stages.back().stage : stage->stage, 0, uniform.name,
         fmt::format("`{}` has {} elements; plugc takes at most {}", uniform.name, uniform.count, kMaxUniformElements)});
  }
  return messages;
}

/// Text that was not parsed for SPIR-V tells glslang no version of it to write.
void set_version(std::vector<std::uint32_t>& words) {
  constexpr std::uint32_t kVersion10 = 0x00010000;
  if (words.size() > 1) words[1] = kVersion10;
}

std::vector<SpirvStage> make_spirv(const Linked& linked) {
  std::vector<SpirvStage> stages;
  for (std::size_t i = 0; i < linked.stages.size(); ++i) {
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    SpirvStage& stage = stages.emplace_back();
    stage.stage = linked.stages[i].stage;
    glslang::GlslangToSpv(*linked.tree(i), stage.words, &options);
    set_version(stage.words);
  }
  return stages;
}

/// Whether every variable of `now` was there `before`, of the same type.
bool is_subset(const std::vector<ReflectedVariable>& now, const std::vector<ReflectedVariable>& before) {
  return std::ranges::all_of(now, [&](const ReflectedVariable& variable) {
    const auto found = std::ranges::find(before, variable.name, &ReflectedVariable::name);
    return found != before.end() && found->type == variable.type && found->count == variable.count;
  });
}

Verdict judge_linked(const Candidate& candidate);

/// Writes the stages as text again and takes what that reads in place of what the verdict says. Why not, or "".
std::string take_texts(const std::vector<SpirvStage>& stages, Target target, const std::set<std::string>& numbered,
                       Verdict& verdict) {
  Candidate written{target, false, {}};
  for (const SpirvStage& stage : stages) written.stages.push_back({stage.stage, write_glsl(stage, target, numbered)});
  const Verdict again = judge_linked(written);
  if (!again.valid()) return fmt::format("its optimised text is not valid: {}", again.messages.front().text);
  if (!is_subset(again.uniforms, verdict.uniforms) || !is_subset(again.attributes, verdict.attributes))
    return "optimising changes the name of a uniform or attribute";
  verdict.uniforms = again.uniforms;
  verdict.attributes = again.attributes;
  for (Candidate::Stage& stage : written.stages) verdict.optimized_texts.push_back(std::move(stage.text));
  return "";
}

/// The uniforms and attributes that the modules still have.
void keep_numbered(std::vector<ReflectedVariable>& variables) {
  std::erase_if(variables, [](const ReflectedVariable& variable) { return variable.location == kNoInterfaceNumber; });
}

std::string optimize_verdict(std::vector<SpirvStage>& stages, Target target, const std::set<std::string>& numbered,
                             Verdict& verdict) {
  std::vector<SpirvStage> optimized = stages;
  if (std::string error = optimize(optimized); !error.empty()) return error;
  if (target != Target::spirv) {
    if (std::string error = take_texts(optimized, target, numbered, verdict); !error.empty()) return error;
  }
  verdict.cost = cost_of(optimized);
  stages = std::move(optimized);
  return "";
}

/// What of the verdict comes of SPIR-V.
void add_spirv(const Candidate& candidate, const Linked& linked, Verdict& verdict) {
  std::vector<SpirvStage> stages = make_spirv(linked);
  const std::set<std::string> numbered = assign_interface(stages);
  if (candidate.optimize) verdict.not_optimized = optimize_verdict(stages, candidate.target, numbered, verdict);
  if (candidate.target != Target::spirv) return;
  note_interface(stages, verdict.uniforms, verdict.attributes);
  if (verdict.cost) {
    keep_numbered(verdict.uniforms);
    keep_numbered(verdict.attributes);
  }
  for (SpirvStage& stage : stages) verdict.spirv.push_back(std::move(stage.words));
}

Verdict judge_linked(const Candidate& candidate) {
  Verdict verdict;
  Linked linked;
  verdict.messages = link(candidate, linked);
  if (!verdict.valid()) return verdict;
  linked.program.buildReflection(EShReflectionDefault);
  std::vector<ReflectedVariable> uniforms = reflect_uniforms(linked.program);
  verdict.messages = find_long_arrays(candidate, uniforms);
  if (!verdict.valid()) return verdict;
  verdict.uniforms = std::move(uniforms);
  if (candidate.stages.front().stage == ShaderStage::vertex) verdict.attributes = reflect_attributes(linked.program);
  if (candidate.target != Target::spirv && !candidate.optimize) return verdict;
  try {
    add_spirv(candidate, linked, verdict);
  } catch (const std::exception& error) {  // SPIRV-Cross speaks so
    verdict.not_optimized = error.what();
    if (candidate.target == Target::spirv) verdict.messages.push_back({ShaderStage::vertex, 0, {}, error.what()});
  }
  return verdict;
}

const char* version_line(Target target) {
  return target == Target::essl300 ? "#version 300 es\n" : "#version 330 core\n";
}

}  // namespace

Verdict judge(const Candidate& candidate) {
  static const bool initialized = glslang::InitializeProcess();
  Verdict verdict;
  if (!initialized) verdict.messages.push_back({ShaderStage::vertex, 0, {}, "glslang cannot be initialized"});
  for (const Candidate::Stage& stage : candidate.stages) {
    if (auto mistake = mistake_before_parsing(candidate.target, stage)) verdict.messages.push_back(std::move(*mistake));
  }
  if (candidate.stages.empty()) verdict.messages.push_back({ShaderStage::vertex, 0, {}, "the program has no stage"});
  return verdict.valid() ? judge_linked(candidate) : verdict;
}

void warm_up(Target target) {
  const std::string version = version_line(target);
  judge({target,
         false,
         {{ShaderStage::vertex, version + "void main() { gl_Position = vec4(0.0); }\n"},
          {ShaderStage::fragment, version + "precision highp float;\nout vec4 color;\nvoid main() { color = vec4(0.0); }\n"}}});
}

}  // namespace plugc

// Any bytes as a shader part of each stage: tokens, outline and upgrade hold their promises, and the upgraded text can be
// outlined again.

#include <cstdint>
#include <string>

#include "base/check.h"
#include "glsl/dialect.h"
#include "glsl/outline.h"

namespace plugc {
namespace {

void check_tokens(std::string_view text, const TokenList& list) {
  std::uint32_t behind = 0;
  for (const Token& token : list.tokens) {
    PLUGC_CHECK(behind <= token.begin && token.begin < token.end && token.end <= text.size(),
                "tokens are ordered and not empty");
    behind = token.end;
  }
}

void check_outline(std::string_view text, const Outline& outline) {
  for (const FunctionOutline& function : outline.functions) {
    PLUGC_CHECK(function.begin <= function.name_begin && function.name_begin < function.parameters_begin &&
                    function.parameters_begin <= function.parameters_end && function.parameters_end < function.end &&
                    function.body_begin <= function.body_end && function.body_end <= function.end &&
                    function.end <= text.size(),
                "a function's places are in order");
  }
  for (const GlobalOutline& global : outline.globals) {
    PLUGC_CHECK(global.begin <= global.declarator_begin && global.declarator_begin < global.declarator_end &&
                    global.initializer_begin <= global.initializer_end && global.declarator_end <= global.end &&
                    global.end <= text.size() && global.declarator_count > 0,
                "a global's places are in order");
  }
}

void check_stage(const SourceSet& sources, const MappedText& part, ShaderStage stage) {
  const MacroDefinition predefined[] = {{"GL_ES", "1"}};
  const auto macros = std::span(predefined, stage == ShaderStage::vertex ? 1 : 0);
  const TokenList tokens = tokenize(part.text(), macros);
  check_tokens(part.text(), tokens);
  check_outline(part.text(), outline(part.text(), tokens, Storage::in));
  const UpgradedText upgraded = upgrade(part, stage, macros);
  const TokenList upgraded_tokens = tokenize(upgraded.text.text(), macros);
  check_outline(upgraded.text.text(), outline(upgraded.text.text(), upgraded_tokens, Storage::in));
  for (const Token& token : upgraded_tokens.tokens) {
    const Span place = upgraded.text.locate(token.begin, token.end);
    PLUGC_CHECK(!place.valid() || place.end <= sources.text(place.source).size(), "places lie inside the author's text");
  }
}

}  // namespace
}  // namespace plugc

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plugc::SourceSet sources;
  const plugc::SourceId id = sources.add("part.glsl", std::string(reinterpret_cast<const char*>(data), size));
  const plugc::MappedText part(sources, {id, 0, static_cast<std::uint32_t>(size)});
  plugc::check_stage(sources, part, plugc::ShaderStage::vertex);
  plugc::check_stage(sources, part, plugc::ShaderStage::geometry);
  plugc::check_stage(sources, part, plugc::ShaderStage::fragment);
  return 0;
}

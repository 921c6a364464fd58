// The tokens are cut at the commas that stand in no bracket; each piece is qualifiers, type, perhaps `[n]`, name, perhaps
// `[n]`. Lenient: what does not fit leaves the field empty, and the compiler behind says why.

#include "glsl/parameters.h"

#include "glsl/qualifiers.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

// The text of `[...]` that starts at tokens[at], several of them joined; `at` moves behind it.
std::string_view read_array(std::string_view text, std::span<const Token> tokens, std::size_t& at) {
  if (at == tokens.size() || text[tokens[at].begin] != '[') return {};
  const std::uint32_t begin = tokens[at].begin;
  std::uint32_t depth = 0;
  std::uint32_t end = begin;
  for (; at < tokens.size(); ++at) {
    const char c = text[tokens[at].begin];
    if (depth == 0 && c != '[') break;
    if (c == '[') ++depth;
    if (c == ']') --depth;
    end = tokens[at].end;
  }
  return text.substr(begin, end - begin);
}

void apply_qualifier(std::string_view word, Parameter& parameter) {
  if (word == "const") parameter.is_const = true;
  if (word == "out") parameter.direction = Direction::out;
  if (word == "inout") parameter.direction = Direction::inout;
}

Parameter read_parameter(std::string_view text, std::span<const Token> tokens) {
  Parameter parameter;
  parameter.begin = tokens.front().begin;
  parameter.end = tokens.back().end;
  std::size_t at = 0;
  for (; at < tokens.size() && qualifier_kind(token_text(text, tokens[at])) != QualifierKind::none; ++at) {
    apply_qualifier(token_text(text, tokens[at]), parameter);
  }
  const auto read_word = [&]() -> std::string_view {
    if (at == tokens.size() || tokens[at].kind != TokenKind::identifier) return {};
    return token_text(text, tokens[at++]);
  };
  parameter.type = read_word();
  const std::string_view type_array = read_array(text, tokens, at);
  parameter.name = read_word();
  const std::string_view name_array = read_array(text, tokens, at);
  parameter.array = name_array.empty() ? type_array : name_array;
  return parameter;
}

}  // namespace

std::vector<Parameter> read_parameters(std::string_view text, std::span<const Token> tokens) {
  std::vector<Parameter> parameters;
  std::size_t first = 0;
  std::uint32_t depth = 0;
  for (std::size_t i = 0; i <= tokens.size(); ++i) {
    const char c = i < tokens.size() ? text[tokens[i].begin] : ',';
    if (c == '(' || c == '[') ++depth;
    if ((c == ')' || c == ']') && depth > 0) --depth;
    if (c != ',' || (depth > 0 && i < tokens.size())) continue;
    if (i > first) parameters.push_back(read_parameter(text, tokens.subspan(first, i - first)));
    first = i + 1;
  }
  const bool only_void = parameters.size() == 1 && parameters[0].type == "void" && parameters[0].name.empty();
  if (only_void) parameters.clear();
  return parameters;
}

std::vector<Parameter> parse_parameters(std::string_view text) {
  return read_parameters(text, scan_range(text, 0, static_cast<std::uint32_t>(text.size())));
}

}  // namespace plugc

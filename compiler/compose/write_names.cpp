// Names change on tokens: a member behind `.` or in a struct is none, a name in a directive (a macro's body) is one.

#include <algorithm>
#include <map>
#include <unordered_set>

#include "compose/unit_draft.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

/// Where struct definitions declare members: never a global's name.
std::unordered_set<std::uint32_t> find_members(const CodeUnit& code) {
  std::unordered_set<std::uint32_t> members;
  const auto& tokens = code.tokens.tokens;
  for (const StructOutline& type : code.outline.structs) {
    auto token = std::ranges::lower_bound(tokens, type.begin, {}, &Token::begin);
    for (; token != tokens.end() && token->end <= type.end; ++token) {
      const std::string_view next = token + 1 == tokens.end() ? "" : code.at(*(token + 1));
      const bool declares = token->begin != type.name_begin && token->begin != type.instance_begin;
      if (declares && (next == ";" || next == "," || next == "[")) members.insert(token->begin);
    }
  }
  return members;
}

void write_name(UnitDraft& draft, const Token& token) {
  const std::string_view word = draft.code.at(token);
  const std::string_view name = draft.final_name(word);
  if (name != word) draft.edits.rename(token, name);
}

/// The directive's own word (`define`, `if`) is no name.
void write_directive_names(UnitDraft& draft, const Token& directive) {
  const std::vector<Token> words = directive_tokens(draft.text, directive);
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i].kind == TokenKind::identifier && draft.code.at(words[i - 1]) != ".") write_name(draft, words[i]);
  }
}

void write_other_names(UnitDraft& draft) {
  const std::unordered_set<std::uint32_t> members = find_members(draft.code);
  const auto& tokens = draft.code.tokens.tokens;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind != TokenKind::identifier && token.kind != TokenKind::directive) continue;
    if (draft.edits.is_removed(token.begin)) continue;
    if (token.kind == TokenKind::directive) {
      write_directive_names(draft, token);
      continue;
    }
    const bool is_member = members.contains(token.begin) || (i > 0 && draft.text[tokens[i - 1].begin] == '.');
    if (!is_member && plug_name(draft.code.at(token)).empty()) write_name(draft, token);
  }
}

/// A definition gets its own name; where the author calls a plug function, the first definition is meant.
void write_plug_names(UnitDraft& draft) {
  const CodeUnit& code = draft.code;
  std::map<std::string_view, std::string_view> called;
  std::map<std::uint32_t, std::string_view> defined;
  for (const PlugFunction& plug : code.plug_functions) {
    const FunctionOutline& function = code.outline.functions[plug.function];
    const std::string_view name = draft.unit.function_names[plug.function];
    if (name.empty()) continue;
    called.try_emplace(function.name, name);
    if (name != function.name) defined.emplace(function.name_begin, name);
  }
  for (const Token& token : code.plug_words) {
    const auto call = called.find(code.at(token));
    if (call == called.end() || draft.edits.is_removed(token.begin)) continue;
    const auto definition = defined.find(token.begin);
    const std::string_view name = definition == defined.end() ? call->second : definition->second;
    if (name != code.at(token)) draft.edits.rename(token, name);
  }
}

}  // namespace

std::string renamed(const UnitDraft& draft, std::string_view code) {
  if (draft.keeps_names) return std::string(code);
  std::string result;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i;
    while (end < code.size() && is_identifier_part(code[end])) ++end;
    if (end == i) {
      result += code[i++];
      continue;
    }
    const std::size_t before = result.find_last_not_of(" \t\r\n");
    const bool member = before != std::string::npos && result[before] == '.';
    const std::string_view word = code.substr(i, end - i);
    result += member ? word : draft.final_name(word);
    i = end;
  }
  return result;
}

void write_names(UnitDraft& draft) {
  write_plug_names(draft);
  if (!draft.keeps_names) write_other_names(draft);
}

}  // namespace plugc

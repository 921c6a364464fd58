// A list of edits is made for the unit's text and applied at the end, so that what is not edited keeps its place byte for
// byte. Removed ranges never overlap: a removal that meets an earlier one is dropped (that happens in broken code only, which
// glslang then reports), and nothing else is edited inside of them.

#include "compose/unit_writer.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compose/geometry_layout.h"
#include "compose/precision.h"
#include "compose/prototype_text.h"
#include "compose/struct_text.h"
#include "glsl/edit.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

class UnitWriter {
 public:
  UnitWriter(Composition& composition, const PlacedUnit& unit, Declared& declared)
      : c_(composition),
        unit_(unit),
        code_(*unit.code),
        text_(unit.code->text.text()),
        declared_(declared),
        no_name_changes_(composition.keeps_names(unit)) {}

  void write(MappedText& stage);

 private:
  using Declarators = std::vector<const GlobalOutline*>;

  void replace(std::uint32_t begin, std::uint32_t end, std::string replacement);
  void remove_lines(std::uint32_t begin, std::uint32_t end);
  bool is_removed(std::uint32_t offset) const;
  void remove_hoisted();
  void remove_repeated();
  void remove_struct(const StructOutline& type);
  bool is_repeated(const GlobalOutline& global);
  void report_unequal(std::string_view name, std::uint32_t begin, std::string_view type, const Declared::Declaration& before);
  void rewrite_declaration(const Declarators& declarators, const std::vector<bool>& repeated);
  std::string declarator_text(const GlobalOutline& global) const;
  bool loses_initializer(const GlobalOutline& global) const;
  void remove_initializer(const GlobalOutline& global);
  void write_precision(const GlobalOutline& global);
  void write_markers();
  void write_calls(const MarkerOutline& marker, const std::vector<PlugCall>& calls);
  void write_forward_declarations();
  std::string condition(const PlugCall& call) const;
  void write_forwards();
  Span call_origin(const PlugCall& call) const;
  void find_members();
  void write_names();
  void write_directive_names(const Token& directive);
  void write_plug_names();
  std::string final_name(std::string_view name) const { return c_.final_name(unit_, name); }
  std::string renamed(std::string_view code) const;
  void end_macros();

  Composition& c_;
  const PlacedUnit& unit_;
  const CodeUnit& code_;
  const std::string_view text_;
  Declared& declared_;
  const bool no_name_changes_;
  std::vector<Edit> edits_;
  std::map<std::uint32_t, std::uint32_t> removed_;  // begin -> end
  std::unordered_set<std::uint32_t> members_;       // where members of structs are declared
};

bool is_space(char c) {
  return is_blank(c) || c == '\r';
}

void UnitWriter::replace(std::uint32_t begin, std::uint32_t end, std::string replacement) {
  const auto next = removed_.lower_bound(begin);
  if ((next != removed_.end() && next->first < end) || is_removed(begin) || begin >= end) return;
  removed_.emplace(begin, end);
  edits_.push_back({begin, end, std::move(replacement), {}});
}

/// Removes a range, and the whole line when nothing else stands on it.
void UnitWriter::remove_lines(std::uint32_t begin, std::uint32_t end) {
  std::uint32_t line_begin = begin;
  while (line_begin > 0 && is_blank(text_[line_begin - 1])) --line_begin;
  std::uint32_t line_end = end;
  while (line_end < text_.size() && is_space(text_[line_end])) ++line_end;
  const bool alone = (line_begin == 0 || text_[line_begin - 1] == '\n') && line_end < text_.size() && text_[line_end] == '\n' &&
                     !is_removed(line_begin);
  alone ? replace(line_begin, line_end + 1, "") : replace(begin, end, "");
}

bool UnitWriter::is_removed(std::uint32_t offset) const {
  const auto behind = removed_.upper_bound(offset);
  return behind != removed_.begin() && offset < std::prev(behind)->second;
}

/// `#version`, `#extension`, precision statements, a `;` that ends nothing, and a geometry shader's input: the head of the
/// stage has them.
void UnitWriter::remove_hoisted() {
  const Outline& outline = code_.outline;
  if (outline.version.end > outline.version.begin) remove_lines(outline.version.begin, outline.version.end);
  for (const TextRange& extension : outline.extensions) remove_lines(extension.begin, extension.end);
  for (const TextRange& precision : outline.precisions) remove_lines(precision.begin, precision.end);
  for (const TextRange& empty : outline.empties) remove_lines(empty.begin, empty.end);
  if (unit_.stage != ShaderStage::geometry) return;
  const auto input = find_input_layout(code_);
  if (input && input->alone) remove_lines(input->range.begin, input->range.end);
}

/// Whether an earlier unit (or an earlier line) of the stage has made this declaration; if not, it is noted as made. A
/// uniform's initialiser is no part of its type.
bool UnitWriter::is_repeated(const GlobalOutline& global) {
  // the arrays of a geometry stage's inputs have all one size, whether or not it is written
  const bool sized_by_layout = unit_.stage == ShaderStage::geometry && global.storage == Storage::in;
  std::string text(1, static_cast<char>('0' + static_cast<int>(global.storage)));
  text.append(1, ' ').append(global.type);
  if (!sized_by_layout) text.append(global.array);
  const bool has_value = global.storage != Storage::uniform && global.initializer_end > global.initializer_begin;
  if (has_value) text += " = " + token_line(code_, global.initializer_begin, global.initializer_end);
  const auto [found, added] = declared_.globals.try_emplace(final_name(global.name));
  if (added) found->second = {std::move(text), name_span(code_, global.name, global.name_begin), unit_.owner};
  if (!added && found->second.text != text)
    report_unequal(global.name, global.name_begin, fmt::format("{}{}", global.type, global.array), found->second);
  return !added;
}

void UnitWriter::report_unequal(std::string_view name, std::uint32_t begin, std::string_view type,
                                const Declared::Declaration& before) {
  // what another effect has borrowed fits what this one writes: it contradicts itself, which has been said
  if (before.owner != unit_.owner && c_.is_faulty(unit_)) return;
  std::vector<RelatedPlace> related;
  if (before.span.valid()) related.push_back({before.span, "the other declaration"});
  c_.diagnostics.report(DiagnosticId::unequal_declarations, name_span(code_, name, begin),
                        fmt::format("`{}` is declared here as `{}`, and differently before", name, type), std::move(related));
  c_.mark_faulty(unit_);
}

/// ESSL 3.00 knows no initialised uniforms; their values come from the package.
bool UnitWriter::loses_initializer(const GlobalOutline& global) const {
  return c_.target == Target::essl300 && global.storage == Storage::uniform &&
         global.initializer_begin < global.initializer_end;
}

std::string UnitWriter::declarator_text(const GlobalOutline& global) const {
  std::string_view code = text_.substr(global.declarator_begin, global.declarator_end - global.declarator_begin);
  if (loses_initializer(global)) code = code.substr(0, code.find('='));
  return renamed(code);
}

/// `uniform float a, b;` of which only `b` is new becomes `uniform float b;`.
void UnitWriter::rewrite_declaration(const Declarators& declarators, const std::vector<bool>& repeated) {
  const GlobalOutline& first = *declarators.front();
  if (std::all_of(repeated.begin(), repeated.end(), [](bool r) { return r; })) return remove_lines(first.begin, first.end);
  if (std::none_of(repeated.begin(), repeated.end(), [](bool r) { return r; })) return;
  std::string names;
  for (std::size_t i = 0; i < declarators.size(); ++i) {
    if (!repeated[i]) names += (names.empty() ? "" : ", ") + declarator_text(*declarators[i]);
  }
  replace(first.begin, first.end, renamed(text_.substr(first.begin, first.declarator_begin - first.begin)) + names + ";");
}

void UnitWriter::remove_initializer(const GlobalOutline& global) {
  if (!loses_initializer(global) || is_removed(global.begin)) return;
  const std::size_t equals = text_.rfind('=', global.initializer_begin);
  if (equals != std::string_view::npos) replace(static_cast<std::uint32_t>(equals), global.initializer_end, "");
}

/// The precision that all stages have for a uniform.
void UnitWriter::write_precision(const GlobalOutline& global) {
  if (c_.precisions.empty() || global.storage != Storage::uniform || is_removed(global.begin)) return;
  const auto wanted = c_.precisions.find(final_name(global.name));
  const auto word = precision_word(code_, global);
  if (wanted != c_.precisions.end() && word && code_.at(*word) != wanted->second)
    replace(word->begin, word->end, std::string(wanted->second));
}

/// A repeated `struct S {...};` goes; of a repeated `struct S {...} a;` the variable's type stays.
void UnitWriter::remove_struct(const StructOutline& type) {
  if (type.storage != Storage::none || type.name.empty()) return;
  const std::string name = final_name(type.name);
  const auto [found, added] = declared_.structs.try_emplace(name);
  if (added) {
    found->second = {struct_text(code_, type), name_span(code_, type.name, type.name_begin), unit_.owner};
    return;
  }
  if (found->second.text != struct_text(code_, type)) report_unequal(type.name, type.name_begin, "struct", found->second);
  const bool alone = type.end > 0 && text_[type.end - 1] == ';';
  alone ? remove_lines(type.begin, type.end) : replace(type.begin, type.end, name);
}

void UnitWriter::remove_repeated() {
  const auto& globals = code_.outline.globals;
  for (std::size_t i = 0; i < globals.size();) {
    const std::size_t count = std::clamp<std::size_t>(globals[i].declarator_count, 1, globals.size() - i);
    Declarators declarators;
    std::vector<bool> repeated;
    for (std::size_t k = 0; k < count; ++k) {
      declarators.push_back(&globals[i + k]);
      repeated.push_back(is_repeated(globals[i + k]));
    }
    rewrite_declaration(declarators, repeated);
    for (const GlobalOutline* declarator : declarators) remove_initializer(*declarator);
    write_precision(*declarators.front());
    i += count;
  }
  for (const StructOutline& type : code_.outline.structs) remove_struct(type);
}

/// The blanks that a line starts with.
std::string indent_at(std::string_view text, std::uint32_t offset) {
  const std::size_t line = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
  const std::size_t end = text.find_first_not_of(" \t", line);
  return std::string(text.substr(line, std::min<std::size_t>(end, offset) - line));
}

/// Whether the marker is the whole body of an `if`, `else` or loop, which must stay one statement.
bool is_sole_statement(const CodeUnit& code, const MarkerOutline& marker) {
  const auto& tokens = code.tokens.tokens;
  auto token = std::lower_bound(tokens.begin(), tokens.end(), marker.begin,
                                [](const Token& t, std::uint32_t at) { return t.begin < at; });
  while (token != tokens.begin() && (token - 1)->kind == TokenKind::marker) --token;
  if (token == tokens.begin()) return false;
  const std::string_view before = code.at(*(token - 1));
  return before == ")" || before == "else" || before == "do";
}

Span UnitWriter::call_origin(const PlugCall& call) const {
  const CodeUnit& code = *c_.units[call.unit].code;
  const FunctionOutline& function = code.outline.functions[call.function];
  return name_span(code, function.name, function.name_begin);
}

/// `if (plugc_on_0 && plugc_on_1) ` in front of a call that is not always made.
std::string UnitWriter::condition(const PlugCall& call) const {
  std::string text;
  for (const std::size_t guard : call.guards) text += (text.empty() ? "if (" : " && ") + c_.result.switches[guard].name;
  return text.empty() ? text : text + ") ";
}

void UnitWriter::write_calls(const MarkerOutline& marker, const std::vector<PlugCall>& calls) {
  const std::string separator = "\n" + indent_at(text_, marker.begin);
  const bool in_braces = is_sole_statement(code_, marker);
  const std::string arguments = renamed(marker.arguments);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const std::string& name = c_.units[calls[i].unit].function_names[calls[i].function];
    std::string text = i > 0 ? separator : in_braces ? "{ " : "";
    text += condition(calls[i]);
    text.append(name).append(1, '(').append(arguments).append(calls[i].rgb_only ? ".rgb);" : ");");
    if (in_braces && i + 1 == calls.size()) text += " }";
    edits_.push_back({marker.begin, marker.begin, std::move(text), call_origin(calls[i])});
  }
  replace(marker.begin, marker.end, calls.empty() ? "{}" : "");
}

void UnitWriter::write_markers() {
  const auto& markers = code_.outline.markers;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const MarkerOutline& marker = markers[m];
    if (is_removed(marker.begin)) continue;
    const bool stays = marker.kind == MarkerKind::plug && (!unit_.calls[m].empty() || is_sole_statement(code_, marker));
    stays ? write_calls(marker, unit_.calls[m]) : remove_lines(marker.begin, marker.end);
  }
}

/// In front of the first function; types that the prototypes name are declared by then.
void UnitWriter::write_forward_declarations() {
  const Outline& outline = code_.outline;
  std::uint32_t place = outline.functions.empty() ? code_.text.size() : outline.functions.front().begin;
  const auto marked = std::find_if(outline.markers.begin(), outline.markers.end(),
                                   [](const MarkerOutline& marker) { return marker.kind == MarkerKind::declarations; });
  if (marked != outline.markers.end()) place = marked->begin;
  const auto behind = removed_.upper_bound(place);
  if (behind != removed_.begin() && place < std::prev(behind)->second) place = std::prev(behind)->first;
  std::set<std::pair<std::size_t, std::size_t>> written;
  for (const std::vector<PlugCall>& calls : unit_.calls) {
    for (const PlugCall& call : calls) {
      if (written.emplace(call.unit, call.function).second)
        edits_.push_back({place, place, plug_prototype(c_, call), call_origin(call)});
    }
  }
}

void UnitWriter::write_forwards() {
  for (const auto& [index, target] : unit_.forwards) {
    const FunctionOutline& function = code_.outline.functions[index];
    edits_.push_back({function.end, function.end, forwarding_text(c_, unit_, function, target),
                      name_span(code_, function.name, function.name_begin)});
  }
}

/// Names in a piece of code that is written anew (a call's arguments, a declaration's rest).
std::string UnitWriter::renamed(std::string_view code) const {
  if (no_name_changes_) return std::string(code);
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
    result += member ? std::string(code.substr(i, end - i)) : final_name(code.substr(i, end - i));
    i = end;
  }
  return result;
}

/// Where struct definitions declare members: never a global's name.
void UnitWriter::find_members() {
  const auto& tokens = code_.tokens.tokens;
  for (const StructOutline& type : code_.outline.structs) {
    auto token = std::lower_bound(tokens.begin(), tokens.end(), type.begin,
                                  [](const Token& t, std::uint32_t at) { return t.begin < at; });
    for (; token != tokens.end() && token->end <= type.end; ++token) {
      const std::string_view next = token + 1 == tokens.end() ? "" : code_.at(*(token + 1));
      const bool declares = token->begin != type.name_begin && token->begin != type.instance_begin;
      if (declares && (next == ";" || next == "," || next == "[")) members_.insert(token->begin);
    }
  }
}

/// The directive's own word (`define`, `if`) is no name.
void UnitWriter::write_directive_names(const Token& directive) {
  const std::vector<Token> words = directive_tokens(text_, directive);
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i].kind != TokenKind::identifier || code_.at(words[i - 1]) == ".") continue;
    std::string name = final_name(code_.at(words[i]));
    if (name != code_.at(words[i])) edits_.push_back({words[i].begin, words[i].end, std::move(name), {}});
  }
}

void UnitWriter::write_names() {
  write_plug_names();
  if (no_name_changes_) return;
  find_members();
  const auto& tokens = code_.tokens.tokens;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (is_removed(token.begin)) continue;
    if (token.kind == TokenKind::directive) write_directive_names(token);
    if (token.kind != TokenKind::identifier || members_.contains(token.begin)) continue;
    if (i > 0 && code_.at(tokens[i - 1]) == ".") continue;
    const std::string_view word = code_.at(token);
    if (!plug_name(word).empty()) continue;
    std::string name = final_name(word);
    if (name != word) edits_.push_back({token.begin, token.end, std::move(name), {}});
  }
}

/// A definition gets its own name; where the author calls a plug function, the first definition is meant.
void UnitWriter::write_plug_names() {
  std::map<std::string_view, std::string_view> called;
  std::map<std::uint32_t, std::string_view> defined;
  bool changed = false;
  for (std::size_t f = 0; f < unit_.function_names.size(); ++f) {
    if (unit_.function_names[f].empty()) continue;
    const FunctionOutline& function = code_.outline.functions[f];
    called.try_emplace(function.name, unit_.function_names[f]);
    defined.emplace(function.name_begin, unit_.function_names[f]);
    changed = changed || unit_.function_names[f] != function.name;
  }
  for (std::size_t i = 0; changed && i < code_.tokens.tokens.size(); ++i) {
    const Token& token = code_.tokens.tokens[i];
    if (token.kind != TokenKind::identifier || is_removed(token.begin)) continue;
    const auto call = called.find(code_.at(token));
    if (call == called.end()) continue;
    const auto definition = defined.find(token.begin);
    const std::string_view name = definition == defined.end() ? call->second : definition->second;
    if (name != code_.at(token)) edits_.push_back({token.begin, token.end, std::string(name), {}});
  }
}

/// Macros end with their part.
void UnitWriter::end_macros() {
  std::set<std::string_view> names;
  for (const MacroOutline& macro : code_.outline.macros) names.insert(macro.name);
  std::string text;
  for (const std::string_view name : names) text += fmt::format("#undef {}\n", final_name(name));
  if (!text.empty()) edits_.push_back({code_.text.size(), code_.text.size(), "\n" + text, {}});
}

void UnitWriter::write(MappedText& stage) {
  remove_hoisted();
  remove_repeated();
  write_markers();
  write_forward_declarations();
  write_forwards();
  write_names();
  end_macros();
  append_edited(code_.text, std::move(edits_), stage);
  if (stage.text().back() != '\n') stage.append_generated("\n");
}

}  // namespace

void write_unit(Composition& composition, const PlacedUnit& unit, Declared& declared, MappedText& stage) {
  UnitWriter(composition, unit, declared).write(stage);
}

}  // namespace plugc

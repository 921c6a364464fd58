// One stage as text: its head (version, extensions, precision, castle_ names that are used but nowhere declared), then each
// unit with its edits: markers become calls, prototypes go in front of the first function (or where PLUG-DECLARATIONS stands),
// declarations that an earlier unit already made are dropped, names are changed as join_names decided.

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "base/check.h"
#include "compose/castle_names.h"
#include "compose/placed_unit.h"
#include "glsl/edit.h"

namespace plugc {
namespace {

/// What has been declared in the stage so far.
struct Declared {
  std::map<std::string, std::string, std::less<>> globals;  ///< Final name -> declaration without qualifier words, to compare.
  std::set<std::string, std::less<>> structs;
};

class UnitWriter {
 public:
  UnitWriter(Composition& composition, const PlacedUnit& unit, Target target, Declared& declared)
      : c_(composition), unit_(unit), code_(*unit.code), text_(unit.code->text.text()), target_(target), declared_(declared) {}

  MappedText write();

 private:
  void remove(std::uint32_t begin, std::uint32_t end);
  void remove_lines(std::uint32_t begin, std::uint32_t end);
  bool is_removed(std::uint32_t offset) const;
  void remove_hoisted();
  void remove_repeated();
  void remove_struct(const StructOutline& type);
  bool is_repeated(const GlobalOutline& global);
  void report_unequal(const GlobalOutline& global);
  void remove_initializer(const GlobalOutline& global);
  void rewrite_declaration(const std::vector<const GlobalOutline*>& declarators, const std::vector<bool>& repeated);
  void write_markers();
  void write_forward_declarations();
  void write_names();
  std::string final_name(std::string_view name) const;
  std::string renamed(std::string_view code) const;
  bool is_member(std::size_t token) const;
  void end_macros();

  Composition& c_;
  const PlacedUnit& unit_;
  const CodeUnit& code_;
  const std::string_view text_;
  Target target_;
  Declared& declared_;
  std::vector<Edit> edits_;
  std::vector<TextRange> removed_;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void UnitWriter::remove(std::uint32_t begin, std::uint32_t end) {
  edits_.push_back({begin, end, "", {}});
  removed_.push_back({begin, end});
}

/// Removes a range, and the whole line when nothing else stands on it.
void UnitWriter::remove_lines(std::uint32_t begin, std::uint32_t end) {
  std::uint32_t line_begin = begin;
  while (line_begin > 0 && (text_[line_begin - 1] == ' ' || text_[line_begin - 1] == '\t')) --line_begin;
  std::uint32_t line_end = end;
  while (line_end < text_.size() && (text_[line_end] == ' ' || text_[line_end] == '\t' || text_[line_end] == '\r')) ++line_end;
  const bool alone = (line_begin == 0 || text_[line_begin - 1] == '\n') && line_end < text_.size() && text_[line_end] == '\n' &&
                     !is_removed(line_begin);
  remove(alone ? line_begin : begin, alone ? line_end + 1 : end);
}

bool UnitWriter::is_removed(std::uint32_t offset) const {
  return std::any_of(removed_.begin(), removed_.end(), [&](const TextRange& range) { return range.begin <= offset && offset < range.end; });
}

/// `#version`, `#extension` and precision statements: the head of the stage has them.
void UnitWriter::remove_hoisted() {
  const Outline& outline = code_.outline;
  if (outline.version.end > outline.version.begin) remove_lines(outline.version.begin, outline.version.end);
  for (const TextRange& extension : outline.extensions) remove_lines(extension.begin, extension.end);
  for (const TextRange& precision : outline.precisions) remove_lines(precision.begin, precision.end);
}

std::string UnitWriter::final_name(std::string_view name) const {
  const Owner& owner = c_.owners[unit_.owner];
  if (const auto found = owner.renames.find(name); found != owner.renames.end()) return found->second;
  if (unit_.scope.kind == ScopeKind::light && owner.kind == OwnerKind::effect) {
    if (std::string numbered = number_own_light(name, unit_.scope.number); !numbered.empty()) return numbered;
  }
  return std::string(name);
}

/// Whether an earlier unit (or an earlier line) of the stage has made this declaration; if not, it is noted as made.
bool UnitWriter::is_repeated(const GlobalOutline& global) {
  const std::string name = final_name(global.name);
  const std::string initializer(text_.substr(global.initializer_begin, global.initializer_end - global.initializer_begin));
  const std::string declaration = fmt::format("{} {}{} = {}", static_cast<int>(global.storage), global.type, global.array, initializer);
  const auto [found, added] = declared_.globals.try_emplace(name, declaration);
  if (!added && found->second != declaration) report_unequal(global);
  return !added;
}

void UnitWriter::report_unequal(const GlobalOutline& global) {
  const Span span = code_.span(global.name_begin, global.name_begin + static_cast<std::uint32_t>(global.name.size()));
  c_.diagnostics.report(DiagnosticId::unequal_declarations, span,
                        fmt::format("`{}` is declared here as `{}{}`, and differently before", global.name, global.type, global.array));
  c_.mark_faulty(unit_);
}

/// `uniform float a, b;` of which only `b` is new becomes `uniform float b;`.
void UnitWriter::rewrite_declaration(const std::vector<const GlobalOutline*>& declarators, const std::vector<bool>& repeated) {
  const GlobalOutline& first = *declarators.front();
  if (std::all_of(repeated.begin(), repeated.end(), [](bool r) { return r; })) return remove_lines(first.begin, first.end);
  if (std::none_of(repeated.begin(), repeated.end(), [](bool r) { return r; })) return;
  const std::string prefix(text_.substr(first.begin, first.declarator_begin - first.begin));
  std::string statements;
  for (std::size_t i = 0; i < declarators.size(); ++i) {
    if (repeated[i]) continue;
    const std::string_view declarator =
        text_.substr(declarators[i]->declarator_begin, declarators[i]->declarator_end - declarators[i]->declarator_begin);
    statements += renamed(prefix) + renamed(declarator) + "; ";
  }
  edits_.push_back({first.begin, first.end, statements, {}});
  removed_.push_back({first.begin, first.end});
}

/// ESSL 3.00 knows no initialised uniforms; their values come from the package.
void UnitWriter::remove_initializer(const GlobalOutline& global) {
  if (target_ != Target::essl300 || global.storage != Storage::uniform || global.initializer_begin == global.initializer_end) return;
  const std::size_t equals = text_.rfind('=', global.initializer_begin);
  if (equals != std::string_view::npos && !is_removed(global.begin)) {
    remove(static_cast<std::uint32_t>(equals), global.initializer_end);
  }
}

void UnitWriter::remove_struct(const StructOutline& type) {
  if (type.storage == Storage::none && !declared_.structs.insert(final_name(type.name)).second) remove_lines(type.begin, type.end);
}

void UnitWriter::remove_repeated() {
  const auto& globals = code_.outline.globals;
  for (std::size_t i = 0; i < globals.size();) {
    const std::size_t count = std::clamp<std::size_t>(globals[i].declarator_count, 1, globals.size() - i);
    std::vector<const GlobalOutline*> declarators;
    std::vector<bool> repeated;
    for (std::size_t k = 0; k < count; ++k) {
      declarators.push_back(&globals[i + k]);
      repeated.push_back(is_repeated(globals[i + k]));
    }
    rewrite_declaration(declarators, repeated);
    for (const GlobalOutline* declarator : declarators) remove_initializer(*declarator);
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

void UnitWriter::write_markers() {
  const auto& markers = code_.outline.markers;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const MarkerOutline& marker = markers[m];
    if (is_removed(marker.begin)) continue;
    if (unit_.calls[m].empty() || marker.kind != MarkerKind::plug) {
      remove_lines(marker.begin, marker.end);
      continue;
    }
    const std::string separator = "\n" + indent_at(text_, marker.begin);
    for (std::size_t i = 0; i < unit_.calls[m].size(); ++i) {
      const PlugCall& call = unit_.calls[m][i];
      edits_.push_back({marker.begin, marker.begin, (i == 0 ? "" : separator) + renamed(call.statement), call.origin});
    }
    remove(marker.begin, marker.end);
  }
}

/// In front of the first function; types that the prototypes name are declared by then.
void UnitWriter::write_forward_declarations() {
  if (unit_.forward.empty()) return;
  const auto& outline = code_.outline;
  std::uint32_t place = outline.functions.empty() ? code_.text.size() : outline.functions.front().begin;
  for (const MarkerOutline& marker : outline.markers) {
    if (marker.kind == MarkerKind::declarations) {
      place = marker.begin;
      break;
    }
  }
  const auto covering = std::find_if(removed_.begin(), removed_.end(), [&](const TextRange& range) {
    return range.begin < place && place < range.end;
  });
  if (covering != removed_.end()) place = covering->begin;
  for (const ForwardDeclaration& declaration : unit_.forward) {
    edits_.push_back({place, place, declaration.text, declaration.origin});
  }
}

/// `.name`, or a member that a struct definition declares: never a global's name.
bool UnitWriter::is_member(std::size_t index) const {
  const auto& tokens = code_.tokens.tokens;
  if (index > 0 && code_.at(tokens[index - 1]) == ".") return true;
  const std::uint32_t at = tokens[index].begin;
  const bool in_struct = std::any_of(code_.outline.structs.begin(), code_.outline.structs.end(), [&](const StructOutline& type) {
    return type.begin < at && at < type.end && at != type.name_begin;
  });
  if (!in_struct || index + 1 >= tokens.size()) return false;
  const std::string_view next = code_.at(tokens[index + 1]);
  return next == ";" || next == "," || next == "[";
}

/// Names in a piece of code that is no token of its own (a call's arguments, a macro's body).
std::string UnitWriter::renamed(std::string_view code) const {
  std::string result;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i;
    while (end < code.size() && is_word(code[end])) ++end;
    if (end == i) {
      result += code[i++];
      continue;
    }
    const bool member = i > 0 && code[i - 1] == '.';
    result += member ? std::string(code.substr(i, end - i)) : final_name(code.substr(i, end - i));
    i = end;
  }
  return result;
}

void UnitWriter::write_names() {
  const auto& tokens = code_.tokens.tokens;
  const Owner& owner = c_.owners[unit_.owner];
  const bool has_names = !owner.renames.empty() || (unit_.scope.kind == ScopeKind::light && owner.kind == OwnerKind::effect);
  for (std::size_t i = 0; has_names && i < tokens.size(); ++i) {
    const std::string_view word = code_.at(tokens[i]);
    if (tokens[i].kind == TokenKind::directive && !is_removed(tokens[i].begin)) {
      if (std::string changed = renamed(word); changed != word) edits_.push_back({tokens[i].begin, tokens[i].end, changed, {}});
    }
    if (tokens[i].kind != TokenKind::identifier) continue;
    std::string name = final_name(word);
    if (name == word || is_member(i) || is_removed(tokens[i].begin)) continue;
    edits_.push_back({tokens[i].begin, tokens[i].end, std::move(name), {}});
  }
  for (std::size_t f = 0; f < unit_.function_names.size(); ++f) {
    const FunctionOutline& function = code_.outline.functions[f];
    if (unit_.function_names[f].empty() || unit_.function_names[f] == function.name) continue;
    const auto end = function.name_begin + static_cast<std::uint32_t>(function.name.size());
    edits_.push_back({function.name_begin, end, unit_.function_names[f], {}});
  }
}

/// Macros end with their part.
void UnitWriter::end_macros() {
  std::set<std::string_view> names;
  for (const MacroOutline& macro : code_.outline.macros) names.insert(macro.name);
  std::string text;
  for (const std::string_view name : names) text += fmt::format("#undef {}\n", renamed(name));
  if (!text.empty()) edits_.push_back({code_.text.size(), code_.text.size(), "\n" + text, {}});
}

MappedText UnitWriter::write() {
  remove_hoisted();
  remove_repeated();
  write_markers();
  write_forward_declarations();
  write_names();
  end_macros();
  MappedText text = apply_edits(code_.text, std::move(edits_));
  if (!text.empty() && text.text().back() != '\n') text.append_generated("\n");
  return text;
}

/// castle_ names that some unit of the stage uses and none declares.
std::string missing_declarations(const Composition& composition, ShaderStage stage) {
  std::set<std::string> used;
  std::set<std::string, std::less<>> declared;
  for (const PlacedUnit& unit : composition.units) {
    if (unit.stage != stage || unit.dropped) continue;
    for (const std::string& name : unit.code->castle_names) {
      const bool own_light = unit.scope.kind == ScopeKind::light && !number_own_light(name, unit.scope.number).empty();
      used.insert(own_light ? number_own_light(name, unit.scope.number) : name);
    }
    for (const GlobalOutline& global : unit.code->outline.globals) {
      const bool own_light = unit.scope.kind == ScopeKind::light && !number_own_light(global.name, unit.scope.number).empty();
      declared.emplace(own_light ? number_own_light(global.name, unit.scope.number) : std::string(global.name));
    }
  }
  std::string text;
  for (const std::string& name : used) {
    const auto meaning = find_castle_name(name);
    if (!meaning || declared.contains(name)) continue;
    const bool vertex = stage == ShaderStage::vertex;
    if (meaning->kind == CastleKind::attribute && !vertex) continue;
    if (meaning->kind == CastleKind::output && vertex) continue;
    const std::string_view qualifier = meaning->kind == CastleKind::uniform     ? "uniform"
                                       : meaning->kind == CastleKind::attribute ? "in"
                                       : meaning->kind == CastleKind::output    ? "out"
                                       : vertex                                 ? "out"
                                                                                : "in";
    text += fmt::format("{} {} {};\n", qualifier, meaning->type, name);
  }
  return text;
}

std::string stage_head(const Composition& composition, ShaderStage stage, Target target) {
  std::string head;
  int version = target == Target::essl300 ? 300 : 330;
  std::set<std::string> extensions;
  for (const PlacedUnit& unit : composition.units) {
    if (unit.stage != stage || unit.dropped) continue;
    const Outline& outline = unit.code->outline;
    if (target != Target::essl300 && outline.version.profile != "es") version = std::max(version, outline.version.number);
    for (const TextRange& extension : outline.extensions) {
      extensions.emplace(unit.code->text.text().substr(extension.begin, extension.end - extension.begin));
    }
  }
  head += target == Target::essl300 ? "#version 300 es\n" : fmt::format("#version {} core\n", version);
  for (const std::string& extension : extensions) head += extension + "\n";
  if (target == Target::essl300) {
    head += "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler2DShadow;\n"
            "precision highp samplerCube;\nprecision highp sampler3D;\n";
  }
  return head + missing_declarations(composition, stage);
}

}  // namespace

MappedText stage_text(Composition& composition, ShaderStage stage, Target target) {
  MappedText text;
  text.append_generated(stage_head(composition, stage, target));
  Declared declared;
  for (const PlacedUnit& unit : composition.units) {
    if (unit.stage != stage || unit.dropped) continue;
    text.append_generated("\n");
    text.append(UnitWriter(composition, unit, target, declared).write());
  }
  return text;
}

}  // namespace plugc

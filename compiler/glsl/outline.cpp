// Directives and markers first, then brackets are matched, then declarations are read one behind the other: qualifiers, a
// type, and behind it either a function's brackets or a list of declarators. Bodies, initialisers and arrays are jumped
// over by their brackets, so the pass is linear and nothing recurses. A declaration that cannot be read is reported and
// passed over: up to behind its `;` or its `{...}`.

#include "glsl/outline.h"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "base/limits.h"
#include "glsl/brackets.h"
#include "glsl/outline_directives.h"
#include "glsl/parameters.h"
#include "glsl/qualifiers.h"

namespace plugc {
namespace {

constexpr std::size_t kMaxProblems = 20;
constexpr std::size_t kMaxShownWord = 60;
constexpr std::size_t kMaxQualifierMacro = 200;  // bytes; such a macro is read anew at each use

// What stands before the names of one declaration. `first` and the like are indices of tokens.
struct DeclarationStart {
  std::size_t first = 0;
  Storage storage = Storage::none;
  TextRange qualifiers;
  std::string_view layout;
  TextRange type;
  std::string_view array;
};

class DeclarationReader {
 public:
  DeclarationReader(std::string_view text, const BracketedCode& code, Storage varying, Outline& outline)
      : text_(text), code_(code), varying_(varying), outline_(outline) {
    for (const MacroOutline& macro : outline.macros) macros_.emplace(macro.name, &macro);
  }

  void run() {
    while (at_ < size()) read_statement();
  }

 private:
  std::size_t size() const { return code_.tokens.size(); }
  const Token& token(std::size_t i) const { return code_.tokens[i]; }
  std::string_view word(std::size_t i) const { return i < size() ? token_text(text_, token(i)) : std::string_view{}; }
  bool is(std::size_t i, char symbol) const { return i < size() && text_[token(i).begin] == symbol; }
  bool is_identifier(std::size_t i) const { return i < size() && token(i).kind == TokenKind::identifier; }
  TextRange range_of(std::size_t first, std::size_t last) const { return {token(first).begin, token(last).end}; }
  std::string_view text_of(const TextRange& range) const { return text_.substr(range.begin, range.end - range.begin); }
  // Behind a bracket's partner; behind any other token the next one.
  std::size_t behind(std::size_t i) const { return std::max<std::size_t>(i, code_.closing[i]) + 1; }

  void read_statement();
  void read_declaration();
  void read_qualifiers(DeclarationStart& start);
  void read_qualifier(QualifierKind kind, std::size_t& run_end, DeclarationStart& start);
  bool read_macro_qualifier(DeclarationStart& start);
  void apply_storage(std::string_view word, DeclarationStart& start) const;
  std::string_view read_array();
  void read_struct(DeclarationStart& start);
  void read_block(const DeclarationStart& start);
  void read_function(const DeclarationStart& start);
  void read_globals(const DeclarationStart& start);
  void read_declarator(GlobalOutline& global);
  void skip_statement();
  void report(std::size_t i, std::string message);
  void report_unexpected();
  bool take_semicolon();

  std::string_view text_;
  const BracketedCode& code_;
  Storage varying_;
  Outline& outline_;
  std::unordered_map<std::string_view, const MacroOutline*> macros_;
  std::size_t at_ = 0;
};

void DeclarationReader::report(std::size_t i, std::string message) {
  const Token& place = token(std::min(i, size() - 1));
  outline_.problems.push_back({place.begin, place.end, std::move(message)});
}

void DeclarationReader::report_unexpected() {
  if (at_ >= size()) return report(at_, fmt::format("the text ends behind `{}`, inside a declaration", word(size() - 1)));
  report(at_, fmt::format("`{}` where a declaration was expected", word(at_).substr(0, kMaxShownWord)));
}

void DeclarationReader::skip_statement() {
  while (at_ < size()) {
    const std::size_t here = at_;
    at_ = behind(here);
    if (is(here, ';') || is(here, '{')) return;
  }
}

// The `;` that ends a declaration. Where it is missing, reading goes on at what stands in its place.
bool DeclarationReader::take_semicolon() {
  if (is(at_, ';')) {
    ++at_;
    return true;
  }
  report(at_ - 1, fmt::format("`;` is missing behind `{}`", word(at_ - 1).substr(0, kMaxShownWord)));
  if (at_ < size() && !is_identifier(at_)) skip_statement();
  return false;
}

void DeclarationReader::read_statement() {
  if (is(at_, ';')) {
    outline_.empties.push_back(range_of(at_, at_));
    ++at_;
  } else if (word(at_) == "precision") {
    const std::size_t first = at_;
    at_ = std::min(at_ + 3, size());
    take_semicolon();
    outline_.precisions.push_back({token(first).begin, token(at_ - 1).end});
  } else if (is(at_ + 1, '(') && macros_.contains(word(at_))) {
    at_ = behind(at_ + 1);  // `DECLARE_NOISE(3)`: what it declares cannot be seen here
    if (is(at_, '{')) at_ = behind(at_);
  } else {
    read_declaration();
  }
}

void DeclarationReader::read_declaration() {
  DeclarationStart start;
  start.first = at_;
  read_qualifiers(start);
  if (is(at_, ';') && at_ > start.first) {
    ++at_;
    outline_.layouts.push_back({token(start.first).begin, token(at_ - 1).end});
    return;
  }
  if (word(at_) == "struct") {
    read_struct(start);
    return;
  }
  if (!is_identifier(at_)) {
    report_unexpected();
    skip_statement();
    return;
  }
  if (is(at_ + 1, '{')) {
    read_block(start);
    return;
  }
  const bool listed = at_ > start.first && is(at_ + 1, ',');
  const bool redeclares = start.storage == Storage::none && (is(at_ + 1, ';') || listed);
  if (redeclares) {  // `invariant gl_Position;`
    skip_statement();
    return;
  }
  start.type = range_of(at_, at_);
  ++at_;
  start.array = read_array();
  if (is_identifier(at_) && is_basic_type(word(at_)))
    report(at_, fmt::format("`{}` is a type, where a name was expected", word(at_)));
  if (is_identifier(at_) && is(at_ + 1, '(')) {
    read_function(start);
  } else {
    read_globals(start);
  }
}

void DeclarationReader::read_qualifiers(DeclarationStart& start) {
  std::size_t run_end = 0;
  while (is_identifier(at_)) {
    const QualifierKind kind = qualifier_kind(word(at_));
    if (kind == QualifierKind::none) {
      if (!read_macro_qualifier(start)) return;
    } else {
      read_qualifier(kind, run_end, start);
    }
  }
}

// `run_end` is the index behind the latest `flat`, `centroid`, ...: neighbours are kept as one text.
void DeclarationReader::read_qualifier(QualifierKind kind, std::size_t& run_end, DeclarationStart& start) {
  const std::size_t here = at_++;
  if (kind == QualifierKind::storage) apply_storage(word(here), start);
  if (kind == QualifierKind::layout && is(at_, '(')) {
    const std::size_t next = behind(at_);
    start.layout = text_of(range_of(here, next - 1));
    at_ = next;
  }
  if (kind == QualifierKind::interpolation) {
    if (start.qualifiers.end == 0) start.qualifiers.begin = token(here).begin;
    if (start.qualifiers.end == 0 || run_end == here) start.qualifiers.end = token(here).end;
    run_end = at_;
  }
}

// `#define PRECISION highp` or `#define VARYING varying`: an object-like macro that stands for qualifiers, or for nothing.
bool DeclarationReader::read_macro_qualifier(DeclarationStart& start) {
  const auto found = macros_.find(word(at_));
  if (found == macros_.end()) return false;
  const MacroOutline& macro = *found->second;
  if (macro.end - macro.begin > kMaxQualifierMacro) return false;
  const Token directive{TokenKind::directive, macro.begin, macro.end};
  std::vector<Token> words = directive_tokens(text_, directive);
  std::erase_if(words, [&](const Token& each) { return each.begin < macro.body_begin; });
  const bool only_qualifiers = std::ranges::all_of(
      words, [&](const Token& each) { return qualifier_kind(token_text(text_, each)) != QualifierKind::none; });
  if (!only_qualifiers) return false;
  for (const Token& each : words) apply_storage(token_text(text_, each), start);
  ++at_;
  return true;
}

void DeclarationReader::apply_storage(std::string_view word, DeclarationStart& start) const {
  if (word == "const") start.storage = Storage::constant;
  if (word == "uniform") start.storage = Storage::uniform;
  if (word == "in" || word == "attribute") start.storage = Storage::in;
  if (word == "out") start.storage = Storage::out;
  if (word == "varying") start.storage = varying_;
  if (word == "buffer") start.storage = Storage::buffer;
  if (word == "shared") start.storage = Storage::shared;
}

std::string_view DeclarationReader::read_array() {
  const std::size_t first = at_;
  while (is(at_, '[')) at_ = behind(at_);
  return at_ > first ? text_of(range_of(first, at_ - 1)) : std::string_view{};
}

void DeclarationReader::read_struct(DeclarationStart& start) {
  const std::size_t first = at_++;
  const bool named = is_identifier(at_);
  StructOutline type;
  if (named) type.name = word(at_++);
  if (!is(at_, '{')) {
    report_unexpected();
    return skip_statement();
  }
  type.name_begin = named ? token(at_ - 1).begin : token(at_).begin;
  type.begin = token(first).begin;
  at_ = behind(at_);
  type.end = token(at_ - 1).end;
  start.type = named ? range_of(first + 1, first + 1) : range_of(first, at_ - 1);
  start.array = read_array();
  const bool declares = is_identifier(at_) && word(at_) != "struct" && qualifier_kind(word(at_)) == QualifierKind::none;
  if (!declares && take_semicolon()) type.end = token(at_ - 1).end;
  outline_.structs.push_back(type);
  if (declares) read_globals(start);
}

void DeclarationReader::read_block(const DeclarationStart& start) {
  StructOutline block;
  block.storage = start.storage;
  block.name = word(at_);
  block.name_begin = token(at_).begin;
  block.begin = token(start.first).begin;
  at_ = behind(at_ + 1);
  if (is_identifier(at_)) {
    block.instance = word(at_);
    block.instance_begin = token(at_).begin;
    ++at_;
    read_array();
  }
  take_semicolon();
  block.end = token(at_ - 1).end;
  outline_.structs.push_back(block);
}

void DeclarationReader::read_function(const DeclarationStart& start) {
  FunctionOutline function;
  const std::size_t name = at_;
  const std::size_t open = name + 1;
  const std::size_t close = code_.closing[open];
  at_ = behind(open);
  if (!is(close, ')')) return;  // reported with the brackets
  function.return_type = text_of({start.type.begin, token(name - 1).end});
  function.name = word(name);
  function.name_begin = token(name).begin;
  function.parameters = read_parameters(text_, std::span(code_.tokens).subspan(open + 1, close - open - 1));
  function.parameters_begin = token(open).end;
  function.parameters_end = token(close).begin;
  function.begin = token(start.first).begin;
  if (is(at_, '{')) {
    function.body_begin = token(at_).begin;
    at_ = behind(at_);
    function.body_end = token(at_ - 1).end;
  } else {
    function.body_begin = function.body_end = token(close).end;
    if (!take_semicolon()) return;
  }
  function.end = token(at_ - 1).end;
  outline_.functions.push_back(std::move(function));
}

// One variable: `b[2] = x` in `float a, b[2] = x;`, read up to before the `,` or `;`.
void DeclarationReader::read_declarator(GlobalOutline& global) {
  const std::size_t first = at_++;
  global.name = word(first);
  global.name_begin = global.declarator_begin = token(first).begin;
  const std::string_view array = read_array();
  if (!array.empty()) global.array = array;
  global.initializer_begin = global.initializer_end = token(at_ - 1).end;
  if (is(at_, '=')) {
    const std::size_t value = ++at_;
    while (at_ < size() && !is(at_, ',') && !is(at_, ';')) at_ = behind(at_);
    if (at_ > value) {
      const TextRange range = range_of(value, at_ - 1);
      global.initializer_begin = range.begin;
      global.initializer_end = range.end;
    }
  }
  global.declarator_end = token(at_ - 1).end;
}

void DeclarationReader::read_globals(const DeclarationStart& start) {
  const std::size_t first = outline_.globals.size();
  GlobalOutline prototype;
  prototype.storage = start.storage;
  prototype.qualifiers = text_of(start.qualifiers);
  prototype.layout = start.layout;
  prototype.type = text_of(start.type);
  prototype.array = start.array;
  prototype.begin = token(start.first).begin;
  for (bool more = true; more;) {
    if (!is_identifier(at_)) {
      report_unexpected();
      skip_statement();
      break;
    }
    read_declarator(outline_.globals.emplace_back(prototype));
    more = is(at_, ',');
    if (more) {
      ++at_;
    } else {
      take_semicolon();
    }
  }
  for (GlobalOutline& global : std::span(outline_.globals).subspan(first)) {
    global.end = token(at_ - 1).end;
    global.declarator_count = static_cast<std::uint32_t>(outline_.globals.size() - first);
  }
}

// Functions stand in text order, so the one whose body holds a marker is found by bisection.
void place_markers(Outline& outline) {
  for (MarkerOutline& marker : outline.markers) {
    const auto next = std::ranges::upper_bound(outline.functions, marker.begin, {}, &FunctionOutline::begin);
    if (next == outline.functions.begin()) continue;
    const FunctionOutline& function = *(next - 1);
    if (function.body_begin <= marker.begin && marker.end <= function.body_end) {
      marker.enclosing_function = static_cast<std::uint32_t>(next - outline.functions.begin() - 1);
    }
  }
}

void order_problems(std::vector<OutlineProblem>& problems) {
  std::ranges::stable_sort(problems, {}, &OutlineProblem::begin);
  if (problems.size() <= kMaxProblems) return;
  problems.resize(kMaxProblems);
  problems.back().message += "; further problems are not listed";
}

}  // namespace

Outline outline(std::string_view text, const TokenList& tokens, Storage varying_storage) {
  Outline result;
  outline_directives(text, tokens.tokens, result);
  const BracketedCode code = match_brackets(text, tokens.tokens, result);
  DeclarationReader(text, code, varying_storage, result).run();
  place_markers(result);
  if (tokens.too_many) {  // what else is found is only due to the cut
    const Token& last = tokens.tokens.back();
    result.problems = {
        {last.begin, last.end, fmt::format("the text has more than {} tokens", kMaxShaderTokens), ProblemKind::fatal}};
  }
  order_problems(result.problems);
  return result;
}

}  // namespace plugc

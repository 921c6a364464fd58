// Bodies, initialisers and arrays are jumped over by their brackets, so the pass is linear and nothing recurses. A declaration
// that cannot be read is reported and passed over: up to behind its `;` or its `{...}`.

#include "glsl/declaration_reader.h"

#include <span>

#include <fmt/format.h>

#include "glsl/parameters.h"

namespace plugc {
namespace {

constexpr std::size_t kMaxShownWord = 60;

}  // namespace

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

}  // namespace plugc

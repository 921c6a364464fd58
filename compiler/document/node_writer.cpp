// A name keeps its letters; what X3D does not take in a name (part 2, 5.2: blanks, quotes, `#`, commas, dots, brackets,
// backslashes, braces, a digit or sign in front) becomes `_`, and the second of a name is `name_2` (of a long one, of its
// beginning).

#include "document/node_writer.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace plugc {
namespace {

bool may_stand_in_name(char c) {
  return static_cast<unsigned char>(c) > 0x20 && c != 0x7f &&
         std::string_view("\"'#,.[]\\{}").find(c) == std::string_view::npos;
}

bool is_word_of_the_language(std::string_view name) {
  constexpr std::array<std::string_view, 13> kWords = {"DEF",    "USE",    "IS",          "AS",   "TO",   "ROUTE", "PROTO",
                                                       "EXPORT", "IMPORT", "EXTERNPROTO", "TRUE", "NULL", "FALSE"};
  return std::ranges::find(kWords, name) != kWords.end();
}

std::string valid_name(std::string_view wanted) {
  std::string name(beginning_of(wanted, kMaxNameBytes - 1));  // it may get a `_` in front
  std::ranges::replace_if(
      name, [](char c) { return !may_stand_in_name(c); }, '_');
  const bool odd_start = !name.empty() && std::string_view("0123456789+-").find(name[0]) != std::string_view::npos;
  return odd_start || is_word_of_the_language(name) ? "_" + name : name;
}

}  // namespace

void NodeWriter::value(std::string_view field, const ValueSyntax& value, const Span& place) {
  build_.add_field({{field, place}, value}, place);
}

void NodeWriter::numbers(std::string_view field, std::span<const double> numbers, const Span& place) {
  std::vector<double>& pool = build_.document.numbers;
  const std::size_t first = pool.size();
  if (!numbers.empty() && !build_.may_add_number(place)) return;
  pool.insert(pool.end(), numbers.begin(), numbers.end());
  ValueSyntax value;
  value.kind = ValueKind::numbers;
  value.span = place;
  value.hold(build_.numbers_since(first));
  this->value(field, value, place);
}

void NodeWriter::numbers(std::string_view field, std::initializer_list<double> list, const Span& place) {
  numbers(field, std::span<const double>(list.begin(), list.size()), place);
}

void NodeWriter::boolean(std::string_view field, bool written, const Span& place) {
  const std::size_t first = build_.document.numbers.size();
  build_.document.numbers.push_back(written ? 1 : 0);
  ValueSyntax value;
  value.kind = ValueKind::booleans;
  value.span = place;
  value.hold(build_.numbers_since(first));
  this->value(field, value, place);
}

void NodeWriter::string(std::string_view field, std::string_view written, const Span& place) {
  MappedText text;
  text.append_generated(written, place);
  string(field, std::move(text), place);
}

void NodeWriter::string(std::string_view field, MappedText text, const Span& place) {
  ValueSyntax value;
  value.kind = ValueKind::strings;
  value.span = place;
  value.hold(build_.add_string(std::move(text), place));
  if (value.count != 0) this->value(field, value, place);
}

void NodeWriter::use(const Name& def, const Span& place) {
  NodeSyntax node;
  NodeExtras extras;
  extras.use = {def.text, place};
  node.span = place;
  build_.give(node, extras);
  build_.add_list_node(node);
}

Name NodeWriter::define(std::string_view wanted, std::string_view otherwise, const Span& place) {
  constexpr std::size_t kNumberedBytes = 64;  // of a name that may be there any number of times
  Name whole{wanted.empty() ? otherwise : wanted, place};
  build_.limit(whole);
  std::string name = valid_name(whole.text);
  if (!names_.try_emplace(name, 1).second) {
    const std::string beginning(beginning_of(name, kNumberedBytes));
    std::size_t& last = names_[beginning];
    do {
      last = std::max<std::size_t>(last + 1, 2);
      name = fmt::format("{}_{}", beginning, last);
    } while (!names_.try_emplace(name, 1).second);
  }
  return {build_.document.decoded_names.emplace_back(std::move(name)), place};
}

void NodeWriter::end_document(std::size_t mark) {
  std::vector<NodeSyntax> roots;
  build_.nodes.close(mark, roots);
  const std::size_t statements = build_.statements.open();
  for (const NodeSyntax& root : roots) build_.add_statement(root);
  build_.document.statements = build_.statements.close(statements, build_.document.statement_pool);
}

}  // namespace plugc

// A walk in the order of the text, two spaces a level, each line beginning with its place. Long lists of numbers show
// their first items and their length: the dump is for reading and for comparing, not for reading back.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "document/read_document.h"

namespace plugc {
namespace {

constexpr std::size_t kShownNumbers = 16;
constexpr std::size_t kMaxIndentation = 64;  // levels; deeper nodes would fill the dump with blanks

class Dump {
 public:
  Dump(const Document& document, const SourceSet& sources) : document_(document), sources_(sources) {}

  std::string take() && { return std::move(text_); }
  void header();
  void head();
  void statements(Range<StatementSyntax> range);

 private:
  template <typename... Arguments>
  void line(const Span& span, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const Position at = span.valid() ? sources_.position(span.source, span.begin) : Position{};
    text_.append(2 * std::min(level_, kMaxIndentation), ' ');
    text_ += fmt::format("{}:{} ", at.line, at.column);
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  void statement(const StatementSyntax& statement);
  void node(const NodeSyntax& node);
  void proto(const ProtoSyntax& proto);
  void interface(const InterfaceSyntax& field);
  void nested_nodes(const ValueSyntax& value);
  std::string value_text(const ValueSyntax& value) const;
  std::string numbers_text(const ValueSyntax& value) const;
  std::string strings_text(Range<MappedText> strings) const;

  const Document& document_;
  const SourceSet& sources_;
  std::string text_;
  std::size_t level_ = 0;
};

std::string quoted(std::string_view text) {
  std::string quoted(1, '"');
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else {
      quoted += c;
    }
  }
  quoted += '"';
  return quoted;
}

std::string_view encoding_name(Encoding encoding) {
  switch (encoding) {
    case Encoding::classic: return "classic";
    case Encoding::vrml2: return "vrml";
    case Encoding::xml: return "xml";
    case Encoding::json: return "json";
    case Encoding::gltf: return "gltf";
    case Encoding::vrml1: return "vrml1";
  }
  return "";
}

void Dump::header() {
  text_ +=
      fmt::format("document {} {}.{}\n", encoding_name(document_.encoding), document_.version_major, document_.version_minor);
}

void Dump::head() {
  const HeadSyntax& head = document_.head;
  if (!head.profile.empty()) line(head.profile.span, "PROFILE {}", head.profile.text);
  for (const ComponentSyntax& one : head.components) line(one.span, "COMPONENT {}:{}", one.name.text, one.level);
  for (const UnitSyntax& one : head.units) line(one.span, "UNIT {} {} {}", one.category.text, one.name.text, one.factor);
  for (const MetaSyntax& one : head.metas) line(one.span, "META {} {}", quoted(one.name.text), quoted(one.content.text));
}

void Dump::statements(Range<StatementSyntax> range) {
  for (const StatementSyntax& one : document_.of(range)) statement(one);
}

void Dump::statement(const StatementSyntax& statement) {
  switch (statement.kind) {
    case StatementKind::node: return node(document_.nodes[statement.index]);
    case StatementKind::proto:
    case StatementKind::externproto: return proto(document_.protos[statement.index]);
    case StatementKind::route: {
      const RouteSyntax& route = document_.routes[statement.index];
      return line(route.span, "ROUTE {}.{} TO {}.{}", route.from_node.text, route.from_field.text, route.to_node.text,
                  route.to_field.text);
    }
    case StatementKind::import: {
      const ImportSyntax& import = document_.imports[statement.index];
      return line(import.span, "IMPORT {}.{} AS {}", import.inline_def.text, import.name.text, import.alias.text);
    }
    case StatementKind::export_: {
      const ImportSyntax& exported = document_.imports[statement.index];
      return line(exported.span, "EXPORT {} AS {}", exported.name.text, exported.alias.text);
    }
  }
}

void Dump::proto(const ProtoSyntax& proto) {
  const bool external = !proto.urls.empty();
  line(proto.span, "{} {}{}{}", external ? "EXTERNPROTO" : "PROTO", proto.name.text, external ? " " : "",
       strings_text(proto.urls));
  ++level_;
  for (const InterfaceSyntax& field : document_.of(proto.interface)) interface(field);
  statements(proto.body);
  --level_;
}

void Dump::node(const NodeSyntax& node) {
  const NodeExtras& extras = *node.extras;
  if (!extras.use.empty()) {
    line(node.span, "USE {}", extras.use.text);
  } else {
    line(node.span, "{}{}{}{}", extras.def.empty() ? "" : "DEF ", extras.def.text, extras.def.empty() ? "" : " ",
         node.type.text);
  }
  ++level_;
  if (!extras.container_field.empty()) line(extras.container_field.span, "containerField {}", extras.container_field.text);
  for (const InterfaceSyntax& field : document_.of(extras.interface)) interface(field);
  for (const FieldSyntax& field : document_.of(node.fields)) {
    line(field.name.span, "field {}{}", field.name.empty() ? "-" : field.name.text, value_text(field.value));
    nested_nodes(field.value);
  }
  statements(extras.statements);
  for (const MappedText& text : document_.of(extras.cdata)) line(text.locate(0, 1), "text {}", quoted(text.text()));
  --level_;
}

void Dump::interface(const InterfaceSyntax& field) {
  line(field.span, "{} {} {}{}", to_text(field.access), field.type.text, field.name.text, value_text(field.value));
  nested_nodes(field.value);
}

void Dump::nested_nodes(const ValueSyntax& value) {
  ++level_;
  for (const NodeSyntax& one : document_.of(value.nodes())) node(one);
  --level_;
}

std::string Dump::value_text(const ValueSyntax& value) const {
  switch (value.kind) {
    case ValueKind::none: return "";
    case ValueKind::empty: return " [ ]";
    case ValueKind::nodes: return value.count == 0 ? " NULL" : "";
    case ValueKind::is: return fmt::format(" IS {}", document_.of(value.strings()).front().text());
    case ValueKind::lexical: return fmt::format(" = {}", strings_text(value.strings()));
    case ValueKind::numbers:
    case ValueKind::booleans: return numbers_text(value);
    case ValueKind::strings: return fmt::format("{}{}", value.bracketed ? " [ ] " : " ", strings_text(value.strings()));
  }
  return "";
}

std::string Dump::numbers_text(const ValueSyntax& value) const {
  const auto numbers = document_.of(value.numbers());
  std::string text = value.bracketed ? " [ ]" : "";
  for (const double number : numbers.first(std::min(numbers.size(), kShownNumbers))) {
    text += value.kind == ValueKind::booleans ? (number != 0 ? " TRUE" : " FALSE") : fmt::format(" {}", number);
  }
  if (numbers.size() > kShownNumbers) text += fmt::format(" ... ({} numbers)", numbers.size());
  return text;
}

std::string Dump::strings_text(Range<MappedText> strings) const {
  std::string text;
  for (const MappedText& string : document_.of(strings)) {
    if (!text.empty()) text += ' ';
    text += quoted(string.text());
  }
  return text;
}

}  // namespace

std::string_view to_text(AccessType access) {
  switch (access) {
    case AccessType::initialize_only: return "initializeOnly";
    case AccessType::input_only: return "inputOnly";
    case AccessType::output_only: return "outputOnly";
    case AccessType::input_output: return "inputOutput";
  }
  return "";
}

std::string dump_document(const Document& document, const SourceSet& sources) {
  Dump dump(document, sources);
  dump.header();
  dump.head();
  dump.statements(document.statements);
  return std::move(dump).take();
}

}  // namespace plugc

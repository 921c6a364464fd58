// Nodes, fields and statements as the grammar has them (ISO/IEC 19776-2, annex A), one field a line.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "document/characters.h"
#include "document/code_url.h"
#include "document/layout.h"
#include "document/read_document.h"
#include "document/write_document.h"
#include "document/written_nodes.h"

namespace plugc {
namespace {

constexpr NumberWords kWords{" ", ", ", "TRUE", "FALSE"};

/// A name with the codes of characters that no name may hold: `2 b` to `_x32__x20_b`.
std::string name_text(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (is_a(c, text.empty() ? kWordStart : kWordRest)) {
      text += c;
    } else {
      text += fmt::format("_x{:02x}_", static_cast<unsigned char>(c));
    }
  }
  return text;
}

std::string quoted(std::string_view string) {
  std::string text(1, '"');
  for (std::size_t i = 0; i < string.size(); ++i) {
    const char c = string[i];
    if (c == '\r' && string.substr(i + 1, 1) == "\n") continue;
    if (c == '"' || c == '\\') text += '\\';
    text += c == '\r' ? '\n' : c;
  }
  return text + '"';
}

/// What stands where a field has no value and the grammar wants one.
std::string usual_value(std::string_view type, std::size_t components) {
  if (type.starts_with("MF")) return "[ ]";
  if (type == "SFString") return "\"\"";
  if (type == "SFBool") return "FALSE";
  if (type == "SFNode") return "NULL";
  if (type == "SFRotation") return "0 0 1 0";
  if (type == "SFImage") return "0 0 0";
  std::string zeros = "0";
  for (std::size_t i = 1; i < components; ++i) zeros += " 0";
  return zeros;
}

class ClassicWriter {
 public:
  explicit ClassicWriter(const Document& document) : document_(document) {}
  std::string write();

 private:
  template <typename... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += indentation(level_);
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  void write_head();
  void write_statements(Range<StatementSyntax> statements);
  void write_statement(const StatementSyntax& statement);
  void write_prototype(const ProtoSyntax& prototype, bool external);
  void write_interface(const InterfaceSyntax& field, bool with_value);
  void write_node(const NodeSyntax& node);
  void write_fields(const NodeSyntax& node);
  void write_field(const FieldSyntax& field);
  void write_url(const NodeSyntax& node, const FieldSyntax* field);
  void write_value(const ValueSyntax& value);
  void write_nodes(const ValueSyntax& value);
  void write_strings(const std::vector<std::string>& strings, bool bracketed);
  std::vector<std::string> strings_of(Range<MappedText> strings) const;

  const Document& document_;
  std::string text_;
  std::size_t level_ = 0;
};

std::string ClassicWriter::write() {
  text_ = fmt::format("#X3D V{}.{} utf8\n", document_.version_major, document_.version_minor);
  write_head();
  text_ += '\n';
  write_statements(document_.statements);
  return std::move(text_);
}

void ClassicWriter::write_head() {
  const HeadSyntax& head = document_.head;
  if (!head.profile.empty()) line("PROFILE {}", name_text(head.profile.text));
  for (const ComponentSyntax& one : head.components) line("COMPONENT {}:{}", name_text(one.name.text), one.level);
  for (const UnitSyntax& one : head.units) {
    line("UNIT {} {} {}", name_text(one.category.text), name_text(one.name.text), number_text(one.factor));
  }
  for (const MetaSyntax& one : head.metas) line("META {} {}", quoted(one.name.text), quoted(one.content.text));
}

// Statements

void ClassicWriter::write_statements(Range<StatementSyntax> statements) {
  for (const StatementSyntax& one : document_.of(statements)) write_statement(one);
}

void ClassicWriter::write_statement(const StatementSyntax& statement) {
  const std::uint32_t index = statement.index;
  switch (statement.kind) {
    case StatementKind::node:
      text_ += indentation(level_);
      write_node(document_.nodes[index]);
      text_ += '\n';
      break;
    case StatementKind::proto: write_prototype(document_.protos[index], false); break;
    case StatementKind::externproto: write_prototype(document_.protos[index], true); break;
    case StatementKind::route: {
      const RouteSyntax& route = document_.routes[index];
      line("ROUTE {}.{} TO {}.{}", name_text(route.from_node.text), name_text(route.from_field.text),
           name_text(route.to_node.text), name_text(route.to_field.text));
      break;
    }
    case StatementKind::import:
    case StatementKind::export_: {
      const ImportSyntax& one = document_.imports[index];
      const std::string name = name_text(one.name.text);
      const bool renamed = !one.alias.empty() && one.alias.text != one.name.text;
      const std::string as = renamed ? " AS " + name_text(one.alias.text) : "";
      if (statement.kind == StatementKind::import) {
        line("IMPORT {}.{}{}", name_text(one.inline_def.text), name, as);
      } else {
        line("EXPORT {}{}", name, as);
      }
    }
  }
}

void ClassicWriter::write_prototype(const ProtoSyntax& prototype, bool external) {
  line("{} {} [", external ? "EXTERNPROTO" : "PROTO", name_text(prototype.name.text));
  ++level_;
  for (const InterfaceSyntax& field : document_.of(prototype.interface)) write_interface(field, !external);
  --level_;
  text_ += indentation(level_);
  if (external) {
    text_ += "] ";
    write_strings(strings_of(prototype.urls), true);
    text_ += '\n';
    return;
  }
  text_ += "] {\n";
  ++level_;
  write_statements(prototype.body);
  --level_;
  line("}}");
}

void ClassicWriter::write_interface(const InterfaceSyntax& field, bool with_value) {
  text_ += indentation(level_);
  text_ += fmt::format("{} {} {}", to_text(field.access), name_text(field.type.text), name_text(field.name.text));
  const bool has_value = field.access == AccessType::initialize_only || field.access == AccessType::input_output;
  if (field.value.kind == ValueKind::is || (has_value && with_value && field.value.kind != ValueKind::none)) {
    text_ += ' ';
    write_value(field.value);
  } else if (has_value && with_value) {
    text_ += ' ' + usual_value(field.type.text, field.value.components);
  }
  text_ += '\n';
}

// Nodes

/// Without blanks in front and a line's end behind.
void ClassicWriter::write_node(const NodeSyntax& node) {
  if (!node.extras->use.empty()) {
    text_ += "USE " + name_text(node.extras->use.text);
    return;
  }
  if (!node.extras->def.empty()) text_ += "DEF " + name_text(node.extras->def.text) + ' ';
  text_ += name_text(node.type.text);
  if (node.fields.empty() && node.extras->interface.empty() && node.extras->statements.empty() && node.extras->cdata.empty()) {
    text_ += " { }";
    return;
  }
  text_ += " {\n";
  const std::size_t body = text_.size() - 1;
  ++level_;
  const auto write_one = [&](const StatementSyntax& one) { write_statement(one); };
  each_statement(document_, node, false, write_one);
  for (const InterfaceSyntax& field : document_.of(node.extras->interface)) write_interface(field, true);
  write_fields(node);
  each_statement(document_, node, true, write_one);
  --level_;
  text_ += indentation(level_) + '}';
  join_lines(text_, body);
}

/// Code is a url; where the node has none, it stands with the plain values, in front of the nodes.
void ClassicWriter::write_fields(const NodeSyntax& node) {
  const auto fields = document_.of(node.fields);
  const auto is_url = [](const FieldSyntax& field) { return field.name.text == "url"; };
  const auto is_plain = [](const FieldSyntax& field) {
    return field.value.kind != ValueKind::nodes && field.value.kind != ValueKind::is;
  };
  const auto url = std::find_if(fields.begin(), fields.end(), is_url);
  const auto place = url != fields.end() ? url : std::find_if_not(fields.begin(), fields.end(), is_plain);
  for (auto field = fields.begin(); field != fields.end(); ++field) {
    if (field == place && !node.extras->cdata.empty()) write_url(node, url == fields.end() ? nullptr : &*url);
    if (field != url || node.extras->cdata.empty()) write_field(*field);
  }
  if (place == fields.end() && !node.extras->cdata.empty()) write_url(node, nullptr);
}

void ClassicWriter::write_field(const FieldSyntax& field) {
  text_ += indentation(level_) + name_text(field.name.text) + ' ';
  write_value(field.value);
  text_ += '\n';
}

/// Code stands behind the urls that the node has.
void ClassicWriter::write_url(const NodeSyntax& node, const FieldSyntax* field) {
  if (field != nullptr && field->value.kind != ValueKind::strings && field->value.kind != ValueKind::empty) {
    return write_field(*field);
  }
  std::vector<std::string> urls;
  if (field != nullptr) urls = strings_of(field->value.strings());
  for (const MappedText& code : document_.of(node.extras->cdata)) {
    urls.push_back(quoted(std::string(is_script(code.text()) ? "" : kPlainCode).append(code.text())));
  }
  text_ += indentation(level_) + "url ";
  write_strings(urls, urls.size() != 1);
  text_ += '\n';
}

// Values

void ClassicWriter::write_value(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::none:
    case ValueKind::empty: text_ += "[ ]"; break;
    case ValueKind::nodes: write_nodes(value); break;
    case ValueKind::is: text_ += "IS " + name_text(document_.of(value.strings()).front().text()); break;
    case ValueKind::lexical:
    case ValueKind::strings: write_strings(strings_of(value.strings()), value.bracketed); break;
    case ValueKind::numbers:
    case ValueKind::booleans: {
      const std::string numbers = numbers_text(document_, value, kWords, level_ + 1);
      text_ += value.bracketed ? list_text(numbers, level_) : numbers;
    }
  }
}

void ClassicWriter::write_nodes(const ValueSyntax& value) {
  const auto nodes = document_.of(value.nodes());
  if (nodes.empty()) {
    text_ += value.bracketed ? "[ ]" : "NULL";
  } else if (!value.bracketed) {
    write_node(nodes.front());
  } else {
    text_ += "[\n";
    ++level_;
    for (const NodeSyntax& node : nodes) {
      text_ += indentation(level_);
      write_node(node);
      text_ += '\n';
    }
    --level_;
    text_ += indentation(level_) + ']';
  }
}

std::vector<std::string> ClassicWriter::strings_of(Range<MappedText> strings) const {
  std::vector<std::string> texts;
  for (const MappedText& string : document_.of(strings)) texts.push_back(quoted(string.text()));
  return texts;
}

void ClassicWriter::write_strings(const std::vector<std::string>& strings, bool bracketed) {
  text_ += bracketed ? strings_list_text(strings, " ", level_) : fmt::format("{}", fmt::join(strings, " "));
}

}  // namespace

std::string write_classic(const Document& document) {
  return ClassicWriter(document).write();
}

}  // namespace plugc

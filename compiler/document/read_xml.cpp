// pugixml parses a copy in place and changes nothing in it, so that the offset of every name and value is that in the
// original text; what they say is then decoded from there (xml_text.h). The tree is walked to a depth of kMaxNesting.
// Source: ISO/IEC 19776-1; the mapping of statements: 4.3.
//
// After a mistake in the markup pugixml keeps what it had read; that much becomes the Document.

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/limits.h"
#include "document/read_document.h"
#include "document/read_lexical.h"
#include "document/xml_text.h"

namespace plugc {
namespace {

std::string_view problem_of(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_unrecognized_tag: return "this `<` begins no tag; write `&lt;` for the character";
    case pugi::status_bad_pi: return "a processing instruction is not closed by `?>`";
    case pugi::status_bad_comment: return "a comment is not closed by `-->`";
    case pugi::status_bad_cdata: return "a CDATA section is not closed by `]]>`";
    case pugi::status_bad_doctype: return "a document type declaration is not closed";
    case pugi::status_bad_pcdata: return "text ends where an end tag is needed";
    case pugi::status_bad_start_element: return "a start tag is not closed by `>`";
    case pugi::status_bad_attribute: return "an attribute needs the form `name=\"value\"`";
    case pugi::status_bad_end_element: return "an end tag is not closed by `>`";
    case pugi::status_no_document_element: return "this file holds no element";
    default: return "the markup cannot be read";
  }
}

/// What begins the thing that has no end, or "".
std::string_view opening_of(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_bad_pi: return "<?";
    case pugi::status_bad_comment: return "<!--";
    case pugi::status_bad_cdata: return "<![CDATA[";
    case pugi::status_bad_doctype: return "<!";
    default: return "";
  }
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

bool is_text(const pugi::xml_node& node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

/// Whether two names differ at most in the case of their letters.
bool is_spelled_like(std::string_view name, std::string_view wanted) {
  const auto same = [](char a, char b) { return (a | 0x20) == (b | 0x20); };
  return std::equal(name.begin(), name.end(), wanted.begin(), wanted.end(), same);
}

class XmlReader {
 public:
  XmlReader(SourceId source, const SourceSet& sources, Diagnostics& diagnostics)
      : build_(source, Encoding::xml, sources, diagnostics), source_(source), text_(sources.text(source)), buffer_(text_) {}

  Document read();

 private:
  // The file
  bool parse();
  std::size_t stop_of(const pugi::xml_parse_result& result) const;
  void report_markup(const pugi::xml_parse_result& result);
  void report_declarations();
  void read_root(const pugi::xml_node& root);
  void read_head(const pugi::xml_node& head);
  void read_scene(const pugi::xml_node& scene);

  // Places
  bool is_inside(const char* in_buffer) const;
  std::uint32_t offset_of(const char* in_buffer) const;
  Span tag_span(const pugi::xml_node& element) const;
  Span element_span(const pugi::xml_node& element) const;
  Span name_span(const pugi::xml_attribute& attribute) const;
  Span value_span(const pugi::xml_attribute& attribute) const;
  Span text_span(const pugi::xml_node& text) const;

  // Attributes
  Name value_name(const pugi::xml_attribute& attribute);
  Name optional_name(const pugi::xml_node& element, const char* attribute);
  Name required_name(const pugi::xml_node& element, const char* attribute);
  ValueSyntax lexical_value(const pugi::xml_attribute& attribute);
  void read_node_attribute(const pugi::xml_attribute& attribute, NodeExtras& extras);

  // Statements
  void read_statement(const pugi::xml_node& element);
  bool read_declaration(const pugi::xml_node& element);
  void read_route(const pugi::xml_node& element);
  void read_import(const pugi::xml_node& element);
  void read_export(const pugi::xml_node& element);
  void read_proto(const pugi::xml_node& element);
  void read_externproto(const pugi::xml_node& element);
  Range<InterfaceSyntax> read_interfaces(const pugi::xml_node& parent);

  // Nodes
  NodeSyntax read_node(const pugi::xml_node& element);
  void read_instance(const pugi::xml_node& element, NodeSyntax& node, NodeExtras& extras);
  void read_body(const pugi::xml_node& element);
  void read_child_node(const pugi::xml_node& element);
  void read_field_value(const pugi::xml_node& element);
  void read_interface(const pugi::xml_node& element);
  void read_value_children(const pugi::xml_node& element, ValueSyntax& value);
  void read_connections(const pugi::xml_node& element, const OpenBody& body);
  void reject_text(const pugi::xml_node& text);

  DocumentBuilder build_;
  SourceId source_;
  std::string_view text_;
  std::string buffer_;  // parsed in place
  pugi::xml_document tree_;
  XmlExtents extents_;
  mutable std::ptrdiff_t last_extent_ = 0;  // the last one that element_span() found
  std::uint32_t depth_ = 0;
};

// The file

Document XmlReader::read() {
  const std::size_t mark = build_.statements.open();
  if (parse()) read_root(tree_.document_element());
  build_.document.statements = build_.statements.close(mark, build_.document.statement_pool);
  return std::move(build_.document);
}

bool XmlReader::parse() {
  const auto tags = static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '<'));
  const auto attributes = static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '='));
  if (tags > 2 * kMaxDocumentItems || attributes > 2 * kMaxDocumentItems) {
    build_.diagnostics.report(DiagnosticId::scene_limit, {source_, 0, 0},
                              fmt::format("this file holds more than {} tags or attributes", 2 * kMaxDocumentItems));
    return false;
  }
  build_.expect(tags, tags + attributes, attributes);
  const unsigned keep_as_written = pugi::parse_cdata;  // no entities, line ends or attribute values converted
  const auto result = tree_.load_buffer_inplace(buffer_.data(), buffer_.size(), keep_as_written, pugi::encoding_utf8);
  extents_ = find_xml_extents(text_, result ? text_.size() : stop_of(result));
  report_declarations();
  if (!result) report_markup(result);
  return !tree_.document_element().empty();
}

/// Where the tags end that came before the mistake: in front of an end tag that does not fit, else at the mistake.
std::size_t XmlReader::stop_of(const pugi::xml_parse_result& result) const {
  if (result.status != pugi::status_end_element_mismatch) return static_cast<std::size_t>(result.offset);
  const std::size_t tag = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 2)) - 2;
  return text_.substr(tag, 2) == "</" ? tag : text_.size();
}

void XmlReader::report_markup(const pugi::xml_parse_result& result) {
  std::size_t at = stop_of(result);
  std::string message(problem_of(result.status));
  if (const std::string_view opening = opening_of(result.status); !opening.empty()) {
    at = std::min(at, text_.rfind(opening, at));  // pugixml tells where the text ended
  } else if (result.status == pugi::status_end_element_mismatch) {
    message = extents_.open.empty() ? "this end tag closes nothing"
              : at == text_.size()
                  ? fmt::format("`<{}>` is not closed before the end of the file", shown(extents_.open.back()))
                  : fmt::format("this end tag does not close `<{}>`, which is open here", shown(extents_.open.back()));
  }
  const std::size_t end = std::min(at + 1, text_.size());
  build_.mistake({source_, static_cast<std::uint32_t>(std::min(at, end)), static_cast<std::uint32_t>(end)}, std::move(message));
}

/// A scene needs no entities of its own; what others do with those (expand them without end, read files by them) is never done.
void XmlReader::report_declarations() {
  const std::size_t begin = text_.find("<!DOCTYPE");
  const std::size_t root = text_.find("<X3D");
  if (begin >= root) return;
  const std::size_t bracket = text_.find_first_of("[>", begin);
  if (bracket == std::string_view::npos || text_[bracket] != '[') return;
  const auto at = static_cast<std::uint32_t>(bracket);
  build_.diagnostics.report(DiagnosticId::doctype_subset, {source_, at, at + 1},
                            "declarations of a document type are passed over; plugc knows the five entities of XML alone");
}

void XmlReader::read_root(const pugi::xml_node& root) {
  const std::string_view root_name = root.name();
  if (root_name != "X3D") {
    build_.mistake(tag_span(root), fmt::format("expected `<X3D>`, found `<{}>`", shown(root_name)));
    if (root_name == "Scene") return read_scene(root);
    if (!is_spelled_like(root_name, "X3D")) return;
  }
  if (const auto version = root.attribute("version")) set_version(build_, version.value(), value_span(version));
  const std::size_t mistakes = build_.mistake_count();
  build_.document.head.profile = optional_name(root, "profile");
  bool found = false;
  for (const auto& child : root.children()) {
    const std::string_view name = child.name();
    if (is_spelled_like(name, "Scene")) {
      if (name != "Scene") {
        build_.mistake(tag_span(child), fmt::format("expected `<Scene>`, found `<{}>`", shown(name)));
      } else if (found) {
        build_.mistake(tag_span(child), "`<X3D>` holds one `<Scene>`; put these nodes into the first one");
      }
      found = true;
      read_scene(child);
    } else if (is_text(child)) {
      reject_text(child);
    } else if (name == "head" || name == "Header") {
      read_head(child);
    } else {
      build_.mistake(tag_span(child), fmt::format("expected `<head>` or `<Scene>`, found `<{}>`", shown(name)));
    }
  }
  if (!found && build_.mistake_count() == mistakes) build_.mistake(tag_span(root), "`<X3D>` holds no `<Scene>`");
}

/// Other elements of a head (`<link>`, `<meta charset>`) say nothing about a scene.
void XmlReader::read_head(const pugi::xml_node& head) {
  for (const auto& child : head.children()) {
    const std::string_view element = child.name();
    const Name name = optional_name(child, "name");
    if (name.empty()) continue;
    if (element == "component") build_.add_component(name, child.attribute("level").value(), element_span(child));
    if (element == "meta") build_.add_meta({name, optional_name(child, "content"), element_span(child)});
    if (element != "unit") continue;
    build_.add_unit(optional_name(child, "category"), name, child.attribute("conversionFactor").value(), element_span(child));
  }
}

void XmlReader::read_scene(const pugi::xml_node& scene) {
  for (const auto& child : scene.children()) {
    if (build_.stopped()) return;
    read_statement(child);
  }
}

// Places

bool XmlReader::is_inside(const char* in_buffer) const {
  const std::less_equal<> at_most;
  return at_most(buffer_.data(), in_buffer) && at_most(in_buffer, buffer_.data() + buffer_.size());
}

/// pugixml hands out a static "" where nothing was written; that lies outside and counts as the start of the text.
std::uint32_t XmlReader::offset_of(const char* in_buffer) const {
  return is_inside(in_buffer) ? static_cast<std::uint32_t>(in_buffer - buffer_.data()) : 0;
}

Span XmlReader::tag_span(const pugi::xml_node& element) const {
  const std::uint32_t begin = offset_of(element.name());
  return {source_, begin, begin + static_cast<std::uint32_t>(std::string_view(element.name()).size())};
}

Span XmlReader::element_span(const pugi::xml_node& element) const {
  const Span tag = tag_span(element);
  const std::uint32_t begin = std::max(tag.begin, 1U) - 1;
  const auto& extents = extents_.elements;
  const auto lies_before = [&](const XmlExtent& extent) { return extent.begin < begin; };
  const auto last = extents.begin() + last_extent_;  // elements are read in their order, nearly
  const auto from = last != extents.end() && last->begin <= begin ? last : extents.begin();
  const auto near = std::find_if_not(from, from + std::min<std::ptrdiff_t>(extents.end() - from, 4), lies_before);
  const auto found =
      near != extents.end() && !lies_before(*near) ? near : std::partition_point(near, extents.end(), lies_before);
  last_extent_ = found - extents.begin();
  const bool exact = found != extents.end() && found->begin == begin;
  return {source_, begin, exact ? found->end : tag.end};
}

Span XmlReader::name_span(const pugi::xml_attribute& attribute) const {
  const std::uint32_t begin = offset_of(attribute.name());
  return {source_, begin, begin + static_cast<std::uint32_t>(std::string_view(attribute.name()).size())};
}

Span XmlReader::value_span(const pugi::xml_attribute& attribute) const {
  const std::uint32_t begin = offset_of(attribute.value());
  return {source_, begin, begin + static_cast<std::uint32_t>(std::string_view(attribute.value()).size())};
}

Span XmlReader::text_span(const pugi::xml_node& text) const {
  const std::uint32_t begin = offset_of(text.value());
  return {source_, begin, begin + static_cast<std::uint32_t>(std::string_view(text.value()).size())};
}

// Attributes

Name XmlReader::value_name(const pugi::xml_attribute& attribute) {
  const Span span = value_span(attribute);
  const std::string_view written = build_.sources.text(span);
  if (written.find('&') == std::string_view::npos) return {written, span};
  return {build_.document.decoded_names.emplace_back(decode_xml(span, build_).text()), span};
}

Name XmlReader::optional_name(const pugi::xml_node& element, const char* attribute) {
  const auto found = element.attribute(attribute);
  return found ? value_name(found) : Name{};
}

Name XmlReader::required_name(const pugi::xml_node& element, const char* attribute) {
  const Name name = optional_name(element, attribute);
  if (name.empty())
    build_.mistake(tag_span(element), fmt::format("`<{}>` needs the attribute `{}`", element.name(), attribute));
  return name;
}

ValueSyntax XmlReader::lexical_value(const pugi::xml_attribute& attribute) {
  ValueSyntax value;
  value.kind = ValueKind::lexical;
  value.span = value_span(attribute);
  const std::size_t mistakes = build_.mistake_count();
  value.hold(build_.add_string(decode_xml(value.span, build_), value.span));
  value.damaged = build_.mistake_count() != mistakes;
  if (value.count == 0) value.kind = ValueKind::none;  // not admitted
  return value;
}

void XmlReader::read_node_attribute(const pugi::xml_attribute& attribute, NodeExtras& extras) {
  const std::string_view name = attribute.name();
  if (!is_inside(attribute.value())) return;  // the markup ends in front of the value
  const Name* twice = name == "DEF" ? &extras.def : name == "USE" ? &extras.use : &extras.container_field;
  if ((twice != &extras.container_field || name == "containerField") && !twice->empty()) {
    build_.mistake(name_span(attribute), fmt::format("`{}` is given twice", name));
  }
  if (name == "DEF") {
    extras.def = value_name(attribute);
  } else if (name == "USE") {
    extras.use = value_name(attribute);
  } else if (name == "containerField") {
    extras.container_field = value_name(attribute);
  } else if (name != "class" && name != "id" && name.find(':') == std::string_view::npos && name != "xmlns") {
    const Span span = name_span(attribute);
    build_.add_field({{build_.sources.text(span), span}, lexical_value(attribute)}, span);
  }
}

// Statements

void XmlReader::read_statement(const pugi::xml_node& element) {
  if (is_text(element)) return reject_text(element);
  if (element.type() != pugi::node_element || read_declaration(element)) return;
  build_.add_statement(read_node(element));
}

/// The statements that may also stand inside a node.
bool XmlReader::read_declaration(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  if (name == "ROUTE") {
    read_route(element);
  } else if (name == "IMPORT") {
    read_import(element);
  } else if (name == "EXPORT") {
    read_export(element);
  } else if (name == "ProtoDeclare") {
    read_proto(element);
  } else if (name == "ExternProtoDeclare") {
    read_externproto(element);
  } else {
    return false;
  }
  return true;
}

void XmlReader::read_route(const pugi::xml_node& element) {
  const RouteSyntax route{required_name(element, "fromNode"), required_name(element, "fromField"),
                          required_name(element, "toNode"), required_name(element, "toField"), element_span(element)};
  const bool complete =
      !route.from_node.empty() && !route.from_field.empty() && !route.to_node.empty() && !route.to_field.empty();
  if (complete) build_.add_statement(route);
}

void XmlReader::read_import(const pugi::xml_node& element) {
  ImportSyntax import{required_name(element, "inlineDEF"), optional_name(element, "exportedDEF"), optional_name(element, "AS"),
                      element_span(element)};
  if (import.name.empty()) import.name = required_name(element, "importedDEF");
  if (import.alias.empty()) import.alias = import.name;
  if (!import.inline_def.empty() && !import.name.empty()) build_.add_statement(StatementKind::import, import);
}

void XmlReader::read_export(const pugi::xml_node& element) {
  ImportSyntax exported{{}, required_name(element, "localDEF"), optional_name(element, "AS"), element_span(element)};
  if (exported.alias.empty()) exported.alias = exported.name;
  if (!exported.name.empty()) build_.add_statement(StatementKind::export_, exported);
}

void XmlReader::read_proto(const pugi::xml_node& element) {
  ProtoSyntax proto;
  proto.name = required_name(element, "name");
  proto.span = element_span(element);
  if (depth_ >= kMaxNesting) return build_.too_deep(tag_span(element));
  ++depth_;
  proto.interface = read_interfaces(element.child("ProtoInterface"));
  const auto body = element.child("ProtoBody");
  if (!body) build_.mistake(tag_span(element), "`<ProtoDeclare>` holds no `<ProtoBody>`");
  const std::size_t mark = build_.statements.open();
  read_scene(body);
  proto.body = build_.statements.close(mark, build_.document.statement_pool);
  --depth_;
  if (!proto.name.empty()) build_.add_statement(StatementKind::proto, proto);
}

void XmlReader::read_externproto(const pugi::xml_node& element) {
  ProtoSyntax proto;
  proto.name = required_name(element, "name");
  proto.span = element_span(element);
  proto.interface = read_interfaces(element);
  const auto url = element.attribute("url");
  if (!url) return build_.mistake(tag_span(element), "`<ExternProtoDeclare>` needs the attribute `url`");
  const std::size_t first = build_.document.strings.size();
  for (MappedText& text : read_lexical_strings(decode_xml(value_span(url), build_), build_.diagnostics)) {
    build_.add_string(std::move(text), value_span(url));
  }
  proto.urls = build_.strings_since(first);
  if (!proto.name.empty()) build_.add_statement(StatementKind::externproto, proto);
}

Range<InterfaceSyntax> XmlReader::read_interfaces(const pugi::xml_node& parent) {
  const std::size_t mark = build_.interfaces.open();
  for (const auto& child : parent.children()) {
    if (build_.stopped()) break;
    if (std::string_view(child.name()) == "field") {
      read_interface(child);
    } else if (is_text(child)) {
      reject_text(child);
    } else {
      build_.mistake(tag_span(child), fmt::format("expected `<field>`, found `<{}>`", shown(child.name())));
    }
  }
  return build_.interfaces.close(mark, build_.document.interfaces);
}

// Nodes

NodeSyntax XmlReader::read_node(const pugi::xml_node& element) {
  NodeSyntax node;
  node.span = element_span(element);
  if (depth_ >= kMaxNesting) {
    build_.too_deep(tag_span(element));
    node.type = {build_.sources.text(tag_span(element)), tag_span(element)};
    return node;
  }
  ++depth_;
  NodeExtras extras;
  const OpenBody body = build_.open_body();
  if (std::string_view(element.name()) == "ProtoInstance") {
    read_instance(element, node, extras);
  } else {
    node.type = {build_.sources.text(tag_span(element)), tag_span(element)};
    for (const auto& attribute : element.attributes()) read_node_attribute(attribute, extras);
  }
  read_body(element);
  if (element.child("IS")) read_connections(element, body);
  build_.close_body(body, node, extras);
  --depth_;
  return node;
}

void XmlReader::read_instance(const pugi::xml_node& element, NodeSyntax& node, NodeExtras& extras) {
  extras.def = optional_name(element, "DEF");
  extras.use = optional_name(element, "USE");
  extras.container_field = optional_name(element, "containerField");
  node.is_instance = true;
  node.type = extras.use.empty() ? required_name(element, "name") : optional_name(element, "name");
}

void XmlReader::read_body(const pugi::xml_node& element) {
  for (const auto& child : element.children()) {
    if (build_.stopped()) return;
    const std::string_view name = child.name();
    if (is_text(child)) {
      const bool blank = child.type() == pugi::node_pcdata && is_blank(child.value());
      const Span span = text_span(child);
      if (blank) continue;
      const bool verbatim = child.type() == pugi::node_cdata;
      MappedText text;
      if (verbatim) append_with_line_feeds(text, build_.sources, span);
      build_.add_cdata(verbatim ? std::move(text) : decode_xml(span, build_), span);
    } else if (name == "field") {
      read_interface(child);
    } else if (name == "fieldValue") {
      read_field_value(child);
    } else if (name != "IS" && !read_declaration(child)) {
      read_child_node(child);
    }
  }
}

void XmlReader::read_child_node(const pugi::xml_node& element) {
  FieldSyntax field;
  field.name.span = tag_span(element);
  field.value.kind = ValueKind::nodes;
  field.value.span = element_span(element);
  const std::size_t mark = build_.nodes.open();
  build_.add_list_node(read_node(element));
  field.value.hold(build_.nodes.close(mark, build_.document.nodes));
  build_.add_field(field, field.name.span);
}

void XmlReader::read_field_value(const pugi::xml_node& element) {
  FieldSyntax field;
  field.name = required_name(element, "name");
  if (const auto value = element.attribute("value")) field.value = lexical_value(value);
  read_value_children(element, field.value);
  if (field.value.kind == ValueKind::none) {
    return build_.mistake(tag_span(element), "`<fieldValue>` needs the attribute `value` or nodes inside");
  }
  if (!field.name.empty()) build_.add_field(field, field.name.span);
}

void XmlReader::read_interface(const pugi::xml_node& element) {
  InterfaceSyntax field;
  const Name access = required_name(element, "accessType");
  field.type = required_name(element, "type");
  field.name = required_name(element, "name");
  field.span = element_span(element);
  if (!access.empty()) field.access = access_type(build_, access);
  if (const auto value = element.attribute("value")) field.value = lexical_value(value);
  read_value_children(element, field.value);
  if (!field.type.empty() && !field.name.empty()) build_.add_interface(field);
}

/// The nodes inside a `<field>` or `<fieldValue>` are its value.
void XmlReader::read_value_children(const pugi::xml_node& element, ValueSyntax& value) {
  const std::size_t mark = build_.nodes.open();
  bool any = false;
  for (const auto& child : element.children()) {
    if (build_.stopped()) break;
    if (is_text(child)) {
      reject_text(child);
    } else {
      any = true;
      build_.add_list_node(read_node(child));
    }
  }
  const auto nodes = build_.nodes.close(mark, build_.document.nodes);
  if (!any) return;
  value = {};
  value.kind = ValueKind::nodes;
  value.span = element_span(element);
  value.hold(nodes);
}

/// The `<IS>` of a node, read behind its fields.
void XmlReader::read_connections(const pugi::xml_node& element, const OpenBody& body) {
  std::vector<Connection> connections;
  for (const auto& is : element.children("IS")) {
    for (const auto& child : is.children()) {
      if (std::string_view(child.name()) != "connect") {
        build_.mistake(is_text(child) ? text_span(child) : tag_span(child), "expected `<connect>` inside `<IS>`");
        continue;
      }
      const Connection connect{required_name(child, "nodeField"), required_name(child, "protoField")};
      if (!connect.node_field.empty() && !connect.proto_field.empty()) connections.push_back(connect);
    }
  }
  build_.add_connections(body, connections);
}

void XmlReader::reject_text(const pugi::xml_node& text) {
  const std::string_view written = text.value();
  if (is_blank(written)) return;
  Span span = text_span(text);
  span.end = span.begin + static_cast<std::uint32_t>(written.find_last_not_of(" \t\r\n") + 1);
  span.begin += static_cast<std::uint32_t>(written.find_first_not_of(" \t\r\n"));
  build_.mistake(span, "text stands where only elements may");
}

}  // namespace

Document read_xml(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  return XmlReader(source, sources, diagnostics).read();
}

}  // namespace plugc

// Every added item passes admit(), which stops the reading when a file holds more of them than plugc keeps in memory.
// An item that is not admitted is dropped: the Document stays consistent, only incomplete.

#include "document/document_builder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <unordered_map>

#include <fmt/format.h>

#include "document/scan_number.h"

namespace plugc {
DocumentBuilder::DocumentBuilder(SourceId source, Encoding encoding, const SourceSet& texts, Diagnostics& sink)
    : sources(texts), diagnostics(sink) {
  document.source = source;
  document.encoding = encoding;
}

void DocumentBuilder::mistake(const Span& span, std::string message) {
  if (stopped_) return;
  diagnostics.report(DiagnosticId::syntax, span, std::move(message));
  if (++mistakes_ < kMaxSyntaxMistakes) return;
  stopped_ = true;
  diagnostics.report(DiagnosticId::syntax, span,
                     fmt::format("this file has {} mistakes; the rest of it is not read", kMaxSyntaxMistakes));
}

void DocumentBuilder::too_deep(const Span& span) {
  if (stopped_) return;
  diagnostics.report(DiagnosticId::nesting_limit, span,
                     fmt::format("nodes are nested more than {} deep; this one is passed over", kMaxNesting));
  if (++mistakes_ >= kMaxSyntaxMistakes) stopped_ = true;
}

void DocumentBuilder::expect(std::size_t nodes_written, std::size_t fields_written, std::size_t strings_written) {
  document.nodes.reserve(std::min(nodes_written, kMaxDocumentItems));
  document.fields.reserve(std::min(fields_written, kMaxDocumentItems));
  document.strings.reserve(std::min(strings_written, kMaxDocumentItems));
}

void DocumentBuilder::stop_at_limit(const Span& place, std::size_t limit, std::string_view of) {
  if (stopped_) return;
  stopped_ = true;
  diagnostics.report(DiagnosticId::scene_limit, place,
                     fmt::format("this file holds more than {} {}; the rest of it is not read", limit, of));
}

OpenBody DocumentBuilder::open_body() const {
  return {fields.open(), interfaces.open(), statements.open(), cdata.open()};
}

void DocumentBuilder::cut(Name& name) {
  diagnostics.report(DiagnosticId::syntax, name.span,
                     fmt::format("a name is longer than {} bytes; only its beginning counts", kMaxNameBytes));
  name.text = beginning_of(name.text, kMaxNameBytes);
}

void DocumentBuilder::give(NodeSyntax& node, NodeExtras& extras) {
  limit(node.type);
  for (Name* name : {&extras.def, &extras.use, &extras.container_field}) limit(*name);
  if (extras.any()) node.extras = &document.extras.emplace_back(extras);
}

void DocumentBuilder::close_body(const OpenBody& body, NodeSyntax& node, NodeExtras& extras) {
  node.fields = fields.close(body.fields, document.fields);
  extras.interface = interfaces.close(body.interface, document.interfaces);
  extras.statements = statements.close(body.statements, document.statement_pool);
  extras.cdata = cdata.close(body.cdata, document.strings);
  give(node, extras);
}

void DocumentBuilder::add_interface(InterfaceSyntax field) {
  limit(field.name);
  limit(field.type);
  if (admit(field.span)) interfaces.add(std::move(field));
}

void DocumentBuilder::add_cdata(MappedText text, const Span& place) {
  if (admit(place)) cdata.add(std::move(text));
}

void DocumentBuilder::add_connections(const OpenBody& body, std::span<const Connection> connections) {
  if (connections.empty()) return;
  std::unordered_map<std::string_view, InterfaceSyntax*> declared;
  std::for_each(interfaces.begin(body.interface), interfaces.end(),
                [&](InterfaceSyntax& field) { declared.emplace(field.name.text, &field); });
  for (const auto& [node_field, proto_field] : connections) {
    MappedText name;
    name.append_generated(proto_field.text, proto_field.span);
    ValueSyntax value;
    value.kind = ValueKind::is;
    value.span = proto_field.span;
    value.hold(add_string(std::move(name), proto_field.span));
    if (value.count == 0) return;  // not admitted
    if (const auto found = declared.find(node_field.text); found != declared.end()) {
      found->second->value = value;
    } else {
      add_field({node_field, value}, node_field.span);
    }
  }
}

void DocumentBuilder::add_statement(NodeSyntax node) {
  if (is_nameless(node) || !admit(node.span)) return;
  statements.add({StatementKind::node, static_cast<std::uint32_t>(document.nodes.size())});
  document.nodes.push_back(std::move(node));
}

void DocumentBuilder::add_statement(RouteSyntax route) {
  for (Name* name : {&route.from_node, &route.from_field, &route.to_node, &route.to_field}) limit(*name);
  if (!admit(route.span)) return;
  statements.add({StatementKind::route, static_cast<std::uint32_t>(document.routes.size())});
  document.routes.push_back(std::move(route));
}

void DocumentBuilder::add_statement(StatementKind kind, ProtoSyntax proto) {
  limit(proto.name);
  if (!admit(proto.span)) return;
  statements.add({kind, static_cast<std::uint32_t>(document.protos.size())});
  document.protos.push_back(std::move(proto));
}

void DocumentBuilder::add_statement(StatementKind kind, ImportSyntax import) {
  for (Name* name : {&import.inline_def, &import.name, &import.alias}) limit(*name);
  if (!admit(import.span)) return;
  statements.add({kind, static_cast<std::uint32_t>(document.imports.size())});
  document.imports.push_back(std::move(import));
}

/// Where `part` stands, if it is a view of the source text; else `whole`.
Span DocumentBuilder::place_of(std::string_view part, const Span& whole) const {
  const std::string_view text = sources.text(document.source);
  const bool inside = std::less_equal<>()(text.data(), part.data()) &&
                      std::less_equal<>()(part.data() + part.size(), text.data() + text.size());
  if (part.empty() || !inside) return whole;
  const auto begin = static_cast<std::uint32_t>(part.data() - text.data());
  return {document.source, begin, begin + static_cast<std::uint32_t>(part.size())};
}

void DocumentBuilder::add_component(const Name& name, std::string_view level, const Span& span) {
  ComponentSyntax component{name, 1, place_of(level, span), span};
  const char* const end = level.data() + level.size();
  std::uint32_t written = 0;
  const auto [behind, error] = std::from_chars(level.data(), end, written);
  if (level.empty()) {
    mistake(name.span, fmt::format("`{}` needs a level, such as 1", shown(name.text)));
  } else if (error != std::errc() || behind != end) {
    mistake(component.level_span, fmt::format("`{}` is no level of a component, such as 1", shown(level)));
  } else {
    component.level = written;
  }
  limit(component.name);
  if (admit(span)) document.head.components.push_back(component);
}

void DocumentBuilder::add_unit(const Name& category, const Name& name, std::string_view factor, const Span& span) {
  UnitSyntax unit{category, name, 1, place_of(factor, span), span};
  const char* const end = factor.data() + factor.size();
  double written = 0;
  const auto [behind, error] = scan_number(factor.data(), end, written);
  if (error == std::errc() && behind == end && written > 0) {
    unit.factor = written;
  } else {
    mistake(unit.factor_span, factor.empty()
                                  ? fmt::format("the unit `{}` needs a conversion factor", shown(name.text))
                                  : fmt::format("`{}` is no conversion factor: that is a number above 0", shown(factor)));
  }
  for (Name* one : {&unit.category, &unit.name}) limit(*one);
  if (admit(span)) document.head.units.push_back(unit);
}

void DocumentBuilder::add_meta(const MetaSyntax& meta) {
  if (admit(meta.span)) document.head.metas.push_back(meta);
}

Range<MappedText> DocumentBuilder::add_string(MappedText text, const Span& place) {
  const std::size_t first = document.strings.size();
  if (admit(place)) document.strings.push_back(std::move(text));
  return strings_since(first);
}

Range<double> DocumentBuilder::numbers_since(std::size_t first) const {
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(document.numbers.size() - first)};
}

Range<MappedText> DocumentBuilder::strings_since(std::size_t first) const {
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(document.strings.size() - first)};
}

PoolSizes DocumentBuilder::pool_sizes() const {
  return {document.nodes.size(),          document.fields.size(),  document.interfaces.size(),
          document.statement_pool.size(), document.routes.size(),  document.protos.size(),
          document.imports.size(),        document.numbers.size(), document.strings.size()};
}

void DocumentBuilder::drop_since(const PoolSizes& sizes) {
  document.nodes.resize(sizes.nodes);
  document.fields.resize(sizes.fields);
  document.interfaces.resize(sizes.interfaces);
  document.statement_pool.resize(sizes.statements);
  document.routes.resize(sizes.routes);
  document.protos.resize(sizes.protos);
  document.imports.resize(sizes.imports);
  document.numbers.resize(sizes.numbers);
  document.strings.resize(sizes.strings);
}

AccessType access_type(DocumentBuilder& builder, const Name& word) {
  static constexpr std::array<std::pair<std::string_view, AccessType>, 4> kWords = {
      {{"initializeOnly", AccessType::initialize_only},
       {"inputOnly", AccessType::input_only},
       {"outputOnly", AccessType::output_only},
       {"inputOutput", AccessType::input_output}}};
  for (const auto& [known, access] : kWords) {
    if (known == word.text) return access;
  }
  builder.mistake(word.span, fmt::format("there is no access type `{}`; write `inputOnly`, `outputOnly`, `initializeOnly` "
                                         "or `inputOutput`",
                                         shown(word.text)));
  return AccessType::initialize_only;
}

std::string described(std::string_view token) {
  if (static_cast<unsigned char>(token[0]) < 0x20 || token[0] == 0x7f) {
    return fmt::format("the byte 0x{:02x}", static_cast<unsigned char>(token[0]));
  }
  return fmt::format("`{}`", shown(token));
}

std::string_view in_words(ValueKind kind) {
  switch (kind) {
    case ValueKind::numbers: return "numbers";
    case ValueKind::booleans: return "booleans";
    case ValueKind::strings: return "strings";
    default: return "nodes";
  }
}

std::string_view beginning_of(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

std::string_view shown(std::string_view name) {
  constexpr std::size_t kLongest = 32;
  return beginning_of(name, kLongest);
}

void set_version(DocumentBuilder& builder, std::string_view text, const Span& span) {
  static constexpr std::array<std::string_view, 6> kX3d = {"3.0", "3.1", "3.2", "3.3", "4.0", "4.1"};
  Document& document = builder.document;
  const bool vrml = document.encoding == Encoding::vrml2;
  const bool known = vrml ? text == "2.0" : std::find(kX3d.begin(), kX3d.end(), text) != kX3d.end();
  if (known) {
    document.version_major = static_cast<std::uint32_t>(text[0] - '0');
    document.version_minor = static_cast<std::uint32_t>(text[2] - '0');
    return;
  }
  document.version_major = vrml ? 2 : 4;
  document.version_minor = 0;
  builder.diagnostics.report(DiagnosticId::header_odd, span,
                             fmt::format("there is no version `{}` of {}; this file is read as {}.0", shown(text),
                                         vrml ? "VRML" : "X3D", document.version_major));
}

void append_with_line_feeds(MappedText& text, const SourceSet& sources, const Span& span) {
  const std::string_view written = sources.text(span);
  const auto place = [&](std::size_t offset) { return span.begin + static_cast<std::uint32_t>(offset); };
  std::size_t done = 0;
  for (std::size_t at = written.find('\r'); at != std::string_view::npos; at = written.find('\r', at + 1)) {
    text.append(MappedText(sources, {span.source, place(done), place(at)}));
    done = at + 1;
    const bool pair = done < written.size() && written[done] == '\n';
    if (!pair) text.append_generated("\n", {span.source, place(at), place(at) + 1});
  }
  text.append(MappedText(sources, {span.source, place(done), place(written.size())}));
}

}  // namespace plugc

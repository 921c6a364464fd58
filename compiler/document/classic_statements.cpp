// The statements of a file: its head, routes, imports and exports, prototypes. Mistakes are handled as read_classic.cpp says.

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/classic_reader.h"

namespace plugc {
namespace {

bool is_head_word(std::string_view word) {
  return word == "PROFILE" || word == "COMPONENT" || word == "UNIT" || word == "META";
}

}  // namespace

/// Up to the end of the text, or the closing brace (which stays).
void ClassicReader::read_statements(bool inside_braces) {
  bool skipping = false;
  while (!stopped() && !scan_.at_end()) {
    if (scan_.next_is(kWordStart)) {
      skipping = false;
      read_statement();
    } else if (inside_braces && scan_.next() == '}') {
      return;
    } else {
      if (!skipping && scan_.next() == '}') {
        build_.mistake(scan_.next_span(), "`}` closes nothing here");
      } else if (!skipping) {
        expected("a node or a statement");
      }
      skipping = true;
      scan_.skip_item();
    }
  }
}

void ClassicReader::read_statement() {
  const std::string_view word = scan_.peek_word();
  if (is_head_word(word)) return read_head_statement(word);
  scene_began_ = true;
  if (read_body_statement(word)) return;
  if (word == "IMPORT") return read_import();
  if (word == "EXPORT") return read_export();
  if (auto node = read_node()) build_.add_statement(std::move(*node));
}

/// ISO/IEC 19776-2, 4.1: these stand between the header and the scene.
void ClassicReader::read_head_statement(std::string_view word) {
  if (scene_began_) {
    build_.diagnostics.report(DiagnosticId::header_odd, scan_.next_span(),
                              fmt::format("`{}` belongs in front of the scene, behind the header", word));
  }
  if (word == "PROFILE") return read_profile();
  if (word == "COMPONENT") return read_component();
  if (word == "META") return read_meta();
  read_unit();
}

/// The statements that may also stand inside a node.
bool ClassicReader::read_body_statement(std::string_view word) {
  if (!looks_like_node_type(word)) return false;  // a field's name
  if (word == "ROUTE") {
    read_route();
  } else if (word == "PROTO") {
    read_proto();
  } else if (word == "EXTERNPROTO") {
    read_externproto();
  } else {
    return false;
  }
  return true;
}

/// The rest of the line in which an incomplete statement began, up to a bracket.
void ClassicReader::skip_line(std::uint32_t begin) {
  const std::string_view text = build_.sources.text(build_.document.source);
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  while (scan_.offset() < end && std::string_view("[]{}").find(scan_.next()) == std::string_view::npos) scan_.skip_item();
}

void ClassicReader::read_profile() {
  scan_.take_word();
  build_.document.head.profile = expect_name("the name of a profile");
}

/// `Shaders:1` is one word, because `:` may stand in names.
void ClassicReader::read_component() {
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  Name name = expect_name("the name of a component");
  const std::size_t colon = std::min(name.text.rfind(':'), name.text.size());
  const std::string_view level = name.text.substr(std::min(colon + 1, name.text.size()));
  name = {name.text.substr(0, colon), {name.span.source, name.span.begin, name.span.begin + static_cast<std::uint32_t>(colon)}};
  if (!name.empty()) build_.add_component(name, level, scan_.span_from(begin));
}

void ClassicReader::read_unit() {
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const Name category = expect_name("the category of a unit");
  const Name name = expect_name("the name of a unit");
  if (!scan_.next_is(kNumberStart)) {
    expected("a conversion factor");
    return skip_line(begin);
  }
  const std::string_view factor = build_.sources.text(scan_.next_span());
  scan_.skip_item();
  if (!category.empty() && !name.empty()) build_.add_unit(category, name, factor, scan_.span_from(begin));
}

void ClassicReader::read_meta() {
  MetaSyntax meta;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  for (Name* one : {&meta.name, &meta.content}) {
    if (scan_.next() != '"') return expected("a string");
    *one = read_string_name();
  }
  meta.span = scan_.span_from(begin);
  build_.add_meta(meta);
}

Name ClassicReader::read_string_name() {
  const Span place = scan_.next_span();
  MappedText text;
  scan_.take_string(text);
  return {build_.document.decoded_names.emplace_back(text.text()), place};
}

void ClassicReader::read_route() {
  RouteSyntax route;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const bool complete = !(route.from_node = expect_name("the name of a node")).empty() && expect_dot() &&
                        !(route.from_field = expect_name("the name of a field")).empty() && expect_to() &&
                        !(route.to_node = expect_name("the name of a node")).empty() && expect_dot() &&
                        !(route.to_field = expect_name("the name of a field")).empty();
  if (!complete) return skip_line(begin);
  route.span = scan_.span_from(begin);
  build_.add_statement(route);
}

void ClassicReader::read_import() {
  ImportSyntax import;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const bool complete = !(import.inline_def = expect_name("the name of an Inline node")).empty() && expect_dot() &&
                        !(import.name = expect_name("the name of a node")).empty();
  if (!complete) return skip_line(begin);
  import.alias = import.name;
  if (scan_.peek_word() == "AS") {
    scan_.take_word();
    import.alias = expect_name("a name");
  }
  import.span = scan_.span_from(begin);
  if (!import.alias.empty()) build_.add_statement(StatementKind::import, import);
}

void ClassicReader::read_export() {
  ImportSyntax exported;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  exported.name = exported.alias = expect_name("the name of a node");
  if (scan_.peek_word() == "AS") {
    scan_.take_word();
    exported.alias = expect_name("a name");
  }
  exported.span = scan_.span_from(begin);
  if (!exported.name.empty() && !exported.alias.empty()) build_.add_statement(StatementKind::export_, exported);
}

void ClassicReader::read_proto() {
  ProtoSyntax proto;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  proto.name = expect_own_name("the name of a prototype");
  proto.interface = read_interfaces(proto.name, true);
  const Span brace = scan_.next_span();
  if (!scan_.take('{')) return expected("`{` and the body of the prototype");
  if (depth_ >= kMaxNesting) {
    build_.too_deep(proto.name.span);
    while (!scan_.at_end() && scan_.next() != '}') scan_.skip_item();
  }
  ++depth_;
  const std::size_t mark = build_.statements.open();
  read_statements(true);
  proto.body = build_.statements.close(mark, build_.document.statement_pool);
  --depth_;
  if (!scan_.take('}')) not_closed(brace, "`{`");
  proto.span = scan_.span_from(begin);
  if (!proto.name.empty()) build_.add_statement(StatementKind::proto, proto);
}

void ClassicReader::read_externproto() {
  ProtoSyntax proto;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  proto.name = expect_own_name("the name of a prototype");
  proto.interface = read_interfaces(proto.name, false);
  if (scan_.next() != '"' && scan_.next() != '[') return expected("the urls of the prototype");
  const Span place = scan_.next_span();
  const ValueSyntax urls = read_value(proto.name);
  if (urls.kind != ValueKind::strings && urls.kind != ValueKind::empty) {
    return build_.mistake(place, "the urls of a prototype are strings");
  }
  proto.urls = urls.strings();
  proto.span = scan_.span_from(begin);
  if (!proto.name.empty()) build_.add_statement(StatementKind::externproto, proto);
}

}  // namespace plugc

// Recursive descent over the items of XmlScanner, bounded by kMaxNesting. Elements go into the Document as they are met;
// only the connections of an IS wait until their node ends. Source: ISO/IEC 19776-1; the mapping of statements: 4.3.
//
// A node that stands beside the Scene, mostly behind an end tag too many, is told once and read as if it stood in it.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "document/read_document.h"
#include "document/xml_reader.h"
#include "document/xml_text.h"

namespace plugc {
namespace {

/// Whether two names differ at most in the case of their letters.
bool is_spelled_like(std::string_view name, std::string_view wanted) {
  const auto same = [](char a, char b) { return (a | 0x20) == (b | 0x20); };
  return std::equal(name.begin(), name.end(), wanted.begin(), wanted.end(), same);
}

}  // namespace

Document XmlReader::read() {
  const std::string_view text = build_.sources.text(build_.document.source);
  const auto tags = static_cast<std::size_t>(std::count(text.begin(), text.end(), '<'));
  build_.expect(tags, 2 * tags, tags);
  const std::size_t mark = build_.statements.open();
  read_file();
  build_.document.statements = build_.statements.close(mark, build_.document.statement_pool);
  return std::move(build_.document);
}

void XmlReader::read_file() {
  XmlItem item = scan_.next();
  for (; item == XmlItem::text || item == XmlItem::cdata; item = scan_.next()) reject_text("text stands in front of `<X3D>`");
  if (item == XmlItem::element) {
    if (read_root()) read_behind_root();
  } else if (build_.mistake_count() == 0) {
    build_.mistake(scan_.span_from(0), "this file holds no element");
  }
}

/// False: the file is no scene.
bool XmlReader::read_root() {
  const Name root = scan_.tag();
  if (root.text == "X3D") {
    read_x3d();
    return true;
  }
  build_.mistake(root.span, fmt::format("expected `<X3D>`, found `<{}>`", shown(root.text)));
  if (root.text == "Scene") {
    read_scene();
  } else if (is_spelled_like(root.text, "X3D")) {
    read_x3d();
  } else {
    return false;
  }
  return true;
}

void XmlReader::read_behind_root() {
  bool told = false;
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    if (item != XmlItem::element) {
      if (!told) reject_text("text stands behind the scene");
    } else {
      const Name tag = scan_.tag();
      if (!told) build_.mistake(tag.span, fmt::format("`<{}>` stands behind the scene, which is closed", shown(tag.text)));
      if (is_spelled_like(tag.text, "Scene")) {
        read_scene();
      } else if (is_spelled_like(tag.text, "X3D")) {
        read_x3d();
      } else {
        read_statement(item);
      }
    }
    told = true;
  }
}

void XmlReader::read_x3d() {
  const Name tag = scan_.tag();
  const std::size_t mistakes = build_.mistake_count();
  Name version;
  read_attributes({{"version", &version}, {"profile", &build_.document.head.profile}});
  if (version.span.valid()) set_version(build_, version.text, version.span);
  bool found = false, misplaced = false;
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    if (item == XmlItem::element) {
      read_x3d_child(found, misplaced);
    } else {
      reject_text("text stands where only elements may");
    }
  }
  if (!found && build_.mistake_count() == mistakes) build_.mistake(tag.span, "`<X3D>` holds no `<Scene>`");
}

void XmlReader::read_x3d_child(bool& found, bool& misplaced) {
  const Name tag = scan_.tag();
  if (tag.text == "head" || tag.text == "Header") return read_head();
  if (!is_spelled_like(tag.text, "Scene")) {
    if (!misplaced) build_.mistake(tag.span, fmt::format("expected `<head>` or `<Scene>`, found `<{}>`", shown(tag.text)));
    misplaced = true;
    return read_statement(XmlItem::element);
  }
  if (tag.text != "Scene") {
    build_.mistake(tag.span, fmt::format("expected `<Scene>`, found `<{}>`", shown(tag.text)));
  } else if (found) {
    build_.mistake(tag.span, "`<X3D>` holds one `<Scene>`; put these nodes into the first one");
  }
  found = true;
  read_scene();
}

void XmlReader::read_head() {
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    if (item == XmlItem::element) read_head_entry();
  }
}

/// Other elements of a head (`<link>`, `<meta charset>`) say nothing about a scene.
void XmlReader::read_head_entry() {
  const Name tag = scan_.tag();
  if (tag.text != "component" && tag.text != "meta" && tag.text != "unit") return scan_.skip_element();
  Name name, content, level, category, factor;
  read_attributes(
      {{"name", &name}, {"content", &content}, {"level", &level}, {"category", &category}, {"conversionFactor", &factor}});
  scan_.skip_element();
  if (name.empty()) return;
  if (tag.text == "component") build_.add_component(name, level.text, element_span(tag));
  if (tag.text == "meta") build_.add_meta({name, content, element_span(tag)});
  if (tag.text == "unit") build_.add_unit(category, name, factor.text, element_span(tag));
}

void XmlReader::read_scene() {
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) read_statement(item);
}

// Attributes and text

Name XmlReader::name_of(const XmlAttribute& attribute) {
  const std::string_view written = build_.sources.text(attribute.value);
  if (written.find('&') == std::string_view::npos) return {written, attribute.value};
  return {build_.document.decoded_names.emplace_back(decode_xml(attribute.value, build_).text()), attribute.value};
}

/// The attributes of an element that is no node; others mean nothing there.
void XmlReader::read_attributes(std::initializer_list<KnownAttribute> known) {
  for (XmlAttribute attribute; scan_.next_attribute(attribute);) {
    const auto same = [&](const KnownAttribute& one) { return one.key == attribute.name.text; };
    const auto found = std::find_if(known.begin(), known.end(), same);
    if (found == known.end()) continue;
    const Span& before = found->name != nullptr ? found->name->span : found->written->value;
    if (before.valid()) given_twice(attribute);
    if (found->name != nullptr) *found->name = name_of(attribute);
    if (found->written != nullptr) *found->written = attribute;
  }
}

void XmlReader::given_twice(const XmlAttribute& attribute) {
  build_.mistake(attribute.name.span, fmt::format("`{}` is given twice", shown(attribute.name.text)));
}

bool XmlReader::required(const Name& name, const Name& element, std::string_view attribute) {
  if (!name.empty()) return true;
  build_.mistake(element.span, fmt::format("`<{}>` needs the attribute `{}`", shown(element.text), attribute));
  return false;
}

ValueSyntax XmlReader::lexical_value(const XmlAttribute& attribute) {
  ValueSyntax value;
  value.kind = ValueKind::lexical;
  value.span = attribute.value;
  const std::size_t mistakes = build_.mistake_count();
  value.hold(build_.add_string(decode_xml(value.span, build_), value.span));
  value.damaged = attribute.damaged || build_.mistake_count() != mistakes;
  if (value.count == 0) value.kind = ValueKind::none;  // not admitted
  return value;
}

void XmlReader::reject_text(std::string_view because) {
  if (scan_.text_was_reported()) return;
  const std::string_view written = build_.sources.text(scan_.text());
  const std::size_t first = written.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return;  // of CDATA
  Span span = scan_.text();
  span.end = span.begin + static_cast<std::uint32_t>(written.find_last_not_of(" \t\r\n") + 1);
  span.begin += static_cast<std::uint32_t>(first);
  build_.mistake(span, std::string(because));
}

Document read_xml(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  return XmlReader(source, sources, diagnostics).read();
}

}  // namespace plugc

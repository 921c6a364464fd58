// One line a node in the order of their ids, which is the order of the text:
//
//     #1 Transform DEF tower (scene.x3dv:4:3) translation 0 1 0; children #2 #5
//
// Lists are cut after their first elements. Nodes are named by number, so nothing here recurses.

#include <fmt/format.h>

#include "base/source.h"
#include "document/read_document.h"
#include "scene/node_graph.h"

namespace plugc {
namespace {

constexpr std::size_t kShownElements = 16;
constexpr std::size_t kShownCharacters = 40;

std::string show(double number) {
  return fmt::format("{}", number);
}
std::string show(NodeId id) {
  return fmt::format("#{}", id.value);
}

std::string show(const MappedText& text) {
  std::string shown = "\"";
  for (const char c : text.text().substr(0, kShownCharacters)) {
    if (c == '\n')
      shown += "\\n";
    else if (static_cast<unsigned char>(c) >= ' ')
      shown += c;
  }
  return shown + (text.size() > kShownCharacters ? "...\"" : "\"");
}

template <typename Element>
std::string show_list(std::span<const Element> elements) {
  std::string shown;
  for (std::size_t i = 0; i < elements.size() && i < kShownElements; ++i) shown.append(" ").append(show(elements[i]));
  if (elements.size() > kShownElements) shown += fmt::format(" ... {} in all", elements.size());
  return shown;
}

std::string show(const FieldValue& value) {
  if (is_node(value.type)) return value.nodes.empty() ? " NULL" : show_list(value.nodes);
  if (is_string(value.type)) return show_list(value.strings);
  if (value.type == FieldType::SFBool) return value.numbers[0] != 0 ? " TRUE" : " FALSE";
  return show_list(value.numbers);
}

std::string show_place(const Span& span, const SourceSet& sources) {
  if (!span.valid()) return "";
  const Position at = sources.position(span.source, span.begin);
  return fmt::format(" ({}:{}:{})", sources.name(span.source), at.line, at.column);
}

std::string show_fields(const GraphNode& node) {
  std::string shown;
  const auto add = [&](const std::string& field) { shown.append(shown.empty() ? " " : "; ").append(field); };
  for (const InterfaceField& field : node.interface()) {
    add(fmt::format("{} {} {}{}", to_text(field.access), to_text(field.type), field.name,
                    field.has_value ? show(field.value) : ""));
  }
  for (const WrittenField& field : node.fields) add(fmt::format("{}{}", field.info->name, show(field.value)));
  for (const MappedText& text : node.cdata()) add(fmt::format("cdata {}", show(text)));
  return shown;
}

}  // namespace

std::string dump_graph(const NodeGraph& graph, const SourceSet& sources) {
  std::string dump = "roots" + show_list(graph.roots()) + "\n";
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const GraphNode& node = graph[NodeId{i}];
    const std::string def = node.def.empty() ? "" : fmt::format(" DEF {}", node.def);
    dump += fmt::format("#{} {}{}{}{}\n", i, node.info->name, def, show_place(node.type_span, sources), show_fields(node));
  }
  for (const GraphRoute& route : graph.routes()) {
    dump += fmt::format("route #{}.{} to #{}.{}\n", route.from.value, route.from_field, route.to.value, route.to_field);
  }
  return dump;
}

}  // namespace plugc

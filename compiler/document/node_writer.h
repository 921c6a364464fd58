#pragma once
// Nodes and fields that no text holds literally, put into a Document as a reader of text would put them. Every one has the
// place in the file (of glTF, of VRML 1.0) that it stands for.

#include <initializer_list>
#include <span>
#include <string>
#include <unordered_map>

#include "document/document_builder.h"

namespace plugc {

/// Names of fields and types are kept as they are given: they have to be literals.
class NodeWriter {
 public:
  explicit NodeWriter(DocumentBuilder& builder) : build_(builder) {}

  void numbers(std::string_view field, std::span<const double> numbers, const Span& place);
  void numbers(std::string_view field, std::initializer_list<double> numbers, const Span& place);
  void boolean(std::string_view field, bool value, const Span& place);
  void string(std::string_view field, std::string_view value, const Span& place);
  void string(std::string_view field, MappedText value, const Span& place);
  /// A value that lies in the document's pools already.
  void value(std::string_view field, const ValueSyntax& value, const Span& place);

  /// A field of nodes: what `fill` writes with node() and use().
  template <typename Fill>
  void nodes(std::string_view field, const Span& place, Fill fill) {
    const std::size_t mark = build_.nodes.open();
    fill();
    ValueSyntax value;
    value.kind = ValueKind::nodes;
    value.span = place;
    value.hold(build_.nodes.close(mark, build_.document.nodes));
    if (value.count != 0) this->value(field, value, place);
  }

  /// A node whose fields `fill` writes.
  template <typename Fill>
  void node(std::string_view type, const Name& def, const Span& place, Fill fill) {
    NodeSyntax node;
    node.type = {type, place};
    node.span = place;
    NodeExtras extras;
    extras.def = def;
    const OpenBody body = build_.open_body();
    fill();
    build_.close_body(body, node, extras);
    build_.add_list_node(node);
  }
  void use(const Name& def, const Span& place);

  /// A DEF name made of a name of the file, or of `otherwise`: with characters that X3D takes, and the only one of its
  /// kind in the file.
  Name define(std::string_view wanted, std::string_view otherwise, const Span& place);

  /// What was written with node() since `mark` of the builder's nodes becomes the document's statements.
  void end_document(std::size_t mark);

 private:
  DocumentBuilder& build_;
  std::unordered_map<std::string, std::size_t> names_;  // and the number that the last of that name got
};

}  // namespace plugc

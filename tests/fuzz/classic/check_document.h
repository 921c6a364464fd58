#pragma once
// What holds of every Document, whatever was read: ranges lie in their pools, places in the text, names in what they say.

#include <string>

#include "base/check.h"
#include "document/read_document.h"

namespace plugc {

struct DocumentCheck {
  const Document& document;
  const SourceSet& sources;

  template <typename T>
  void range(Range<T> range, const std::vector<T>& pool) const {
    PLUGC_CHECK(range.count == 0 || std::size_t{range.first} + range.count <= pool.size(), "a range lies in its pool");
  }

  void place(const Span& span) const {
    if (!span.valid()) return;
    PLUGC_CHECK(span.begin <= span.end && span.end <= sources.text(span.source).size(), "a place lies in its text");
  }

  void value(const ValueSyntax& value) const {
    place(value.span);
    range(value.numbers(), document.numbers);
    range(value.strings(), document.strings);
    range(value.nodes(), document.nodes);
    const bool one_string = value.kind == ValueKind::is || value.kind == ValueKind::lexical;
    PLUGC_CHECK(!one_string || value.count == 1, "IS and lexical values have one string");
  }

  void all() const {
    for (const NodeSyntax& node : document.nodes) {
      place(node.span);
      range(node.fields, document.fields);
      range(node.extras->interface, document.interfaces);
      range(node.extras->statements, document.statement_pool);
      range(node.extras->cdata, document.strings);
      for (const Name* name : {&node.type, &node.extras->def, &node.extras->use, &node.extras->container_field})
        place(name->span);
    }
    for (const FieldSyntax& field : document.fields) value(field.value);
    for (const InterfaceSyntax& field : document.interfaces) value(field.value);
    for (const ProtoSyntax& proto : document.protos) {
      range(proto.interface, document.interfaces);
      range(proto.body, document.statement_pool);
      range(proto.urls, document.strings);
    }
    for (const MappedText& string : document.strings) {
      for (std::uint32_t i = 0; i < string.size(); i += 1 + string.size() / 8) place(string.locate(i, string.size()));
    }
  }
};

/// Reads `text` with `read`, checks the Document, and dumps it (which visits every node by its nesting).
template <typename Reader>
void read_and_check(std::string text, Reader read) {
  SourceSet sources;
  const SourceId source = sources.add("fuzz", std::move(text));
  Diagnostics diagnostics(sources);
  const Document document = read(source, sources, diagnostics);
  DocumentCheck{document, sources}.all();
  dump_document(document, sources);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    DocumentCheck{document, sources}.place(diagnostic.span);
    to_text(diagnostic, sources);
  }
}

}  // namespace plugc

#pragma once
// What was written, whatever the encoding: nodes, fields and statements with their places, no meaning yet. Every encoding
// fills the same plain structs. No node table is needed: a value is kept as the kind of thing that it looks like, and what
// looks like nothing (XML attributes, plain strings of JSON) as text that the scene room reads by the field's type
// (read_lexical.h).
//
// Lists live in pools of the Document and are named by ranges, so a million nodes cost a few allocations.
// Spans of decoded text come from MappedText: `\"` in a classic string or `&lt;` in an attribute do not shift places.

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"

namespace plugc {

enum class Encoding : std::uint8_t { classic, vrml2, xml, json, gltf, vrml1 };

/// A contiguous part of one pool of a Document.
template <typename T>
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool empty() const { return count == 0; }
};

/// A name as written. `text` points into the source set (or, where an entity was decoded, into the Document).
struct Name {
  std::string_view text;
  Span span;
  bool empty() const { return text.empty(); }
};

struct NodeSyntax;

enum class ValueKind : std::uint8_t {
  none,      ///< Nothing written (an interface field without a default).
  numbers,   ///< `1 2 3`, `[ 1, 2 ]`, `TRUE` (as 1): in `numbers`.
  booleans,  ///< As numbers, but every one was TRUE or FALSE.
  strings,   ///< `"a" "b"`: in `strings`.
  nodes,     ///< Node statements, also `NULL` (an empty range): in `nodes`.
  empty,     ///< `[ ]`: an empty list of whatever the field holds.
  lexical,   ///< The one string in `strings` holds the value's text (an XML attribute, a JSON string).
  is,        ///< `IS name`: the name is the one string in `strings`.
};

struct ValueSyntax {
  ValueKind kind = ValueKind::none;
  bool bracketed = false;       ///< Written in [ ].
  bool damaged = false;         ///< A mistake in it was reported; that it does not fit its field then is no second one.
  std::uint8_t components = 0;  ///< Numbers in one element, where a field's type was asked for (scene/type_document.h).
  Span span;                    ///< The whole value.
  std::uint32_t first = 0;      ///< What it holds, in the pool that its kind says.
  std::uint32_t count = 0;

  bool holds_numbers() const { return kind == ValueKind::numbers || kind == ValueKind::booleans; }
  bool holds_strings() const { return kind == ValueKind::strings || kind == ValueKind::lexical || kind == ValueKind::is; }
  Range<double> numbers() const { return holds_numbers() ? Range<double>{first, count} : Range<double>{}; }
  Range<MappedText> strings() const { return holds_strings() ? Range<MappedText>{first, count} : Range<MappedText>{}; }
  Range<NodeSyntax> nodes() const { return kind == ValueKind::nodes ? Range<NodeSyntax>{first, count} : Range<NodeSyntax>{}; }
  template <typename T>
  void hold(Range<T> range) {
    first = range.first;
    count = range.count;
  }
};

/// `name value`. In XML, a child element is a field with an empty name (the scene room finds the field by containerField).
struct FieldSyntax {
  Name name;
  ValueSyntax value;
};

/// Whether it holds nodes that the reader found where no node may stand, which was reported.
inline bool is_unplaced(const FieldSyntax& field) {
  return field.name.empty() && field.value.damaged;
}

enum class AccessType : std::uint8_t { initialize_only, input_only, output_only, input_output };

/// `inputOutput SFFloat alpha 0.5` in a Script, Effect, shader node or PROTO interface.
struct InterfaceSyntax {
  AccessType access = AccessType::initialize_only;
  Name type;
  Name name;
  ValueSyntax value;
  Span span;
};

enum class StatementKind : std::uint8_t { node, route, proto, externproto, import, export_ };

struct RouteSyntax {
  Name from_node, from_field, to_node, to_field;
  Span span;
};

/// IMPORT inline.name AS alias; EXPORT name AS alias (inline_def empty).
struct ImportSyntax {
  Name inline_def, name, alias;
  Span span;
};

/// `COMPONENT Shaders:1`
struct ComponentSyntax {
  Name name;
  std::uint32_t level = 1;
  Span level_span;  ///< Not valid when no level is written.
  Span span;
};

/// `UNIT length inch 0.0254`
struct UnitSyntax {
  Name category, name;
  double factor = 1;  ///< Above 0; 1 where what is written is none (reported).
  Span factor_span;
  Span span;
};

/// `META "title" "A teapot"`
struct MetaSyntax {
  Name name, content;
  Span span;
};

/// What a file says of itself before its scene, each kind in the order of the text.
struct HeadSyntax {
  Name profile;
  std::vector<ComponentSyntax> components;
  std::vector<UnitSyntax> units;
  std::vector<MetaSyntax> metas;
};

/// One statement, in the order of the text. `index` points into the pool of its kind.
struct StatementSyntax {
  StatementKind kind = StatementKind::node;
  std::uint32_t index = 0;
};

/// What few nodes have. Kept beside them, so that the many others are small.
struct NodeExtras {
  Name def;              ///< DEF name, or empty.
  Name use;              ///< USE name, or empty.
  Name container_field;  ///< XML, and JSON where it differs from the key.
  Range<InterfaceSyntax> interface;
  Range<StatementSyntax> statements;  ///< ROUTE and PROTO inside the body.
  Range<MappedText> cdata;            ///< Code directly inside, in order: CDATA and text of XML, `#sourceCode` of JSON.

  bool any() const {
    return !def.empty() || !use.empty() || !container_field.empty() || !interface.empty() || !statements.empty() ||
           !cdata.empty();
  }
};
inline const NodeExtras kNoExtras;

struct NodeSyntax {
  Name type;                              ///< Of a USE only where the encoding says it (XML and JSON do).
  Range<FieldSyntax> fields;              ///< In the order of the text; a name may stand twice.
  Span span;                              ///< From DEF (or the type) to the closing bracket.
  bool is_instance = false;               ///< Written as `ProtoInstance`; the classic encoding makes no difference.
  const NodeExtras* extras = &kNoExtras;  ///< Owned by the Document; never null.
};

struct ProtoSyntax {
  Name name;
  Range<InterfaceSyntax> interface;
  Range<StatementSyntax> body;  ///< Empty for an EXTERNPROTO.
  Range<MappedText> urls;       ///< EXTERNPROTO only.
  Span span;
};

struct Document {
  SourceId source;
  Encoding encoding = Encoding::classic;
  std::uint32_t version_major = 3;  ///< As the header says (3.2, 4.0; 2.0 for VRML).
  std::uint32_t version_minor = 0;
  HeadSyntax head;
  Range<StatementSyntax> statements;  ///< The top level.

  std::vector<NodeSyntax> nodes;
  std::vector<FieldSyntax> fields;
  std::vector<InterfaceSyntax> interfaces;
  std::vector<StatementSyntax> statement_pool;
  std::vector<RouteSyntax> routes;
  std::vector<ProtoSyntax> protos;
  std::vector<ImportSyntax> imports;  ///< IMPORT and EXPORT.
  std::vector<double> numbers;
  std::vector<MappedText> strings;
  std::deque<NodeExtras> extras;          ///< Of the nodes that have any; they never move.
  std::deque<std::string> decoded_names;  ///< Names that held an entity; they never move.

  std::span<const NodeSyntax> of(Range<NodeSyntax> range) const { return {nodes.data() + range.first, range.count}; }
  std::span<const FieldSyntax> of(Range<FieldSyntax> range) const { return {fields.data() + range.first, range.count}; }
  std::span<const InterfaceSyntax> of(Range<InterfaceSyntax> range) const {
    return {interfaces.data() + range.first, range.count};
  }
  std::span<const StatementSyntax> of(Range<StatementSyntax> range) const {
    return {statement_pool.data() + range.first, range.count};
  }
  std::span<const double> of(Range<double> range) const { return {numbers.data() + range.first, range.count}; }
  std::span<const MappedText> of(Range<MappedText> range) const { return {strings.data() + range.first, range.count}; }
};

}  // namespace plugc

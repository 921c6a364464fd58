#pragma once
// A Document while it is read. Lists nest in the text but lie flat in the pools, so the items of a list wait on a stack of
// their kind until the list closes. The builder also counts mistakes and items: beyond a limit reading stops.

#include <iterator>
#include <span>
#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "document/document.h"

namespace plugc {

/// Lists of one kind that are still open, one above the other.
template <typename T>
class OpenLists {
 public:
  /// What close() takes to end the list that begins here.
  std::size_t open() const { return items_.size(); }
  void add(T item) { items_.push_back(std::move(item)); }
  T* begin(std::size_t mark) { return items_.data() + mark; }
  T* end() { return items_.data() + items_.size(); }

  /// Moves the items since `mark` into the pool.
  Range<T> close(std::size_t mark, std::vector<T>& pool) {
    if (mark == items_.size()) return {};
    const Range<T> range{static_cast<std::uint32_t>(pool.size()), static_cast<std::uint32_t>(items_.size() - mark)};
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(mark);
    pool.insert(pool.end(), std::make_move_iterator(first), std::make_move_iterator(items_.end()));
    items_.erase(first, items_.end());
    return range;
  }

 private:
  std::vector<T> items_;
};

/// Where the lists of one node's body begin.
struct OpenBody {
  std::size_t fields = 0, interface = 0, statements = 0, cdata = 0;
};

/// `<connect nodeField="a" protoField="b"/>`, as `a IS b`.
struct Connection {
  Name node_field, proto_field;
};

/// How much the pools of a Document hold.
struct PoolSizes {
  std::size_t nodes, fields, interfaces, statements, routes, protos, imports, numbers, strings;
};

/// A ProtoInstance that does not say of what, which was reported.
inline bool is_nameless(const NodeSyntax& node) {
  return node.type.empty() && node.extras->use.empty();
}

class DocumentBuilder {
 public:
  DocumentBuilder(SourceId source, Encoding encoding, const SourceSet& sources, Diagnostics& diagnostics);

  /// Reports a mistake; after very many the text is taken for something else and reading stops.
  void mistake(const Span& span, std::string message);
  void too_deep(const Span& span);
  bool stopped() const { return stopped_; }
  /// Makes room, so that the pools of a large file do not grow by moving. Room that is never used costs nothing.
  void expect(std::size_t nodes, std::size_t fields, std::size_t strings);
  std::size_t mistake_count() const { return mistakes_; }

  OpenBody open_body() const;
  /// Ends the lists of the node's body; what `extras` has then belongs to the node.
  void close_body(const OpenBody& body, NodeSyntax& node, NodeExtras& extras);
  void give(NodeSyntax& node, NodeExtras& extras);

  /// A name that is too long is reported and cut, so that no message quotes megabytes of it, over and over.
  void limit(Name& name) {
    if (name.text.size() > kMaxNameBytes) cut(name);
  }
  void add_field(FieldSyntax field, const Span& place) {
    limit(field.name);
    if (admit(place)) fields.add(field);
  }
  void add_interface(InterfaceSyntax field);
  void add_list_node(const NodeSyntax& node) {
    if (!is_nameless(node) && admit(node.span)) nodes.add(node);
  }
  /// A list of one.
  Range<NodeSyntax> add_node(const NodeSyntax& node) {
    if (is_nameless(node) || !admit(node.span)) return {};
    document.nodes.push_back(node);
    return {static_cast<std::uint32_t>(document.nodes.size() - 1), 1};
  }
  void add_cdata(MappedText text, const Span& place);
  /// The connections of a node, behind its other fields: an interface field of the node itself takes one as its value, as in
  /// the classic `field SFFloat a IS b`.
  void add_connections(const OpenBody& body, std::span<const Connection> connections);
  void add_statement(NodeSyntax node);
  void add_statement(RouteSyntax route);
  void add_statement(StatementKind kind, ProtoSyntax proto);
  void add_statement(StatementKind kind, ImportSyntax import);

  // What the file says of itself. A level that is no whole number and a factor that is not above 0 are reported; both count
  // as 1 then. They are given as written: views of the source text where their own place is to be marked.
  void add_component(const Name& name, std::string_view level, const Span& span);
  void add_unit(const Name& category, const Name& name, std::string_view factor, const Span& span);
  void add_meta(const MetaSyntax& meta);

  /// Counts one more item of a file, whatever it is; false once there are too many, and reading stops.
  bool admit(const Span& place) {
    if (items_ >= kMaxDocumentItems) stop_at_limit(place, kMaxDocumentItems, "nodes, fields and strings");
    if (!stopped_) ++items_;
    return !stopped_;
  }
  /// Whether a number may be added to the document's; if not, reading stops.
  bool may_add_number(const Span& place) {
    if (document.numbers.size() >= kMaxDocumentNumbers) [[unlikely]]
      stop_at_limit(place, kMaxDocumentNumbers, "numbers");
    return !stopped_;
  }
  Range<MappedText> add_string(MappedText text, const Span& place);
  /// The numbers since `first` of the pool.
  Range<double> numbers_since(std::size_t first) const;
  Range<MappedText> strings_since(std::size_t first) const;

  PoolSizes pool_sizes() const;
  /// Drops what was added to the pools since, for something that was read and may not stand where it does.
  void drop_since(const PoolSizes& sizes);

  const SourceSet& sources;
  Diagnostics& diagnostics;
  Document document;
  OpenLists<NodeSyntax> nodes;
  OpenLists<FieldSyntax> fields;
  OpenLists<InterfaceSyntax> interfaces;
  OpenLists<StatementSyntax> statements;
  OpenLists<MappedText> cdata;

 private:
  void stop_at_limit(const Span& place, std::size_t limit, std::string_view of);
  Span place_of(std::string_view part, const Span& whole) const;
  void cut(Name& name);
  std::size_t items_ = 0;
  std::size_t mistakes_ = 0;
  bool stopped_ = false;
};

/// `inputOutput` and its kind, as XML and JSON name them. What is none of them is reported and read as initializeOnly.
AccessType access_type(DocumentBuilder& builder, const Name& word);

/// A token as messages quote it: in backticks, or as a byte where it cannot be shown.
std::string described(std::string_view token);

/// What a list of that kind holds: "numbers", "strings", ...
std::string_view in_words(ValueKind kind);

/// As much of a text as that many bytes hold; cut between characters.
std::string_view beginning_of(std::string_view text, std::size_t bytes);
/// As much of a name from the input as a message should repeat.
std::string_view shown(std::string_view name);

/// Takes `3.2` for the document's version and warns when there is no such version.
void set_version(DocumentBuilder& builder, std::string_view text, const Span& span);

/// Appends source text with CR LF and CR as LF (XML 1.0, 2.11), so that an encoding or an editor changes no string.
void append_with_line_feeds(MappedText& text, const SourceSet& sources, const Span& span);

}  // namespace plugc

#pragma once
// The grammar of VRML 1.0: one function a rule. Unlike the classic encoding's it needs to know the nodes, as words stand
// unquoted in its values and children stand between its fields. Mistakes are handled as read_classic.cpp says.

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "document/classic_scanner.h"
#include "document/document_builder.h"
#include "document/vrml1_tree.h"

namespace plugc {

class Vrml1Reader {
 public:
  explicit Vrml1Reader(DocumentBuilder& build) : build_(build), scan_(build.document.source, build.sources) {}

  Vrml1Tree read();

 private:
  /// Of the node that is read.
  struct Body {
    std::size_t first_field;                        ///< In fields_.
    std::unordered_set<std::string_view> declared;  ///< Names of fields, by `fields [ ]`.
  };

  // read_vrml1.cpp: nodes
  void read_child();
  Name take_name();
  std::optional<std::uint32_t> read_use();
  std::optional<std::uint32_t> read_node();
  void read_body(Vrml1Node& node);
  void read_body_item(Vrml1Node& node, Body& body);
  void read_misplaced_child(const Vrml1Node& node);
  void read_declarations(Body& body);
  void read_is_a(Vrml1Node& node);
  void pass_unknown_body();
  void report_unknown_node(const Name& type);
  void read_field(const Vrml1Node& node, const Vrml1FieldInfo& info, const Body& body);
  void add_field(const Vrml1Node& node, const Vrml1Field& field, const Body& body);
  void read_unknown_field(const Vrml1Node& node, const Body& body);
  void pass_to_item(const Vrml1Node& node, const Body& body);

  // vrml1_values.cpp
  ValueSyntax read_value(const Vrml1Node& node, const Vrml1FieldInfo& field);
  bool read_items(ValueSyntax& value, const Vrml1FieldInfo& field, bool in_list);
  bool read_item(ValueSyntax& value, const Vrml1FieldInfo& field);
  bool read_numbers();
  bool read_boolean();
  bool read_string();
  bool read_words(const ValueSyntax& value, const Vrml1FieldInfo& field);
  void add_words(const ValueSyntax& value, const Name& bare, const Vrml1FieldInfo& field);
  void check_count(ValueSyntax& value, const Vrml1Node& node, const Vrml1FieldInfo& field);

  void expected(std::string_view what);
  void not_closed(const Span& span, std::string_view what);
  bool stopped() {
    if (build_.stopped()) scan_.skip_to_end();
    return build_.stopped();
  }

  DocumentBuilder& build_;
  ClassicScanner scan_;
  Vrml1Tree tree_;
  OpenLists<Vrml1Field> fields_;
  OpenLists<Vrml1Child> children_;
  std::unordered_map<std::string_view, std::uint32_t> definitions_;  // nodes, or what is no node
  std::set<std::string, std::less<>> unknown_nodes_;                 // reported
  std::uint32_t depth_ = 0;
  std::uint32_t unexpected_at_ = UINT32_MAX;
  bool end_was_reported_ = false;
};

}  // namespace plugc

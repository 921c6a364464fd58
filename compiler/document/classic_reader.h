#pragma once
// The grammar of the classic encoding: one function a rule. The header and what is told of mistakes are in read_classic.cpp;
// classic_statements.cpp, classic_nodes.cpp and classic_values.cpp hold what their names say.

#include <optional>

#include "document/classic_scanner.h"
#include "document/document_builder.h"

namespace plugc {

class ClassicReader {
 public:
  ClassicReader(SourceId source, Encoding encoding, const SourceSet& sources, Diagnostics& diagnostics)
      : build_(source, encoding, sources, diagnostics), scan_(source, sources) {}

  Document read(std::string_view version, const Span& version_span);

 private:
  // Statements
  void read_statements(bool inside_braces);
  void read_statement();
  void read_head_statement(std::string_view word);
  bool read_body_statement(std::string_view word);
  void read_route();
  void read_import();
  void read_export();
  void read_proto();
  void read_externproto();
  void skip_line(std::uint32_t begin);
  void read_profile();
  void read_component();
  void read_unit();
  void read_meta();
  Name read_string_name();

  // Nodes and interfaces
  std::optional<NodeSyntax> read_node();
  void read_node_body(NodeSyntax& node, NodeExtras& extras);
  void read_body_item();
  void skip_to_name();
  void read_field();
  void read_unnamed_node();
  void read_interface(AccessType access, bool default_allowed);
  Range<InterfaceSyntax> read_interfaces(const Name& proto, bool defaults_allowed);
  bool access_word_is_next(AccessType& access) const;

  // Values
  ValueSyntax read_value(const Name& field);
  ValueSyntax read_list();
  bool read_list_item(ValueSyntax& value);
  bool read_list_word(ValueSyntax& value);
  void read_list_node(ValueSyntax& value);
  bool accept_in_list(ValueSyntax& value, ValueKind kind);
  void report_mixed_list(ValueKind kind);
  void read_word_value(ValueSyntax& value, const Name& field);
  void read_numbers();
  void read_string();
  void read_boolean();
  void read_is(ValueSyntax& value);
  bool boolean_is_next() const;
  bool word_is_bad_value() const;
  bool list_goes_on() const;
  void read_more(ValueSyntax& value);
  bool node_is_next() const;
  void read_more_nodes(ValueSyntax& value, const std::optional<NodeSyntax>& first);
  void skip_no_number();

  // Mistakes
  void expected(std::string_view what);
  Name expect_name(std::string_view what);
  Name expect_own_name(std::string_view what);
  bool expect_to();
  bool expect_dot();
  bool stopped() {
    if (build_.stopped()) scan_.skip_to_end();
    return build_.stopped();
  }
  void not_closed(const Span& span, std::string_view what);

  DocumentBuilder build_;
  ClassicScanner scan_;
  std::uint32_t depth_ = 0;
  std::uint32_t open_lists_ = 0;
  bool end_was_reported_ = false;
  bool scene_began_ = false;
  bool stray_bracket_was_reported_ = false;  // one too many, which may have been meant to close a node, or one too few
  std::uint32_t unexpected_at_ = UINT32_MAX;
};

/// Types of nodes begin with a capital letter, fields do not; it helps to guess what a broken text means.
inline bool looks_like_node_type(std::string_view word) {
  return !word.empty() && word[0] >= 'A' && word[0] <= 'Z';
}

}  // namespace plugc

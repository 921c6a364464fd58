// Nodes, and the interfaces that nodes and prototypes declare. Mistakes are handled as read_classic.cpp says.

#include <fmt/format.h>

#include "base/limits.h"
#include "document/classic_reader.h"

namespace plugc {
namespace {

std::optional<AccessType> access_type(std::string_view word) {
  if (word.empty() || std::string_view("eifo").find(word[0]) == std::string_view::npos) return std::nullopt;  // said of most
  if (word == "inputOnly" || word == "eventIn") return AccessType::input_only;
  if (word == "outputOnly" || word == "eventOut") return AccessType::output_only;
  if (word == "initializeOnly" || word == "field") return AccessType::initialize_only;
  if (word == "inputOutput" || word == "exposedField") return AccessType::input_output;
  return std::nullopt;
}

bool looks_like_field_type(std::string_view word) {
  return word.starts_with("SF") || word.starts_with("MF");
}

}  // namespace

/// `DEF name Type { ... }`, `Type { ... }` or `USE name`.
std::optional<NodeSyntax> ClassicReader::read_node() {
  NodeSyntax node;
  NodeExtras extras;
  const std::uint32_t begin = scan_.offset();
  if (scan_.peek_word() == "USE") {
    scan_.take_word();
    extras.use = expect_own_name("a name behind `USE`");
    node.span = scan_.span_from(begin);
    build_.give(node, extras);
    return extras.use.empty() ? std::nullopt : std::optional(node);
  }
  if (scan_.peek_word() == "DEF") {
    scan_.take_word();
    extras.def = expect_own_name("a name behind `DEF`");
  }
  node.type = expect_name("the type of a node");
  if (node.type.empty()) return std::nullopt;
  read_node_body(node, extras);
  node.span = scan_.span_from(begin);
  return node;
}

/// A brace that was forgotten is assumed where a body can begin: `geometry Box size 1 1 1 }`.
void ClassicReader::read_node_body(NodeSyntax& node, NodeExtras& extras) {
  if (scan_.next() != '{') {
    expected(fmt::format("`{{` behind `{}`", shown(node.type.text)));
    if (!looks_like_node_type(node.type.text) || !scan_.next_is(kWordStart)) return build_.give(node, extras);
  } else if (depth_ >= kMaxNesting) {
    build_.too_deep(node.type.span);
    build_.give(node, extras);
    return scan_.skip_item();
  }
  scan_.take('{');
  ++depth_;
  const OpenBody body = build_.open_body();
  const auto list_ends = [&] { return scan_.next() == ']' && open_lists_ > 0; };
  while (!stopped() && !scan_.at_end() && scan_.next() != '}' && !list_ends()) read_body_item();
  build_.close_body(body, node, extras);
  --depth_;
  if (!scan_.take('}')) not_closed(node.type.span, fmt::format("`{}`", shown(node.type.text)));
}

/// To the next field, or to what closes the node or the list around it.
void ClassicReader::skip_to_name() {
  const auto ends = [&] { return scan_.next() == '}' || (scan_.next() == ']' && open_lists_ > 0); };
  while (!scan_.at_end() && !scan_.next_is(kWordStart) && !ends()) scan_.skip_item();
}

void ClassicReader::read_body_item() {
  AccessType access{};
  if (scan_.next() == ']') {
    build_.mistake(scan_.next_span(), "`]` closes nothing here");
    stray_bracket_was_reported_ = true;
    skip_to_name();
  } else if (!scan_.next_is(kWordStart)) {
    expected("the name of a field or `}`");
    skip_to_name();
  } else if (access_word_is_next(access)) {
    read_interface(access, true);
  } else if (read_body_statement(scan_.peek_word())) {
    return;
  } else if (node_is_next()) {
    read_unnamed_node();
  } else {
    read_field();
  }
}

/// A node may have a field of its own named `field`, so the word counts only before a type.
bool ClassicReader::access_word_is_next(AccessType& access) const {
  const std::optional<AccessType> found = access_type(scan_.peek_word());
  if (!found) return false;
  access = *found;
  ClassicScanner ahead = scan_;
  ahead.take_word();
  return looks_like_field_type(ahead.peek_word());
}

void ClassicReader::read_field() {
  FieldSyntax field;
  field.name = scan_.take_word();
  field.value = read_value(field.name);
  build_.add_field(field, field.name.span);
}

/// `Transform { Shape { } }`, or a node whose `}` was forgotten before the next one. What was meant cannot be told; the node
/// is kept as an unplaced field, which the scene room passes over together with the names in it.
void ClassicReader::read_unnamed_node() {
  FieldSyntax field;
  const Span place = scan_.next_span();
  build_.mistake(place,
                 fmt::format("the name of a field is missing before this node, or a `}}` before {}", scan_.describe_next()));
  stray_bracket_was_reported_ = true;
  const auto node = read_node();
  if (node) field.value.hold(build_.add_node(*node));
  field.value.kind = ValueKind::nodes;
  field.value.span = place;
  field.value.damaged = true;
  build_.add_field(field, place);
}

void ClassicReader::read_interface(AccessType access, bool default_allowed) {
  InterfaceSyntax field;
  const std::uint32_t begin = scan_.offset();
  field.access = access;
  scan_.take_word();
  field.type = expect_name("the type of a field");
  if (field.type.empty()) return;
  field.name = expect_name("the name of a field");
  if (field.name.empty()) return;
  const bool has_default = access == AccessType::initialize_only || access == AccessType::input_output;
  if (scan_.peek_word() == "IS") {
    read_is(field.value);
  } else if (has_default && default_allowed) {
    field.value = read_value(field.name);
  }
  field.span = scan_.span_from(begin);
  build_.add_interface(field);
}

/// `[ inputOnly SFTime start, ... ]` of a PROTO or an EXTERNPROTO.
Range<InterfaceSyntax> ClassicReader::read_interfaces(const Name& proto, bool defaults_allowed) {
  const std::size_t mark = build_.interfaces.open();
  const Span bracket = scan_.next_span();
  if (!scan_.take('[')) {
    expected(fmt::format("`[` and the interface of `{}`", shown(proto.text)));
    return {};
  }
  bool skipping = false;
  while (!stopped() && !scan_.at_end() && scan_.next() != ']' && scan_.next() != '}') {
    if (const auto access = access_type(scan_.peek_word())) {
      skipping = false;
      read_interface(*access, defaults_allowed);
    } else {
      if (!skipping) expected("an access type such as `inputOutput`, or `]`");
      skipping = true;
      scan_.skip_item();
    }
  }
  if (!scan_.take(']')) not_closed(bracket, "`[`");
  return build_.interfaces.close(mark, build_.document.interfaces);
}

}  // namespace plugc

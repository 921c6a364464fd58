// Nodes are kept in the order in which they end, so that each stands behind what it holds. The second phase, vrml1_scene.h,
// makes X3D of them.
//
// Source: The Virtual Reality Modeling Language, version 1.0 (26 May 1995).

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/read_document.h"
#include "document/vrml1_reader.h"
#include "document/vrml1_scene.h"

namespace plugc {
namespace {

// In place of a node, for a name:
constexpr std::uint32_t kOpen = UINT32_MAX;      // its node has not ended yet
constexpr std::uint32_t kLost = UINT32_MAX - 1;  // its node was passed over, which was reported

}  // namespace

Vrml1Tree Vrml1Reader::read() {
  const std::size_t mark = children_.open();
  while (!stopped() && !scan_.at_end()) {
    if (scan_.next_is(kWordStart)) {
      read_child();
    } else {
      expected("a node");
      scan_.skip_item();
    }
  }
  tree_.roots = children_.close(mark, tree_.child_pool);
  return std::move(tree_);
}

void Vrml1Reader::read_child() {
  const std::uint32_t begin = scan_.offset();
  const auto node = scan_.peek_word() == "USE" ? read_use() : read_node();
  if (node && build_.admit(scan_.span_from(begin))) children_.add({*node, scan_.span_from(begin)});
}

/// Behind DEF or USE; cut, as each visit to the node may write it.
Name Vrml1Reader::take_name() {
  Name name = scan_.take_bare();
  build_.limit(name);
  return name;
}

std::optional<std::uint32_t> Vrml1Reader::read_use() {
  scan_.take_word();
  const Name name = take_name();
  if (name.empty()) {
    expected("a name behind `USE`");
    return std::nullopt;
  }
  const auto found = definitions_.find(name.text);
  if (found == definitions_.end()) {
    build_.diagnostics.report(DiagnosticId::use_unknown, name.span,
                              fmt::format("no `DEF {}` stands before this `USE`", shown(name.text)));
    return std::nullopt;
  }
  if (found->second == kOpen) {
    build_.diagnostics.report(
        DiagnosticId::use_cycle, name.span,
        fmt::format("this `USE` stands inside `DEF {}`, so that it would contain itself", shown(name.text)));
  }
  if (found->second >= kLost) return std::nullopt;
  tree_.nodes[found->second].is_used = true;
  return found->second;
}

/// `DEF name Type { ... }` or `Type { ... }`.
std::optional<std::uint32_t> Vrml1Reader::read_node() {
  Vrml1Node node;
  if (scan_.peek_word() == "DEF") {
    scan_.take_word();
    node.def = take_name();
    if (node.def.empty()) expected("a name behind `DEF`");
  }
  if (!scan_.next_is(kWordStart)) {
    expected("the type of a node");
    return std::nullopt;
  }
  node.type = scan_.take_word();
  node.info = find_vrml1_node(node.type.text);
  if (!node.def.empty()) definitions_[node.def.text] = kLost;
  if (scan_.next() != '{') {
    expected(fmt::format("`{{` behind `{}`", shown(node.type.text)));
    return std::nullopt;
  }
  if (depth_ >= kMaxNesting) {
    build_.too_deep(node.type.span);
    scan_.skip_item();
    return std::nullopt;
  }
  if (!node.def.empty()) definitions_[node.def.text] = kOpen;
  read_body(node);
  const bool is_kept = node.info != nullptr && build_.admit(node.type.span);
  const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
  if (!node.def.empty()) definitions_[node.def.text] = is_kept ? index : kLost;
  if (!is_kept) return std::nullopt;
  tree_.nodes.push_back(node);
  return index;
}

void Vrml1Reader::read_body(Vrml1Node& node) {
  scan_.take('{');
  ++depth_;
  const std::size_t children = children_.open();
  Body body{fields_.open(), {}};
  while (!stopped() && !scan_.at_end() && scan_.next() != '}') read_body_item(node, body);
  node.fields = fields_.close(body.first_field, tree_.fields);
  node.children = children_.close(children, tree_.child_pool);
  --depth_;
  if (!scan_.take('}')) not_closed(node.type.span, fmt::format("`{}`", shown(node.type.text)));
  if (node.info == nullptr) report_unknown_node(node.type);
}

void Vrml1Reader::read_body_item(Vrml1Node& node, Body& body) {
  const std::string_view word = scan_.peek_word();
  if (word.empty()) {
    expected("the name of a field, a node or `}`");
    return scan_.skip_item();
  }
  if (word == "fields") return read_declarations(body);
  if (word == "isA") return read_is_a(node);
  if (node.info == nullptr) return pass_unknown_body();
  const Vrml1FieldInfo* field = find_field(*node.info, word);
  if (word == "DEF" || word == "USE" || (field == nullptr && scan_.brace_follows_word())) {
    return holds_nodes(node.info->kind) ? read_child() : read_misplaced_child(node);
  }
  if (field != nullptr) return read_field(node, *field, body);
  read_unknown_field(node, body);
}

/// It is read, for its own mistakes and its name, and left out.
void Vrml1Reader::read_misplaced_child(const Vrml1Node& node) {
  build_.mistake(scan_.next_span(),
                 fmt::format("`{}` holds no nodes; a `}}` may be missing before {}", node.info->name, scan_.describe_next()));
  const std::size_t mark = children_.open();
  read_child();
  std::vector<Vrml1Child> dropped;
  children_.close(mark, dropped);
}

/// `fields [ SFFloat width, SFFloat height ]`: the fields of a node that the specification does not have.
void Vrml1Reader::read_declarations(Body& body) {
  scan_.take_word();
  const Span bracket = scan_.next_span();
  if (!scan_.take('[')) return expected("`[` and the fields of the node");
  while (!stopped() && scan_.next_is(kWordStart)) {
    scan_.take_word();
    const Name name = scan_.take_bare();
    if (name.empty()) return expected("the name of a field");
    body.declared.insert(name.text);
  }
  if (!scan_.take(']')) not_closed(bracket, "`[`");
}

/// `isA [ "Cube" ]`: the first one that is known tells how to read a node that is not.
void Vrml1Reader::read_is_a(Vrml1Node& node) {
  constexpr Vrml1FieldInfo kIsA = {"isA", Vrml1Type::MFString};
  scan_.take_word();
  const std::size_t mistakes = build_.mistake_count();
  const ValueSyntax types = read_value(node, kIsA);
  for (const MappedText& type : build_.document.of(types.strings())) {
    if (node.info == nullptr) node.info = find_vrml1_node(type.text());
  }
  if (build_.mistake_count() != mistakes && node.info != nullptr) pass_to_item(node, {fields_.open(), {}});
}

/// Up to its closing brace. The names inside are remembered: a USE of one is no further mistake.
void Vrml1Reader::pass_unknown_body() {
  std::size_t open = 0;
  while (!scan_.at_end() && (open > 0 || scan_.next() != '}')) {
    if (scan_.next() == '{') ++open;
    if (scan_.next() == '}') --open;
    const bool defines = scan_.peek_word() == "DEF";
    scan_.take_token();
    if (const Name name = defines ? take_name() : Name(); !name.empty()) definitions_[name.text] = kLost;
  }
}

/// Once for each type.
void Vrml1Reader::report_unknown_node(const Name& type) {
  if (stopped() || !unknown_nodes_.insert(std::string(shown(type.text))).second) return;
  build_.diagnostics.report(DiagnosticId::node_unknown, type.span,
                            fmt::format("VRML 1.0 has no node `{}`; each one is passed over", shown(type.text)));
}

void Vrml1Reader::read_field(const Vrml1Node& node, const Vrml1FieldInfo& info, const Body& body) {
  const std::size_t mistakes = build_.mistake_count();
  Vrml1Field field{&info, scan_.take_word(), {}};
  field.value = read_value(node, info);
  if (build_.mistake_count() != mistakes) pass_to_item(node, body);
  add_field(node, field, body);
}

/// Once in a node: shapes without number may ask for it.
void Vrml1Reader::add_field(const Vrml1Node& node, const Vrml1Field& field, const Body& body) {
  const auto known = std::find_if(fields_.begin(body.first_field), fields_.end(),
                                  [&](const Vrml1Field& one) { return one.info == field.info; });
  if (!build_.admit(field.name.span)) return;
  if (known == fields_.end()) return fields_.add(field);
  build_.diagnostics.report(
      DiagnosticId::field_repeated, field.name.span,
      fmt::format("`{}` of `{}` is given twice; the last value counts", field.info->name, node.info->name));
  if (field.value.kind != ValueKind::none) *known = field;
}

void Vrml1Reader::read_unknown_field(const Vrml1Node& node, const Body& body) {
  const Name name = scan_.take_word();
  if (!body.declared.contains(name.text)) {
    build_.diagnostics.report(DiagnosticId::field_unknown, name.span,
                              fmt::format("`{}` of VRML 1.0 has no field `{}`", node.info->name, shown(name.text)));
  }
  pass_to_item(node, body);
}

/// To the next thing that can stand in the node's body, or its end.
void Vrml1Reader::pass_to_item(const Vrml1Node& node, const Body& body) {
  const auto begins_item = [&](std::string_view word) {
    return word == "DEF" || word == "USE" || word == "fields" || word == "isA" || body.declared.contains(word) ||
           (node.info != nullptr && find_field(*node.info, word) != nullptr) || scan_.brace_follows_word();
  };
  while (!scan_.at_end() && scan_.next() != '}') {
    const std::string_view word = scan_.peek_word();
    if (!word.empty() && begins_item(word)) return;
    scan_.skip_item();
  }
}

// Mistakes

/// Says nothing where the same token was unexpected before: that is one mistake.
void Vrml1Reader::expected(std::string_view what) {
  if (unexpected_at_ == scan_.offset()) return;
  unexpected_at_ = scan_.offset();
  end_was_reported_ |= scan_.at_end();
  build_.mistake(scan_.next_span(), fmt::format("expected {}, found {}", what, scan_.describe_next()));
}

void Vrml1Reader::not_closed(const Span& span, std::string_view what) {
  if (stopped() || end_was_reported_) return;
  end_was_reported_ = scan_.at_end();
  build_.mistake(span, fmt::format("{} is not closed before {}", what, scan_.describe_next()));
}

Document read_vrml1(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  constexpr std::string_view kHeader = "#VRML V1.0 ascii";
  DocumentBuilder build(source, Encoding::vrml1, sources, diagnostics);
  build.document.version_major = 1;
  const std::string_view text = sources.text(source);
  const std::size_t bom = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::size_t line = std::min(text.find_first_of("\r\n", bom), text.size());
  if (!text.substr(bom).starts_with(kHeader)) {
    diagnostics.report(DiagnosticId::header_odd, {source, static_cast<std::uint32_t>(bom), static_cast<std::uint32_t>(line)},
                       fmt::format("this header is not quite `{}`, but is read as that", kHeader));
  }
  const Vrml1Tree tree = Vrml1Reader(build).read();
  Vrml1Scene(tree, build).write();
  return std::move(build.document);
}

}  // namespace plugc

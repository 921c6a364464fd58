// Recursive descent over the tokens of ClassicScanner, bounded by kMaxNesting.
// Source: ISO/IEC 19776-2 (grammar in A.3), ISO/IEC 14772-1, annex A.
//
// Each mistake is reported once, where it stands. Then the nearest reading is taken (a missing `{` is assumed, a list
// without `]` ends before what cannot belong to it) or tokens are skipped up to the next field or closing bracket.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/classic_reader.h"
#include "document/read_document.h"

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

bool is_head_word(std::string_view word) {
  return word == "PROFILE" || word == "COMPONENT" || word == "UNIT" || word == "META";
}

bool looks_like_field_type(std::string_view word) {
  return word.starts_with("SF") || word.starts_with("MF");
}

/// Whether `text` begins with `lower`, in letters of either case.
bool begins_with(std::string_view text, std::string_view lower) {
  const auto equal = [](char small, char any) {
    return small == any || (any >= 'A' && any <= 'Z' && small == any - 'A' + 'a');
  };
  return text.size() >= lower.size() && std::equal(lower.begin(), lower.end(), text.begin(), equal);
}

/// The words of the first line: `#X3D V3.2 utf8`.
std::vector<std::string_view> header_words(std::string_view text) {
  std::vector<std::string_view> words;
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  while (words.size() < 3) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    words.push_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
  return words;
}

/// `V3.2`, also where it hangs on the first word; "" when there is none.
std::string_view version_word(const std::vector<std::string_view>& words, std::size_t name_size) {
  const std::string_view glued = words[0].substr(std::min(name_size, words[0].size()));
  return glued.empty() && words.size() > 1 ? words[1] : glued;
}

/// The first word that a header spells otherwise than the standard, or the last one when there are too few.
std::optional<std::string_view> odd_word(const std::vector<std::string_view>& words, std::string_view name) {
  if (words[0] != name) return words[0];
  if (words.size() > 1 && !words[1].starts_with('V')) return words[1];
  if (words.size() < 3) return words.back();
  return words[2] == "utf8" ? std::nullopt : std::optional(words[2]);
}

}  // namespace

bool is_classic_header(std::string_view text) {
  return begins_with(text, "#x3d") || begins_with(text, "#vrml");
}

bool is_vrml1_header(std::string_view text) {
  return begins_with(text, "#vrml v1");
}

Document ClassicReader::read(std::string_view version, const Span& version_span) {
  if (!version.empty()) set_version(build_, version, version_span);
  const std::string_view text = build_.sources.text(build_.document.source);
  constexpr std::size_t kFieldsOfNode = 2;  // more than usual
  const auto braces = static_cast<std::size_t>(std::count(text.begin(), text.end(), '{'));
  build_.expect(braces, kFieldsOfNode * braces, 0);
  const std::size_t mark = build_.statements.open();
  read_statements(false);
  build_.document.statements = build_.statements.close(mark, build_.document.statement_pool);
  return std::move(build_.document);
}

// Mistakes

/// Says nothing where the same token was unexpected before: that is one mistake.
void ClassicReader::expected(std::string_view what) {
  if (unexpected_at_ == scan_.offset()) return;
  unexpected_at_ = scan_.offset();
  end_was_reported_ |= scan_.at_end();
  build_.mistake(scan_.next_span(), fmt::format("expected {}, found {}", what, scan_.describe_next()));
}

Name ClassicReader::expect_name(std::string_view what) {
  if (!scan_.next_is(kWordStart)) {
    expected(what);
    return {};
  }
  return scan_.take_word();
}

/// A name that the author chooses: none of the words of the grammar.
Name ClassicReader::expect_own_name(std::string_view what) {
  static constexpr std::array<std::string_view, 20> kKeywords = {
      "AS", "DEF",  "EXPORT", "EXTERNPROTO", "FALSE",    "IMPORT",       "IS",    "NULL",      "PROTO",      "ROUTE",
      "TO", "TRUE", "USE",    "eventIn",     "eventOut", "exposedField", "field", "inputOnly", "outputOnly", "inputOutput"};
  const Name name = expect_name(what);
  if (std::find(kKeywords.begin(), kKeywords.end(), name.text) != kKeywords.end()) {
    build_.mistake(name.span, fmt::format("`{}` is a word of the language; choose another name", name.text));
  }
  return name;
}

/// `TO` between the ends of a ROUTE; where it was forgotten a name goes on.
bool ClassicReader::expect_to() {
  if (scan_.peek_word() == "TO") {
    scan_.take_word();
    return true;
  }
  expected("`TO`");
  return scan_.next_is(kWordStart);
}

bool ClassicReader::expect_dot() {
  if (scan_.take('.')) return true;
  expected("`.`");
  return false;
}

/// At the end of the text every open bracket lacks its other half; that is one mistake, told for the innermost.
void ClassicReader::not_closed(const Span& span, std::string_view what) {
  if (stopped() || end_was_reported_ || (scan_.at_end() && stray_bracket_was_reported_)) return;
  end_was_reported_ = scan_.at_end();
  build_.mistake(span, fmt::format("{} is not closed before {}", what, scan_.describe_next()));
}

// Statements

/// Up to the end of the text, or the closing brace (which stays).
void ClassicReader::read_statements(bool inside_braces) {
  bool skipping = false;
  while (!stopped() && !scan_.at_end()) {
    if (scan_.next_is(kWordStart)) {
      skipping = false;
      read_statement();
    } else if (inside_braces && scan_.next() == '}') {
      return;
    } else {
      if (!skipping && scan_.next() == '}') {
        build_.mistake(scan_.next_span(), "`}` closes nothing here");
      } else if (!skipping) {
        expected("a node or a statement");
      }
      skipping = true;
      scan_.skip_item();
    }
  }
}

void ClassicReader::read_statement() {
  const std::string_view word = scan_.peek_word();
  if (is_head_word(word)) return read_head_statement(word);
  scene_began_ = true;
  if (read_body_statement(word)) return;
  if (word == "IMPORT") return read_import();
  if (word == "EXPORT") return read_export();
  if (auto node = read_node()) build_.add_statement(std::move(*node));
}

/// ISO/IEC 19776-2, 4.1: these stand between the header and the scene.
void ClassicReader::read_head_statement(std::string_view word) {
  if (scene_began_) {
    build_.diagnostics.report(DiagnosticId::header_odd, scan_.next_span(),
                              fmt::format("`{}` belongs in front of the scene, behind the header", word));
  }
  if (word == "PROFILE") return read_profile();
  if (word == "COMPONENT") return read_component();
  if (word == "META") return read_meta();
  read_unit();
}

/// The statements that may also stand inside a node.
bool ClassicReader::read_body_statement(std::string_view word) {
  if (!looks_like_node_type(word)) return false;  // a field's name
  if (word == "ROUTE") {
    read_route();
  } else if (word == "PROTO") {
    read_proto();
  } else if (word == "EXTERNPROTO") {
    read_externproto();
  } else {
    return false;
  }
  return true;
}

/// The rest of the line in which an incomplete statement began, up to a bracket.
void ClassicReader::skip_line(std::uint32_t begin) {
  const std::string_view text = build_.sources.text(build_.document.source);
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  while (scan_.offset() < end && std::string_view("[]{}").find(scan_.next()) == std::string_view::npos) scan_.skip_item();
}

void ClassicReader::read_profile() {
  scan_.take_word();
  build_.document.head.profile = expect_name("the name of a profile");
}

/// `Shaders:1` is one word, because `:` may stand in names.
void ClassicReader::read_component() {
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  Name name = expect_name("the name of a component");
  const std::size_t colon = std::min(name.text.rfind(':'), name.text.size());
  const std::string_view level = name.text.substr(std::min(colon + 1, name.text.size()));
  name = {name.text.substr(0, colon), {name.span.source, name.span.begin, name.span.begin + static_cast<std::uint32_t>(colon)}};
  if (!name.empty()) build_.add_component(name, level, scan_.span_from(begin));
}

void ClassicReader::read_unit() {
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const Name category = expect_name("the category of a unit");
  const Name name = expect_name("the name of a unit");
  if (!scan_.next_is(kNumberStart)) return expected("a conversion factor");
  const std::string_view factor = build_.sources.text(scan_.next_span());
  scan_.skip_item();
  if (!category.empty() && !name.empty()) build_.add_unit(category, name, factor, scan_.span_from(begin));
}

void ClassicReader::read_meta() {
  MetaSyntax meta;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  for (Name* one : {&meta.name, &meta.content}) {
    if (scan_.next() != '"') return expected("a string");
    *one = read_string_name();
  }
  meta.span = scan_.span_from(begin);
  build_.add_meta(meta);
}

Name ClassicReader::read_string_name() {
  const Span place = scan_.next_span();
  MappedText text;
  scan_.take_string(text);
  return {build_.document.decoded_names.emplace_back(text.text()), place};
}

void ClassicReader::read_route() {
  RouteSyntax route;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const bool complete = !(route.from_node = expect_name("the name of a node")).empty() && expect_dot() &&
                        !(route.from_field = expect_name("the name of a field")).empty() && expect_to() &&
                        !(route.to_node = expect_name("the name of a node")).empty() && expect_dot() &&
                        !(route.to_field = expect_name("the name of a field")).empty();
  if (!complete) return skip_line(begin);
  route.span = scan_.span_from(begin);
  build_.add_statement(route);
}

void ClassicReader::read_import() {
  ImportSyntax import;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const bool complete = !(import.inline_def = expect_name("the name of an Inline node")).empty() && expect_dot() &&
                        !(import.name = expect_name("the name of a node")).empty();
  if (!complete) return skip_line(begin);
  import.alias = import.name;
  if (scan_.peek_word() == "AS") {
    scan_.take_word();
    import.alias = expect_name("a name");
  }
  import.span = scan_.span_from(begin);
  if (!import.alias.empty()) build_.add_statement(StatementKind::import, import);
}

void ClassicReader::read_export() {
  ImportSyntax exported;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  exported.name = exported.alias = expect_name("the name of a node");
  if (scan_.peek_word() == "AS") {
    scan_.take_word();
    exported.alias = expect_name("a name");
  }
  exported.span = scan_.span_from(begin);
  if (!exported.name.empty() && !exported.alias.empty()) build_.add_statement(StatementKind::export_, exported);
}

void ClassicReader::read_proto() {
  ProtoSyntax proto;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  proto.name = expect_own_name("the name of a prototype");
  proto.interface = read_interfaces(proto.name, true);
  const Span brace = scan_.next_span();
  if (!scan_.take('{')) return expected("`{` and the body of the prototype");
  if (depth_ >= kMaxNesting) {
    build_.too_deep(proto.name.span);
    while (!scan_.at_end() && scan_.next() != '}') scan_.skip_item();
  }
  ++depth_;
  const std::size_t mark = build_.statements.open();
  read_statements(true);
  proto.body = build_.statements.close(mark, build_.document.statement_pool);
  --depth_;
  if (!scan_.take('}')) not_closed(brace, "`{`");
  proto.span = scan_.span_from(begin);
  if (!proto.name.empty()) build_.add_statement(StatementKind::proto, proto);
}

void ClassicReader::read_externproto() {
  ProtoSyntax proto;
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  proto.name = expect_own_name("the name of a prototype");
  proto.interface = read_interfaces(proto.name, false);
  if (scan_.next() != '"' && scan_.next() != '[') return expected("the urls of the prototype");
  const Span place = scan_.next_span();
  const ValueSyntax urls = read_value(proto.name);
  if (urls.kind != ValueKind::strings && urls.kind != ValueKind::empty) {
    return build_.mistake(place, "the urls of a prototype are strings");
  }
  proto.urls = urls.strings();
  proto.span = scan_.span_from(begin);
  if (!proto.name.empty()) build_.add_statement(StatementKind::externproto, proto);
}

// Nodes and interfaces

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
  } else if (!read_body_statement(scan_.peek_word())) {
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

Document read_classic(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  const std::string_view text = sources.text(source);
  const std::size_t bom = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const auto words = header_words(text.substr(bom));
  const bool vrml = !words.empty() && begins_with(words[0], "#vrml");
  ClassicReader reader(source, vrml ? Encoding::vrml2 : Encoding::classic, sources, diagnostics);
  if (words.empty()) return reader.read("", {});
  const auto span_of = [&](std::string_view word) {
    const auto begin = static_cast<std::uint32_t>(word.data() - text.data());
    return Span{source, begin, begin + static_cast<std::uint32_t>(word.size())};
  };
  const std::string_view name = vrml ? "#VRML" : "#X3D";
  const std::string_view word = version_word(words, name.size());
  const std::string_view version = word.substr(begins_with(word, "v") ? 1 : 0);
  if (const auto odd = odd_word(words, name)) {
    diagnostics.report(DiagnosticId::header_odd, span_of(*odd),
                       fmt::format("this header is not quite `{} V{} utf8`, but is read as that", name,
                                   !version.empty() ? shown(version)
                                   : vrml           ? "2.0"
                                                    : "3.0"));
  }
  return reader.read(version, span_of(word));
}

}  // namespace plugc

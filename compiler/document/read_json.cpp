// One pass over the text: brackets are entered and left through the scanner, and what stands in them goes straight into the
// Document. Members may come in any order, so what needs another member (the type of a ProtoInstance, the connections of
// an IS) waits until the object ends. Source: ISO/IEC 19776-5 (draft).

#include "document/json_reader.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "document/read_document.h"

namespace plugc {

// The file

Document JsonReader::read() {
  const std::size_t mark = build_.statements.open();
  read_file();
  build_.document.statements = build_.statements.close(mark, build_.document.statement_pool);
  return std::move(build_.document);
}

void JsonReader::read_file() {
  const Name file{"X3D", scan_.next_span()};
  bool found = false;
  Name key;
  JsonBracket object;
  if (!enter(object, file)) return;
  while (scan_.next_member(object, key)) {
    if (key.text != "X3D") {
      scan_.skip_value();
      continue;
    }
    found = true;
    read_x3d(key);
  }
  if (!found) scan_.mistake(file.span, "this object holds no `X3D`");
  if (!scan_.at_end()) scan_.mistake(scan_.next_span(), "text stands behind the scene");
}

void JsonReader::read_x3d(const Name& owner) {
  bool found = false;
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "Scene") {
      found = true;
      read_statements(key);
    } else if (key.text == "@version") {
      const Name version = read_name(key);
      set_version(build_, version.text, version.span);
    } else if (key.text == "head") {
      read_head(key);
    } else if (key.text == "@profile") {
      build_.document.head.profile = read_name(key);
    } else if (first_of(key) == '@') {
      scan_.skip_value();
    } else {
      pass_over(key, "`head` or `Scene`");
    }
  }
  if (!found) scan_.mistake(owner.span, "`X3D` holds no `Scene`");
}

/// `meta`, `component` and `unit`, each an object or a list of them.
void JsonReader::read_head(const Name& owner) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "meta" || key.text == "component" || key.text == "unit") {
      for_each_object(key, [&] { read_head_entry(key); });
    } else {
      scan_.skip_value();
    }
  }
}

void JsonReader::read_head_entry(const Name& owner) {
  Name name, content, category, level, factor, key;
  JsonBracket object;
  const std::array<NamedKey, 5> keys = {
      {{"@name", &name}, {"@content", &content}, {"@category", &category}, {"@level", &level}, {"@conversionFactor", &factor}}};
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    const auto known = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& one) { return one.key == key.text; });
    const bool scalar = scan_.next() != '{' && scan_.next() != '[';
    if (known == keys.end() || !scalar) {
      scan_.skip_value();
    } else {
      *known->name = scan_.take_name();  // a string, or the number that a level is
    }
  }
  const Span span = scan_.span_from(object.place.begin);
  if (name.empty()) return;
  if (owner.text == "component") build_.add_component(name, level.text, span);
  if (owner.text == "unit") build_.add_unit(category, name, factor.text, span);
  if (owner.text == "meta") build_.add_meta({name, content, span});
}

/// `-children` of a Scene or a ProtoBody.
void JsonReader::read_statements(const Name& owner) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (first_of(key) == '-') {
      read_nodes(NodesAre::statements, behind_mark(key));
    } else if (first_of(key) == '@') {
      scan_.skip_value();
    } else {
      pass_over(key, "`-children`");
    }
  }
}

// Keys

/// Enters the object that is the owner's value; anything else is reported and skipped.
bool JsonReader::enter(JsonBracket& object, const Name& owner) {
  if (scan_.next() == '{') {
    object = scan_.open();
    return true;
  }
  scan_.mistake(scan_.next_span(),
                fmt::format("expected an object for `{}`, found {}", shown(owner.text), scan_.describe_next()));
  scan_.skip_value();
  return false;
}

/// Skips a member, and reports it unless it is a remark.
void JsonReader::pass_over(const Name& key, std::string_view expected) {
  if (!is_remark(key)) scan_.mistake(key.span, fmt::format("expected {}, found `{}`", expected, shown(key.text)));
  scan_.skip_value();
}

Name JsonReader::read_name(const Name& key) {
  const char next = scan_.next();
  if (next != '"') {
    scan_.mistake(scan_.next_span(),
                  fmt::format("`{}` is a string; put {} into quotes", shown(key.text), scan_.describe_next()));
  }
  if (next != '{' && next != '[') return scan_.take_name();
  scan_.skip_value();
  return {};
}

bool JsonReader::required(const Name& name, const Name& owner, std::string_view key) {
  if (name.empty()) scan_.mistake(owner.span, fmt::format("`{}` needs `{}`", shown(owner.text), key));
  return !name.empty();
}

/// An object of names alone; other keys are passed over.
void JsonReader::read_names(const Name& owner, std::initializer_list<NamedKey> keys) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    const auto* known = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& one) { return one.key == key.text; });
    if (known != keys.end()) {
      *known->name = read_name(key);
    } else {
      pass_over(key, fmt::format("a key of `{}`", shown(owner.text)));
    }
  }
}

Document read_json(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  return JsonReader(source, sources, diagnostics).read();
}

}  // namespace plugc

// One stage as text: its head (version, extensions, precision, castle_ names that are used before anything declares them),
// then each unit as write_unit makes it.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/unit_writer.h"

namespace plugc {
namespace {

class HeadWriter {
 public:
  HeadWriter(const Composition& composition, ShaderStage stage, Declared& declared)
      : c_(composition), stage_(stage), declared_(declared) {
    for (const PlacedUnit& unit : c_.units) {
      if (unit.stage == stage && !unit.dropped) units_.push_back(&unit);
    }
  }
  MappedText write();

 private:
  void write_version();
  void write_extensions();
  void write_castle_names();
  void write_declaration(const std::string& name);
  std::set<std::string> undeclared_names() const;
  std::set<std::string> inputs_of_shader() const;

  const Composition& c_;
  ShaderStage stage_;
  Declared& declared_;
  std::vector<const PlacedUnit*> units_;
  MappedText head_;
};

/// A part's own `#version` is honoured as a minimum.
void HeadWriter::write_version() {
  if (c_.target == Target::essl300) return head_.append_generated("#version 300 es\n");
  int version = 330;
  Span origin;
  for (const PlacedUnit* unit : units_) {
    const VersionDirective& asked = unit->code->outline.version;
    if (asked.profile == "es" || asked.number <= version) continue;
    version = asked.number;
    origin = unit->code->span(asked.begin, asked.end);
  }
  head_.append_generated(fmt::format("#version {} core\n", version), origin);
}

void HeadWriter::write_extensions() {
  std::set<std::string_view> written;
  for (const PlacedUnit* unit : units_) {
    const MappedText& text = unit->code->text;
    for (const TextRange& line : unit->code->outline.extensions) {
      if (!written.insert(std::string_view(text.text()).substr(line.begin, line.end - line.begin)).second) continue;
      head_.append(text, line.begin, line.end);
      head_.append_generated("\n");
    }
  }
}

/// castle_ names that a unit uses and neither it nor an earlier one declares.
std::set<std::string> HeadWriter::undeclared_names() const {
  std::set<std::string> undeclared;
  std::set<std::string, std::less<>> declared;
  for (const PlacedUnit* unit : units_) {
    for (const GlobalOutline& global : unit->code->outline.globals) {
      if (global.name.starts_with("castle_")) declared.insert(c_.final_name(*unit, global.name));
    }
    for (const std::string& used : unit->code->castle_names) {
      std::string name = c_.final_name(*unit, used);
      if (!declared.contains(name)) undeclared.insert(std::move(name));
    }
  }
  return undeclared;
}

/// Varyings that a ComposedShader reads and nobody writes: undefined in old GLSL, but declared (and so linked) there.
std::set<std::string> HeadWriter::inputs_of_shader() const {
  std::set<std::string> inputs;
  if (c_.recipe.shader < 0 || stage_ != ShaderStage::vertex) return inputs;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.stage == ShaderStage::fragment && c_.owners[unit.owner].kind == OwnerKind::shader) {
      inputs.insert(unit.code->castle_names.begin(), unit.code->castle_names.end());
    }
  }
  std::erase_if(inputs, [](const std::string& name) {
    const auto meaning = find_castle_name(name);
    return !meaning || meaning->kind != CastleKind::varying;
  });
  for (const PlacedUnit* unit : units_) {
    for (const GlobalOutline& global : unit->code->outline.globals) inputs.erase(std::string(global.name));
  }
  return inputs;
}

void HeadWriter::write_declaration(const std::string& name) {
  const auto meaning = find_castle_name(name);
  if (!meaning) return;
  const bool vertex = stage_ == ShaderStage::vertex;
  if ((meaning->kind == CastleKind::attribute && !vertex) || (meaning->kind == CastleKind::output && vertex)) return;
  const bool is_out = meaning->kind == CastleKind::output || (meaning->kind == CastleKind::varying && vertex);
  const Storage storage = meaning->kind == CastleKind::uniform ? Storage::uniform : is_out ? Storage::out : Storage::in;
  const std::string_view word = storage == Storage::uniform ? "uniform" : is_out ? "out" : "in";
  head_.append_generated(fmt::format("{} {} {};\n", word, meaning->type, name));
  declared_.globals[name] = {fmt::format("{} {}", static_cast<int>(storage), meaning->type), {}};
}

void HeadWriter::write_castle_names() {
  std::set<std::string> names = undeclared_names();
  names.merge(inputs_of_shader());
  for (const std::string& name : names) write_declaration(name);
}

MappedText HeadWriter::write() {
  write_version();
  write_extensions();
  if (c_.target == Target::essl300) {
    head_.append_generated(
        "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler2DShadow;\n"
        "precision highp samplerCube;\nprecision highp samplerCubeShadow;\nprecision highp sampler3D;\n");
  }
  write_castle_names();
  return std::move(head_);
}

}  // namespace

MappedText stage_text(Composition& composition, ShaderStage stage) {
  Declared declared;
  MappedText text = HeadWriter(composition, stage, declared).write();
  for (const PlacedUnit& unit : composition.units) {
    if (unit.stage != stage || unit.dropped) continue;
    text.append_generated("\n");
    text.append(write_unit(composition, unit, declared));
  }
  return text;
}

}  // namespace plugc

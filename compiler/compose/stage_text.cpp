// One stage as text: its head (version, extensions, precision, castle_ names that are used before anything declares them),
// then each unit as write_unit makes it.

#include <algorithm>
#include <set>
#include <unordered_set>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/output_locations.h"
#include "compose/unit_writer.h"
#include "compose/varying_passthrough.h"

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
  using Names = std::set<std::string_view>;  // of units' code, or kept by the composition
  void write_version();
  void write_extensions();
  void write_geometry();
  void write_switches();
  void write_castle_names();
  void write_declaration(std::string_view name);
  Names undeclared_names() const;
  Names unwritten_inputs() const;
  bool is_mentioned(std::string_view word) const;

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

bool HeadWriter::is_mentioned(std::string_view word) const {
  return std::any_of(units_.begin(), units_.end(),
                     [&](const PlacedUnit* unit) { return unit->code->text.text().find(word) != std::string::npos; });
}

/// What a geometry stage is told of itself, and the fragment stage of it.
void HeadWriter::write_geometry() {
  if (!c_.has_geometry) return;
  if (stage_ == ShaderStage::geometry) {
    head_.append_generated(c_.geometry.layout, c_.geometry.layout_span);
    if (is_mentioned("CASTLE_GEOMETRY_INPUT_SIZE"))
      head_.append_generated(fmt::format("#define CASTLE_GEOMETRY_INPUT_SIZE {}\n", c_.geometry.input_size));
  } else if (stage_ == ShaderStage::fragment && is_mentioned("HAS_GEOMETRY_SHADER")) {
    head_.append_generated("#define HAS_GEOMETRY_SHADER\n");
  }
}

/// castle_ names that a unit uses and neither it nor an earlier one declares.
HeadWriter::Names HeadWriter::undeclared_names() const {
  std::unordered_set<std::string_view> declared;
  Names undeclared;
  for (const PlacedUnit* unit : units_) {
    const bool kept = c_.keeps_names(*unit);
    const auto name_of = [&](std::string_view name) { return kept ? name : c_.final_name(*unit, name); };
    for (const GlobalOutline& global : unit->code->outline.globals) {
      if (global.name.starts_with("castle_")) declared.insert(name_of(global.name));
    }
    for (const std::string& used : unit->code->castle_names) {
      const std::string_view name = name_of(used);
      if (!declared.contains(name)) undeclared.insert(name);
    }
  }
  return undeclared;
}

/// Varyings that are read and that nobody writes: by a ComposedShader (undefined in old GLSL, but declared, and so linked,
/// there), or by a geometry shader in a depth pass, where what it makes of them is not seen.
HeadWriter::Names HeadWriter::unwritten_inputs() const {
  Names inputs;
  if (stage_ != ShaderStage::vertex) return inputs;
  for (const PlacedUnit& unit : c_.units) {
    const bool of_shader = unit.stage == ShaderStage::fragment && c_.owners[unit.owner].kind == OwnerKind::shader;
    const bool in_depth_pass = unit.stage == ShaderStage::geometry && c_.recipe.depth_pass;
    if (of_shader || in_depth_pass) inputs.insert(unit.code->castle_names.begin(), unit.code->castle_names.end());
  }
  std::erase_if(inputs, [](std::string_view name) {
    const auto meaning = find_castle_name(name);
    return !meaning || meaning->kind != CastleKind::varying;
  });
  for (const PlacedUnit* unit : units_) {
    for (const GlobalOutline& global : unit->code->outline.globals) inputs.erase(global.name);
  }
  return inputs;
}

void HeadWriter::write_declaration(std::string_view name) {
  const std::string_view before = c_.has_geometry ? name_before_geometry(name) : "";
  const auto meaning = find_castle_name(before.empty() ? name : before);
  if (!meaning) return;
  const bool vertex = stage_ == ShaderStage::vertex;
  const bool fragment = stage_ == ShaderStage::fragment;
  const bool varying = meaning->kind == CastleKind::varying;
  if ((meaning->kind == CastleKind::attribute && !vertex) || (meaning->kind == CastleKind::output && !fragment)) return;
  const bool is_out = meaning->kind == CastleKind::output || (varying && (fragment ? false : vertex || !before.empty()));
  const bool is_array = varying && stage_ == ShaderStage::geometry && !is_out;
  const Storage storage = meaning->kind == CastleKind::uniform ? Storage::uniform : is_out ? Storage::out : Storage::in;
  const std::string_view word = storage == Storage::uniform ? "uniform" : is_out ? "out" : "in";
  const std::string_view type = c_.type_of(*meaning);
  std::string text = fragment && is_out ? location_text(c_, name) : "";
  text.append(word);
  text.append(1, ' ').append(type).append(1, ' ').append(name);
  if (is_array) text += fmt::format("[{}]", c_.geometry.input_size);
  head_.append_generated(text += ";\n");
  declared_.globals[name] = {storage, type, "", nullptr, nullptr};
}

/// The switches that some call of the stage stands under.
void HeadWriter::write_switches() {
  if (c_.result.switches.empty()) return;
  std::set<std::size_t> asked;
  for (const PlacedUnit* unit : units_) {
    for (const std::vector<PlugCall>& calls : unit->calls) {
      for (const PlugCall& call : calls) asked.insert(call.guards.begin(), call.guards.end());
    }
  }
  for (const std::size_t one : asked) head_.append_generated(fmt::format("uniform bool {};\n", c_.result.switches[one].name));
}

void HeadWriter::write_castle_names() {
  Names names = undeclared_names();
  names.merge(unwritten_inputs());
  for (const std::string_view name : names) write_declaration(name);
}

MappedText HeadWriter::write() {
  write_version();
  write_extensions();
  write_geometry();
  if (c_.target == Target::essl300) {
    head_.append_generated(
        "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler2DShadow;\n"
        "precision highp samplerCube;\nprecision highp samplerCubeShadow;\nprecision highp sampler3D;\n");
  }
  write_switches();
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
    write_unit(composition, unit, declared, text);
  }
  return text;
}

}  // namespace plugc

// Chapter 3: which plug functions are called at which marker, and what is wrong with the others.
//
// A plug function of a shape or group reaches every marker of its name; on a light or texture it reaches that one's own
// code, and only where that has no such marker the shape's. A marker of an effect serves the parts and effects that come
// later. Calls stand in the order of the pieces, within a part in text order.
// A plug function returns void, and its parameters have the types of the table; `inout` may be weakened to `in`, `const in` or
// `out`, and const may be added to an `in` or dropped. A `const in` that the template reads afterwards may be strengthened,
// which is warned of. An author's marker asks for as many arguments as it passes; of
// overloads, those are called whose types fit. texture_color takes the sampler that reads its texture, and none for a
// ShaderTexture; on a shape it reaches the textures that it takes, but an effect of a texture that takes it nowhere has the
// wrong kind of sampler. A function that does not fit (one of the table, wherever it stands) makes its
// effect faulty; one that merely reaches no marker does not: an unknown name, a name offered only later, a plug of another
// stage, or a plug that this shape lacks.

#include <algorithm>

#include <fmt/format.h>

#include "oracle/program_model.h"

namespace plugc::oracle {

void say(std::set<std::string>& said, int line, std::string_view code) {
  said.insert(fmt::format("{:04} {}", line, code));
}

namespace {

std::string direction(const std::string& qualifier) {
  if (qualifier == "inout" || qualifier == "out") return qualifier;
  return "in";  // "", "in", "const", "const in"
}

bool fits_type(const std::string& type, const std::string& asked) {
  return type == asked || (asked == "samplerT" && type.starts_with("sampler"));
}

/// "material_light_ambient and _specular: vec4 (thesis) or vec3 (newer engine), both accepted".
bool fits_light_color(const FunctionModel& function, const PlugRow& row) {
  const bool either = row.name == "material_light_ambient" || row.name == "material_light_specular";
  return either && function.parameters[0].type == "vec3";
}

bool is_strengthened(const ParameterModel& own, const ParameterModel& asked) {
  return direction(own.qualifier) != "in" && asked.qualifier != "inout";
}

bool has_strengthened(const FunctionModel& function, const PlugRow& row) {
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    if (is_strengthened(function.parameters[i], row.parameters[i])) return true;
  }
  return false;
}

/// The row that a function of so many parameters follows: texture_color has a form without a sampler.
PlugRow form_for(const FunctionModel& function, PlugRow row) {
  if (row.name != "texture_color" || function.parameters.size() != 2) return row;
  row.parameters.erase(row.parameters.begin() + 1);
  row.keeps_changes.erase(row.keeps_changes.begin() + 1);
  return row;
}

bool fits_row(const FunctionModel& function, const PlugRow& row) {
  if (function.parameters.size() != row.parameters.size()) return false;
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const ParameterModel &own = function.parameters[i], &asked = row.parameters[i];
    if (!fits_type(own.type, asked.type) && !fits_light_color(function, row)) return false;
    if (is_strengthened(own, asked) && !row.keeps_changes[i]) return false;
  }
  return true;
}

class PlugFiller {
 public:
  PlugFiller(ProgramModel& program, std::set<std::string>& said) : program_(program), said_(said) {}

  void fill(std::size_t piece, const FunctionModel& function) {
    piece_ = piece;
    function_ = &function;
    if (function.returned != "void") return complain("effect-plug-not-void", true);
    const PlugRow* known = find_row(function.name);
    const PlugRow form = known == nullptr ? PlugRow() : form_for(function, *known);
    const PlugRow* row = known == nullptr ? nullptr : &form;
    if (row != nullptr && !row->replaced_by.empty()) complain("effect-deprecated-plug", false);
    if (row != nullptr && !fits_row(function, *row)) return complain("effect-wrong-signature", true);
    if (row != nullptr && has_strengthened(function, *row)) complain("effect-strengthened-parameter", false);
    const std::vector<Marker*> reached = reached_markers();
    if (reached.empty()) return complain(why_unreached(row), false);
    const auto of_use = std::count_if(reached.begin(), reached.end(), [&](Marker* m) { return has_overload_for(*m); });
    if (row == nullptr && of_use < std::ssize(reached)) return complain("effect-wrong-signature", true);
    if (of_use == 0) complain_of_texture(*reached.front());
    bool called = false;
    for (Marker* marker : reached) {
      if (!fits_marker(*marker, function)) continue;
      marker->calls.push_back({piece, &function});
      called = true;
    }
    if (called) note_need(reached);
  }

 private:
  const Piece& piece() const { return program_.pieces[piece_]; }

  void complain(std::string_view code, bool faulty) {
    say(said_, function_->line, code);
    if (faulty) program_.faulty.insert(piece().effect);
  }

  /// Where all markers are one other effect's, the function is nothing without that effect.
  void note_need(const std::vector<Marker*>& reached) {
    std::set<int> owners;
    for (const Marker* marker : reached)
      owners.insert(marker->piece < 0 ? -1 : program_.pieces[static_cast<std::size_t>(marker->piece)].effect);
    const int provider = *owners.begin();
    if (owners.size() == 1 && provider >= 0 && provider != piece().effect) program_.needs.push_back({piece().effect, provider});
  }

  /// No function of the part takes a texture that this one reaches. Another part of the effect may.
  void complain_of_texture(const Marker& marker) {
    if (piece().scope.kind != ScopeKind::texture) return complain("effect-plug-absent", false);
    const bool other_part = std::any_of(program_.pieces.begin(), program_.pieces.end(), [&](const Piece& other) {
      return other.placement == piece().placement && other.effect == piece().effect && other.stage == piece().stage &&
             takes(*other.part, marker);
    });
    if (!other_part) complain("sampler-kind", false);
  }

  bool is_earlier(const Marker& marker) const { return marker.piece < static_cast<int>(piece_); }

  std::vector<Marker*> reached_markers() {
    std::vector<Marker*> own, of_shape, all;
    for (Marker& marker : program_.markers) {
      if (marker.plug != function_->name || marker.stage != piece().stage || !is_earlier(marker)) continue;
      all.push_back(&marker);
      if (marker.scope == piece().scope) own.push_back(&marker);
      if (marker.scope == Scope{}) of_shape.push_back(&marker);
    }
    if (piece().scope == Scope{}) return all;
    return own.empty() ? of_shape : own;
  }

  std::string_view why_unreached(const PlugRow* row) const {
    bool elsewhere = false;
    for (const Marker& marker : program_.markers) {
      if (marker.plug != function_->name) continue;
      if (marker.stage == piece().stage) return row != nullptr ? "effect-plug-absent" : "effect-unknown-plug";
      elsewhere = true;
    }
    if (row == nullptr) return elsewhere ? "effect-wrong-stage" : "effect-unknown-plug";
    return can_stand_in(*row) ? "effect-plug-absent" : "effect-wrong-stage";
  }

  /// Whether some shape calls the plug in a part of this type. A LIGHT part stands in the stage of the plugs of lighting.
  bool can_stand_in(const PlugRow& row) const {
    if (row.stage == 'L') return true;
    return (row.stage == 'V') == (piece().stage == Stage::vertex);
  }

  /// Whether this function or another definition in its part fits the marker.
  bool has_overload_for(const Marker& marker) const { return takes(*piece().part, marker); }

  bool takes(const PartModel& part, const Marker& marker) const {
    return std::any_of(part.functions.begin(), part.functions.end(), [&](const FunctionModel& other) {
      return other.is_plug && other.name == function_->name && fits_marker(marker, other);
    });
  }

  /// Texture plugs: the texture's sampler. Authors' plugs: as many arguments, and of overloads the one with their type.
  bool fits_marker(const Marker& marker, const FunctionModel& function) const {
    if (marker.plug == "texture_color") {
      const std::string& sampler = program_.shape.textures[static_cast<std::size_t>(marker.scope.number)].sampler;
      if (sampler.empty()) return function.parameters.size() == 2;
      return function.parameters.size() == 3 && function.parameters[1].type == sampler;
    }
    if (marker.statement == nullptr) return true;
    const bool as_many = function.parameters.size() == static_cast<std::size_t>(marker.statement->count);
    return as_many && function.parameters[0].type == marker.statement->type;
  }

  ProgramModel& program_;
  std::set<std::string>& said_;
  std::size_t piece_ = 0;
  const FunctionModel* function_ = nullptr;
};

}  // namespace

void fill_plugs(ProgramModel& program, std::set<std::string>& said) {
  PlugFiller filler(program, said);
  for (std::size_t i = 0; i < program.pieces.size(); ++i) {
    for (const FunctionModel& function : program.pieces[i].part->functions) {
      if (function.is_plug) filler.fill(i, function);
    }
  }
}

}  // namespace plugc::oracle

// Chapter 2: which plugs a shape has, in the order in which its program reaches them.
//
// The order is that of the table. A row for each light (or texture) is reached once for each; the rows that a light has are
// reached together, light by light. A shape that is not lit has none of the plugs of lights and lit materials, save
// material_emissive
// (lighting_apply is neither a light's nor a material's); Gouraud shading has no fragment_eye_space and no material_occlusion;
// texture plugs need textures, and texture_coord_shift belongs to the first. No template has geometry plugs,
// tangent_object_space or material_metallic_roughness. A function of an author offers the markers in its body.

#include <algorithm>
#include <array>

#include "oracle/program_model.h"

namespace plugc::oracle {
namespace {

bool is_one_of(const std::string& name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_per_light(const std::string& plug) {
  return is_one_of(plug, {"material_light_ambient", "material_light_diffuse", "material_light_specular", "light_scale"});
}

/// Whether a shape that is not lit has the plug too.
bool is_of_any_material(const std::string& plug) {
  return !is_per_light(plug) && !is_one_of(plug, {"material_ambient", "material_specular", "material_shininess",
                                                  "material_occlusion", "add_light_contribution", "add_light"});
}

bool is_offered(const PlugRow& row, const ShapeModel& shape) {
  if (row.stage == 'G' || is_one_of(row.name, {"tangent_object_space", "material_metallic_roughness"})) return false;
  if (!shape.lit && !is_of_any_material(row.name)) return false;
  if (shape.gouraud && is_one_of(row.name, {"fragment_eye_space", "material_occlusion"})) return false;
  return !is_one_of(row.name, {"texture_coord_shift", "texture_color"}) || !shape.textures.empty();
}

void offer(ProgramModel& program, const PlugRow& row, Scope scope) {
  const bool lights_vertices = row.stage == 'L' && program.shape.gouraud;
  const Stage stage = row.stage == 'V' || lights_vertices ? Stage::vertex : Stage::fragment;
  program.markers.push_back({row.name, stage, scope, -1, nullptr, {}});
}

void offer_light_plugs(ProgramModel& program) {
  for (std::size_t i = 0; i < numbered_lights(program.set).size(); ++i) {
    for (const PlugRow& row : plug_rows()) {
      if (is_per_light(row.name)) offer(program, row, {ScopeKind::light, static_cast<int>(i)});
    }
  }
}

void offer_row(ProgramModel& program, const PlugRow& row) {
  if (is_per_light(row.name)) {
    if (row.name == "light_scale") offer_light_plugs(program);
  } else if (row.name == "texture_color") {
    for (std::size_t i = 0; i < program.shape.textures.size(); ++i)
      offer(program, row, {ScopeKind::texture, static_cast<int>(i)});
  } else {
    offer(program, row, row.name == "texture_coord_shift" ? Scope{ScopeKind::texture, 0} : Scope{});
  }
}

}  // namespace

void offer_plugs(ProgramModel& program) {
  for (const PlugRow& row : plug_rows()) {
    if (is_offered(row, program.shape)) offer_row(program, row);
  }
  for (std::size_t i = 0; i < program.pieces.size(); ++i) {
    const Piece& piece = program.pieces[i];
    for (const FunctionModel& function : piece.part->functions) {
      for (const StatementModel& statement : function.statements) {
        if (statement.kind != StatementKind::marker) continue;
        program.markers.push_back({statement.name, piece.stage, piece.scope, static_cast<int>(i), &statement, {}});
      }
    }
  }
}

}  // namespace plugc::oracle

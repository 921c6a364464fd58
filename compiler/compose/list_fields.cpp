// A uniform of an author is fed by a field: of its effect, else of the ComposedShader.

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

#include "compose/bind_names.h"
#include "compose/castle_names.h"
#include "compose/check_fields.h"
#include "compose/uniform_defaults.h"

namespace plugc {
namespace {

int find_field(const SceneEffect& effect, std::string_view name) {
  const auto found =
      std::find_if(effect.fields.begin(), effect.fields.end(), [&](const ShaderField& field) { return field.name == name; });
  return found == effect.fields.end() ? -1 : static_cast<int>(found - effect.fields.begin());
}

class FieldLister {
 public:
  explicit FieldLister(Composition& composition) : c_(composition) {}
  void list(const PlacedUnit& unit);

 private:
  std::vector<double> initial_of(const PlacedUnit& unit, const GlobalOutline& uniform);
  FieldUniform field_uniform(const PlacedUnit& unit, const GlobalOutline& uniform);

  Composition& c_;
  std::unordered_set<std::string_view> listed_;
};

/// GLSL ES 3.00 has no initialisers of uniforms, so what cannot be computed here is lost there.
std::vector<double> FieldLister::initial_of(const PlacedUnit& unit, const GlobalOutline& uniform) {
  if (auto value = initial_value(*unit.code, uniform)) return std::move(*value);
  if (uniform.initializer_end > uniform.initializer_begin && c_.target == Target::essl300) {
    c_.report_fault(
        DiagnosticId::uniform_without_field, unit, uniform.name, uniform.name_begin,
        fmt::format(
            "plugc cannot compute what `{}` starts with, and `essl300` has no initialised uniforms: there it starts as 0; "
            "give it a field",
            uniform.name));
  }
  return {};
}

/// The effect's own field, else the ComposedShader's of that name.
FieldUniform FieldLister::field_uniform(const PlacedUnit& unit, const GlobalOutline& uniform) {
  const Owner& owner = c_.owners[unit.owner];
  FieldUniform found;
  found.name = c_.final_name(unit, unit.code->declared_name(uniform));
  found.type = uniform.type;
  found.owner = owner.index;
  found.of_shader = owner.kind == OwnerKind::shader;
  const SceneEffect& author = c_.author(owner);
  found.field = find_field(author, field_name(author, *unit.code, uniform));
  found.span = name_span(*unit.code, uniform.name, uniform.name_begin);
  found.initial = initial_of(unit, uniform);
  if (found.field >= 0 || c_.recipe.shader < 0) return found;
  const SceneShader& shader = c_.input.scene.shaders[static_cast<std::size_t>(c_.recipe.shader)];
  const int shader_field = find_field(shader, field_name(shader, *unit.code, uniform));
  if (shader_field >= 0) {
    found.owner = c_.recipe.shader;
    found.of_shader = true;
    found.field = shader_field;
  }
  return found;
}

void FieldLister::list(const PlacedUnit& unit) {
  for (const GlobalOutline& global : unit.code->outline.globals) {
    if (global.storage != Storage::uniform) continue;
    const std::string_view name = unit.code->declared_name(global);
    if (find_castle_name(name) || !number_own_light(name, 0).empty()) continue;
    if (listed_.insert(c_.final_name(unit, name)).second) c_.result.fields.push_back(field_uniform(unit, global));
  }
}

}  // namespace

void list_fields(Composition& composition) {
  FieldLister lister(composition);
  for (const PlacedUnit& unit : composition.units) {
    if (!unit.dropped && composition.by_author(unit)) lister.list(unit);
  }
}

}  // namespace plugc

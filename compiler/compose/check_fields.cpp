// Each uniform that an effect's parts declare is looked up among its fields, and the other way round.

#include "compose/check_fields.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "compose/castle_names.h"

namespace plugc {
namespace {

struct DeclaredUniform {
  std::string_view type;
  Span span;
  bool initialized = false;
};

using Uniforms = std::map<std::string_view, DeclaredUniform>;

void collect(const CodeUnit* unit, Uniforms& uniforms) {
  if (unit == nullptr) return;
  for (const GlobalOutline& global : unit->outline.globals) {
    if (global.storage != Storage::uniform || global.name.starts_with("castle_")) continue;
    const Span span = unit->span(global.name_begin, global.name_begin + static_cast<std::uint32_t>(global.name.size()));
    uniforms.try_emplace(unit->written_name(global.name),
                         DeclaredUniform{global.type, span, global.initializer_end > global.initializer_begin});
  }
}

const ShaderField* find_field(const SceneEffect& effect, std::string_view name) {
  const auto found =
      std::find_if(effect.fields.begin(), effect.fields.end(), [&](const ShaderField& field) { return field.name == name; });
  return found == effect.fields.end() ? nullptr : &*found;
}

std::string missing_field_message(std::string_view name, const DeclaredUniform& uniform, const SceneEffect& effect) {
  std::vector<std::string_view> names;
  for (const ShaderField& field : effect.fields) names.push_back(field.name);
  return fmt::format("no field `{}` of `{}` feeds this `uniform {}`{}", name, effect.label, uniform.type,
                     did_you_mean(name, names));
}

}  // namespace

std::string_view uniform_type(FieldType type) {
  if (is_node(type)) return "sampler2D";
  const auto slot = slot_type(type);
  if (!slot) return "";
  constexpr std::string_view kTypes[] = {"bool", "int", "float", "vec2", "vec3", "vec4", "mat3", "mat4", "vec4"};
  return kTypes[static_cast<std::size_t>(*slot)];
}

bool feeds(const ShaderField& field, std::string_view glsl_type) {
  if (!is_node(field.type)) return uniform_type(field.type) == glsl_type;
  // a texture that plugc does not draw yet has said so; any sampler may stand for it
  const bool drawn = std::any_of(field.textures.begin(), field.textures.end(), [](int texture) { return texture >= 0; });
  return drawn ? glsl_type == "sampler2D" : glsl_type.find("sampler") != std::string_view::npos;
}

void check_fields(const SceneEffect& effect, const EffectCode& code, Diagnostics& diagnostics) {
  Uniforms uniforms;
  const auto collect_part = [&](const EffectCode::Part& part) {
    for (const auto& unit : {part.in_vertex, part.in_fragment, part.in_geometry, part.behind_geometry})
      collect(unit.get(), uniforms);
  };
  for (const EffectCode::Part& part : code.parts) {
    collect_part(part);
    if (part.for_essl) collect_part(*part.for_essl);
  }
  for (const auto& [name, uniform] : uniforms) {
    const ShaderField* field = find_field(effect, name);
    if (field == nullptr) {
      if (effect.warn_missing_uniforms && !uniform.initialized) {
        diagnostics.report(DiagnosticId::uniform_without_field, uniform.span, missing_field_message(name, uniform, effect));
      }
    } else if (!feeds(*field, uniform.type)) {
      diagnostics.report(DiagnosticId::uniform_type, field->span,
                         fmt::format("field `{}` is `{}`, but its uniform is `{}`", name, to_text(field->type), uniform.type),
                         {{uniform.span, "the uniform is declared here"}});
    }
  }
  const bool was_read = !effect.parts.empty() && (!code.parts.empty() || !code.has_problems);
  for (const ShaderField& field : effect.fields) {
    if (uniforms.contains(field.name) || !was_read) continue;
    diagnostics.report(DiagnosticId::field_without_uniform, field.span,
                       fmt::format("no part of `{}` declares a uniform `{}`", effect.label, field.name));
  }
}

}  // namespace plugc

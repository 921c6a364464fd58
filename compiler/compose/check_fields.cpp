// Each uniform that an effect's parts declare is looked up among its fields, and the other way round.

#include "compose/check_fields.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/sampler_type.h"

namespace plugc {
namespace {

struct DeclaredUniform {
  std::string_view type;
  Span span;
  bool initialized = false;
};

using Uniforms = std::map<std::string_view, DeclaredUniform>;

void collect(const SceneEffect& effect, const CodeUnit* unit, Uniforms& uniforms) {
  if (unit == nullptr) return;
  for (const GlobalOutline& global : unit->outline.globals) {
    if (global.storage != Storage::uniform || global.name.starts_with("castle_")) continue;
    const Span span = unit->span(global.name_begin, global.name_begin + static_cast<std::uint32_t>(global.name.size()));
    uniforms.try_emplace(field_name(effect, *unit, global),
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

/// The first texture of the field that another sampler reads; -1: all fit.
int misfit_texture(const Scene& scene, const ShaderField& field, std::string_view sampler) {
  const auto found = std::ranges::find_if(field.textures, [&](int texture) {
    return texture >= 0 && sampler_type(scene.textures[static_cast<std::size_t>(texture)].kind) != sampler;
  });
  return found == field.textures.end() ? -1 : *found;
}

std::string texture_reader(TextureKind kind) {
  const std::string_view sampler = sampler_type(kind);
  return sampler.empty() ? "is code and has no sampler" : fmt::format("is read by a `{}`", sampler);
}

/// A field of another type than its uniform, or with a texture of another kind.
void report_misfit(const Scene& scene, const ShaderField& field, const DeclaredUniform& uniform, Diagnostics& diagnostics) {
  const std::vector<RelatedPlace> related = {{uniform.span, "the uniform is declared here"}};
  if (is_node(field.type) && is_sampler(uniform.type)) {
    const int texture = misfit_texture(scene, field, uniform.type);
    const TextureKind kind = scene.textures[static_cast<std::size_t>(texture)].kind;
    diagnostics.report(
        DiagnosticId::sampler_kind, field.span,
        fmt::format("the texture of field `{}` {}, but its uniform is a `{}`", field.name, texture_reader(kind), uniform.type),
        related);
    return;
  }
  diagnostics.report(DiagnosticId::uniform_type, field.span,
                     fmt::format("field `{}` is `{}`, but its uniform is `{}`", field.name, to_text(field.type), uniform.type),
                     related);
}

/// A texture that stands on no shape has no place where its effects would be called.
void report_unused_effects(const Scene& scene, const ShaderField& field, Diagnostics& diagnostics) {
  const auto is_on = [](const SceneShape& shape, int texture) {
    return std::ranges::find(shape.textures, texture, &TextureUse::texture) != shape.textures.end();
  };
  for (const int texture : field.textures) {
    if (texture < 0 || scene.textures[static_cast<std::size_t>(texture)].effects.empty()) continue;
    if (std::ranges::any_of(scene.shapes, [&](const SceneShape& shape) { return is_on(shape, texture); })) continue;
    diagnostics.report(
        DiagnosticId::texture_effects_unused, field.span,
        fmt::format("the effects of the texture in field `{}` are not called: it only feeds a uniform; put their code "
                    "where the uniform is read",
                    field.name));
  }
}

}  // namespace

std::string_view uniform_type(FieldType type) {
  const auto slot = slot_type(type);
  if (!slot) return "";
  constexpr std::string_view kTypes[] = {"bool", "int", "float", "vec2", "vec3", "vec4", "mat3", "mat4", "vec4"};
  return kTypes[static_cast<std::size_t>(*slot)];
}

bool feeds(const Scene& scene, const ShaderField& field, std::string_view glsl_type) {
  if (!is_node(field.type)) return uniform_type(field.type) == glsl_type;
  return is_sampler(glsl_type) && misfit_texture(scene, field, glsl_type) < 0;
}

std::string_view field_name(const SceneEffect& effect, const CodeUnit& code, const GlobalOutline& uniform) {
  const std::string_view declared = code.written_name(code.declared_name(uniform));
  const std::string_view written = code.written_name(uniform.name);
  return find_field(effect, declared) == nullptr && find_field(effect, written) != nullptr ? written : declared;
}

void check_fields(const Scene& scene, const SceneEffect& effect, const EffectCode& code, Diagnostics& diagnostics) {
  Uniforms uniforms;
  const auto collect_part = [&](const EffectCode::Part& part) {
    for (const auto& unit : {part.in_vertex, part.in_fragment, part.in_geometry, part.behind_geometry})
      collect(effect, unit.get(), uniforms);
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
    } else if (!feeds(scene, *field, uniform.type)) {
      report_misfit(scene, *field, uniform, diagnostics);
    }
  }
  const bool was_read = !effect.parts.empty() && (!code.parts.empty() || !code.has_problems);
  for (const ShaderField& field : effect.fields) {
    report_unused_effects(scene, field, diagnostics);
    if (uniforms.contains(field.name) || !was_read) continue;
    diagnostics.report(DiagnosticId::field_without_uniform, field.span,
                       fmt::format("no part of `{}` declares a uniform `{}`", effect.label, field.name));
  }
}

}  // namespace plugc

// Composing is passes over one list of placed units: place them, resolve their plugs, give their names, write them down. See
// placed_unit.h for what the passes share.

#include "compose/compose.h"

#include <algorithm>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/geometry_stage.h"
#include "compose/output_locations.h"
#include "compose/placed_unit.h"
#include "compose/precision.h"
#include "compose/sampler_type.h"

namespace plugc {

void Composition::note_need(const PlacedUnit& unit, std::size_t provider, NeedKind kind, std::string_view name) {
  const Owner& owner = owners[unit.owner];
  const Owner& other = owners[provider];
  const bool is_other = owner.index != other.index || owner.kind != other.kind;
  if (owner.kind != OwnerKind::effect || other.kind == OwnerKind::renderer || !is_other) return;
  result.needs.insert({owner.index, other.index, other.kind == OwnerKind::shader, kind, std::string(name)});
}

void Composition::mark_faulty(const Owner& owner) {
  if (owner.kind == OwnerKind::shader) result.faulty_shader = true;
  if (owner.kind != OwnerKind::effect) return;
  auto& faulty = result.faulty_effects;
  if (std::find(faulty.begin(), faulty.end(), owner.index) == faulty.end()) faulty.push_back(owner.index);
}

bool Composition::is_faulty(const PlacedUnit& unit) const {
  const Owner& owner = owners[unit.owner];
  const auto& faulty = result.faulty_effects;
  return owner.kind == OwnerKind::effect && std::find(faulty.begin(), faulty.end(), owner.index) != faulty.end();
}

void Composition::report_fault(DiagnosticId id, const PlacedUnit& unit, std::string_view name, std::uint32_t begin,
                               std::string message, std::vector<RelatedPlace> related) {
  diagnostics.report(id, name_span(*unit.code, name, begin), std::move(message), std::move(related));
  mark_faulty(unit);
}

std::string_view Composition::final_name(const PlacedUnit& unit, std::string_view name) const {
  const Owner& owner = owners[unit.owner];
  const Owner::Renames& borrowed = owner.borrowed[static_cast<std::size_t>(unit.stage)];
  if (const auto found = borrowed.find(name); found != borrowed.end()) {
    name = found->second;
  } else if (const auto renamed = owner.renames.find(name); renamed != owner.renames.end()) {
    name = renamed->second;
  }
  if (passed.empty() || unit.stage != ShaderStage::fragment) return name;
  const auto behind = passed.find(name);
  return behind == passed.end() ? name : behind->second;
}

std::string_view Composition::name_of(std::size_t owner, std::string_view name) const {
  const Owner::Renames& renames = owners[owner].renames;
  const auto renamed = renames.find(name);
  return renamed == renames.end() ? name : renamed->second;
}

std::string_view Composition::type_of(const CastleName& name) const {
  const bool of_texture = name.source == CastleSource::texture && name.number >= 0 &&
                          static_cast<std::size_t>(name.number) < recipe.textures.size();
  const bool of_light = name.source == CastleSource::shadow_map && name.number >= 0 &&
                        static_cast<std::size_t>(name.number) < recipe.lights.size();
  if (of_light && recipe.lights[static_cast<std::size_t>(name.number)].kind == LightKind::point) return "samplerCubeShadow";
  const std::string_view sampler = of_texture ? sampler_type(recipe.textures[static_cast<std::size_t>(name.number)].kind) : "";
  return sampler.empty() ? name.type : sampler;
}

PlacedUnit make_placed_unit(std::shared_ptr<const CodeUnit> code, ShaderStage stage, std::size_t owner, PlugScope scope) {
  PlacedUnit unit;
  unit.calls.resize(code->outline.markers.size());
  unit.function_names.resize(code->outline.functions.size());
  unit.code = std::move(code);
  unit.stage = stage;
  unit.owner = owner;
  unit.scope = scope;
  return unit;
}

Span name_span(const CodeUnit& code, std::string_view name, std::uint32_t begin) {
  return code.span(begin, begin + static_cast<std::uint32_t>(name.size()));
}

namespace {

/// Code that can never be valid, which has been said of its text.
bool mark_broken(Composition& c) {
  bool any = false;
  for (const Owner& owner : c.owners) {
    if (owner.kind == OwnerKind::renderer) continue;
    const bool of_shader = owner.kind == OwnerKind::shader;
    const auto index = static_cast<std::size_t>(owner.index);
    if (!(of_shader ? c.input.shaders : c.input.effects)[index].broken) continue;
    any = true;
    c.mark_faulty(owner);
    const SceneEffect& author = c.author(owner);
    of_shader ? c.diagnostics.report(DiagnosticId::shader_replaced, author.span,
                                     fmt::format("`{}` is not valid; {}", author.label, without_shader(c.recipe)))
              : c.diagnostics.report(DiagnosticId::effect_left_out, author.span,
                                     fmt::format("effect `{}` is left out: the program is not valid with it", author.label));
  }
  return any;
}

void compose_stages(Composition& composition) {
  if (!place_geometry_stage(composition)) return;
  // from here the list of units is complete, and its order is the order of calls
  resolve_plugs(composition);
  // from here every plug function has its calls and its name
  name_owners(composition);
  note_passed_varyings(composition);
  note_precisions(composition);
  note_output_locations(composition);
  // from here no two owners' names meet
  bind_names(composition);
  // from here what an owner only declares has its definition's name, and uniforms know their fields
  for (const ShaderStage stage : {ShaderStage::vertex, ShaderStage::geometry, ShaderStage::fragment}) {
    if (stage == ShaderStage::geometry && !composition.has_geometry) continue;
    composition.result.stages.push_back({stage, stage_text(composition, stage)});
  }
}

/// Who needs the broken code. What else this finds wrong may be due to that code, and is left to the next composition.
std::set<EffectNeed> needs_beside_broken(const Recipe& recipe, const ComposeInput& input, Target target,
                                         const Diagnostics& diagnostics) {
  ComposedProgram program;
  Diagnostics unheard(diagnostics.sources());
  Composition composition(recipe, input, target, unheard, program);
  place_units(composition);
  compose_stages(composition);
  return std::move(program.needs);
}

}  // namespace

ComposedProgram compose(const Recipe& recipe, const ComposeInput& input, Target target, Diagnostics& diagnostics) {
  ComposedProgram program;
  Composition composition(recipe, input, target, diagnostics, program);
  place_units(composition);
  if (mark_broken(composition)) {
    program.needs = needs_beside_broken(recipe, input, target, diagnostics);
  } else {
    compose_stages(composition);
  }
  return program;
}

std::string_view without_shader(const Recipe& recipe) {
  return recipe.screen_pass == ScreenPass::none ? "the base shader is used instead" : "the picture stays as it is without it";
}

namespace {

void erase_effects(Recipe& recipe, auto predicate) {
  std::erase_if(recipe.effects, predicate);
  std::erase_if(recipe.guarded, predicate);
  for (LightRecipe& light : recipe.lights) std::erase_if(light.effects, predicate);
  for (TextureRecipe& texture : recipe.textures) std::erase_if(texture.effects, predicate);
}

}  // namespace

Recipe without_effect(Recipe recipe, int effect) {
  erase_effects(recipe, [&](int each) { return each == effect; });
  return recipe;
}

Recipe with_effects(Recipe recipe, const std::set<int>& effects) {
  erase_effects(recipe, [&](int each) { return !effects.contains(each); });
  return recipe;
}

std::vector<int> all_effects(const Recipe& recipe) {
  std::vector<int> effects;
  std::set<int> known;
  const auto add = [&](const std::vector<int>& list) {
    for (const int effect : list) {
      if (known.insert(effect).second) effects.push_back(effect);
    }
  };
  for (const LightRecipe& light : recipe.lights) add(light.effects);
  for (const TextureRecipe& texture : recipe.textures) add(texture.effects);
  add(recipe.effects);
  return effects;
}

}  // namespace plugc

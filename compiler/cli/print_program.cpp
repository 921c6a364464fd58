// Both forms tell the same facts, taken from the package once.

#include "cli/print_program.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace plugc {

std::string origin_text(const Package& package, const PackedLineOrigin& origin) {
  if (origin.line() == 0) return "";
  const std::string_view name = package.sources()->Get(origin.source())->string_view();
  return fmt::format("{}:{}", name.substr(name.find_last_of('/') + 1), origin.line());
}

namespace {

using Json = nlohmann::ordered_json;
using Names = flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>;

/// A uniform with what feeds it.
struct UniformFact {
  std::string type, name, targets, source;
};

/// The schema's names end in `_` where they would be words of C++.
std::string_view word(std::string_view enumerator) {
  return enumerator.ends_with('_') ? enumerator.substr(0, enumerator.size() - 1) : enumerator;
}

/// Where a program is used.
struct Place {
  const PackedScene* scene = nullptr;
  const flatbuffers::Vector<const PackedBinding*>* bindings = nullptr;
};

/// The first shape that has the program in some state, or the first screen effect.
Place find_user(const Package& package, std::size_t program) {
  for (const PackedScene* scene : *package.scenes()) {
    for (const PackedShape* shape : *scene->shapes()) {
      for (std::uint32_t variant = 0; variant <= shape->variants()->size(); ++variant) {
        const ShapePrograms use = shape_programs(*shape, static_cast<std::uint8_t>(variant));
        if (use.program == program) return {scene, use.bindings};
        if (use.depth_program == static_cast<std::int64_t>(program)) return {scene, use.depth_bindings};
        if (use.point_depth_program == static_cast<std::int64_t>(program)) return {scene, use.point_depth_bindings};
      }
    }
    if (scene->screen_effects() == nullptr) continue;
    for (const PackedScreenEffect* effect : *scene->screen_effects())
      if (effect->program() == program) return {scene, effect->bindings()};
  }
  return {};
}

std::string slot_name(const PackedScene& scene, std::uint32_t slot) {
  for (const PackedSlotName* name : *scene.slot_names()) {
    if (name->slot() == slot) return fmt::format("slot {} `{}`", slot, name->name()->string_view());
  }
  return fmt::format("slot {}", slot);
}

bool names_slots(PackedSource source) {
  return source == PackedSource::slot || source == PackedSource::slot_scaled || source == PackedSource::slot_product ||
         source == PackedSource::color_and_transparency || source == PackedSource::shadow_intensity;
}

/// `light_position 0`, `slot 28 `Glaze.band_color``, `slot_product slot 22, slot 23`.
std::string source_text(const Place& place, const PackedBinding& binding) {
  const std::string source = EnumNamePackedSource(binding.source());
  if (!names_slots(binding.source())) return fmt::format("{} {}", source, binding.a());
  const std::string first = binding.a() == kNoSlot ? "no slot" : slot_name(*place.scene, binding.a());
  if (binding.source() == PackedSource::slot) return first;
  const bool has_two =
      binding.source() == PackedSource::slot_product || binding.source() == PackedSource::color_and_transparency;
  const bool takes_two = has_two && binding.b() != kNoSlot;
  const std::string scale = binding.source() == PackedSource::slot_scaled ? fmt::format(" * {}", binding.scale()) : "";
  return fmt::format("{} {}{}{}", source, first, takes_two ? ", " + slot_name(*place.scene, binding.b()) : "", scale);
}

std::string source_of(const Place& place, std::size_t uniform) {
  if (place.bindings == nullptr) return "no shape uses the program";
  for (const PackedBinding* binding : *place.bindings) {
    if (binding->uniform() == uniform) return source_text(place, *binding);
  }
  return "nothing (keeps the value of its text, or 0)";
}

/// The targets that read a uniform, when those are not all of the program.
std::string some_targets(const PackedProgram& program, const PackedUniform& uniform) {
  std::string names;
  bool all = true;
  for (const PackedTargetProgram* target : *program.targets()) {
    const bool reads = (uniform.targets() >> static_cast<unsigned>(target->target()) & 1U) != 0;
    if (reads) names += fmt::format("{}{}", names.empty() ? "" : " ", EnumNamePackedTarget(target->target()));
    all = all && reads;
  }
  return all ? "" : names;
}

std::vector<UniformFact> uniform_facts(const Package& package, const PackedProgram& program, std::size_t index) {
  const Place place = find_user(package, index);
  std::vector<UniformFact> facts;
  for (const PackedUniform* uniform : *program.uniforms()) {
    UniformFact fact;
    fact.type = word(EnumNamePackedUniformType(uniform->type()));
    fact.name = uniform->name()->str();
    if (uniform->count() != 1) fact.name += fmt::format("[{}]", uniform->count());
    fact.targets = some_targets(program, *uniform);
    fact.source = source_of(place, facts.size());
    facts.push_back(std::move(fact));
  }
  return facts;
}

std::string origin_of_line(const Package& package, const PackedStage& stage, std::size_t line) {
  const bool known = line < stage.origins()->size();
  return known ? origin_text(package, *stage.origins()->Get(static_cast<flatbuffers::uoffset_t>(line))) : "";
}

/// Calls `function(origin, line)` for every line of a stage.
template <typename Function>
void each_line(const Package& package, const PackedStage& stage, Function function) {
  const std::string_view text = stage.text()->string_view();
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    function(origin_of_line(package, stage, line), text.substr(begin, end - begin));
    begin = end + 1;
  }
}

const PackedProgram& program_at(const Package& package, std::size_t index) {
  return *package.programs()->Get(static_cast<flatbuffers::uoffset_t>(index));
}

// ---- as text ----

std::string names_line(std::string_view title, const Names& names) {
  if (names.size() == 0) return "";
  std::string line = fmt::format("{}:", title);
  for (const auto* name : names) line += fmt::format(" {}", name->string_view());
  return line + "\n";
}

constexpr std::pair<const char*, std::uint32_t ProgramCost::*> kCosts[] = {{"vertex", &ProgramCost::vertex_instructions},
                                                                           {"geometry", &ProgramCost::geometry_instructions},
                                                                           {"fragment", &ProgramCost::fragment_instructions},
                                                                           {"texture reads", &ProgramCost::texture_reads},
                                                                           {"varyings", &ProgramCost::varyings}};

std::int64_t difference(const ProgramCost& whole, const ProgramCost& without, std::uint32_t ProgramCost::*member) {
  return std::int64_t{whole.*member} - std::int64_t{without.*member};
}

std::string effect_row(const ProgramCost& whole, const EffectCost& effect) {
  std::string row = fmt::format("  {:<24}", "`" + effect.label + "`");
  if (!effect.without) return row + "  others need it: it cannot be left out alone\n";
  for (const auto& [title, member] : kCosts)
    row += fmt::format("{:>15}", fmt::format("{:+}", difference(whole, *effect.without, member)));
  return row + "\n";
}

std::string costs_text(const ProgramCosts& costs) {
  if (!costs.whole) return "cost: unknown, as the program cannot be optimised\n";
  std::string text = fmt::format("{:<26}", "cost, optimised");
  for (const auto& [title, member] : kCosts) text += fmt::format("{:>15}", title);
  text += fmt::format("\n  {:<24}", "whole program");
  for (const auto& [title, member] : kCosts) text += fmt::format("{:>15}", (*costs.whole).*member);
  text += "\n";
  for (const EffectCost& effect : costs.effects) text += effect_row(*costs.whole, effect);
  return text;
}

std::string uniform_line(const UniformFact& uniform) {
  const std::string targets = uniform.targets.empty() ? "" : fmt::format(" in {}", uniform.targets);
  return fmt::format("uniform {} {}{} <- {}\n", uniform.type, uniform.name, targets, uniform.source);
}

// ---- as JSON ----

Json names_json(const Names& names) {
  Json list = Json::array();
  for (const auto* name : names) list.push_back(name->str());
  return list;
}

Json cost_json(const ProgramCost& cost) {
  return {{"vertex_instructions", cost.vertex_instructions},
          {"geometry_instructions", cost.geometry_instructions},
          {"fragment_instructions", cost.fragment_instructions},
          {"texture_reads", cost.texture_reads},
          {"varyings", cost.varyings}};
}

Json costs_json(const ProgramCosts& costs) {
  Json json = {{"whole", costs.whole ? cost_json(*costs.whole) : Json()}, {"effects", Json::array()}};
  for (const EffectCost& effect : costs.effects)
    json["effects"].push_back({{"effect", effect.label}, {"without", effect.without ? cost_json(*effect.without) : Json()}});
  return json;
}

/// The names of the shapes that the program draws, each once.
Json shapes_json(const Package& package, std::size_t program) {
  std::set<std::string> names;
  for (const PackedScene* scene : *package.scenes()) {
    for (const PackedShape* shape : *scene->shapes()) {
      if (shape->program() == program) names.insert(shape->name()->str());
    }
  }
  return names;
}

Json stage_json(const Package& package, const PackedStage& stage) {
  Json lines = Json::array();
  each_line(package, stage, [&](const std::string& origin, std::string_view text) {
    lines.push_back({{"origin", origin}, {"text", text}});
  });
  return {{"stage", EnumNamePackedStageKind(stage.kind())}, {"lines", std::move(lines)}};
}

}  // namespace

std::string program_text(const Package& package, std::size_t index, const ProgramCosts* costs) {
  const PackedProgram& program = program_at(package, index);
  std::string text = fmt::format("program {}: {}\n", index, program.recipe()->string_view());
  text += names_line("plugs filled", *program.plugs_filled()) + names_line("plugs empty", *program.plugs_empty());
  for (const UniformFact& uniform : uniform_facts(package, program, index)) text += uniform_line(uniform);
  if (costs != nullptr) text += costs_text(*costs);
  for (const PackedTargetProgram* target : *program.targets()) {
    text += fmt::format("==== {} ====\n", EnumNamePackedTarget(target->target()));
    for (const PackedStage* stage : *target->stages()) {
      text += fmt::format("---- {} stage ----\n", EnumNamePackedStageKind(stage->kind()));
      each_line(package, *stage,
                [&](const std::string& origin, std::string_view line) { text += fmt::format("{:>26} | {}\n", origin, line); });
    }
  }
  return text;
}

namespace {

Json program_object(const Package& package, std::size_t index, const ProgramCosts* costs) {
  const PackedProgram& program = program_at(package, index);
  Json json = {{"program", index},
               {"recipe", program.recipe()->str()},
               {"shapes", shapes_json(package, index)},
               {"plugs_filled", names_json(*program.plugs_filled())},
               {"plugs_empty", names_json(*program.plugs_empty())},
               {"uniforms", Json::array()},
               {"targets", Json::array()}};
  for (const UniformFact& uniform : uniform_facts(package, program, index))
    json["uniforms"].push_back(
        {{"type", uniform.type}, {"name", uniform.name}, {"targets", uniform.targets}, {"source", uniform.source}});
  if (costs != nullptr) json["cost"] = costs_json(*costs);
  for (const PackedTargetProgram* target : *program.targets()) {
    Json stages = Json::array();
    for (const PackedStage* stage : *target->stages()) stages.push_back(stage_json(package, *stage));
    json["targets"].push_back({{"target", EnumNamePackedTarget(target->target())}, {"stages", std::move(stages)}});
  }
  return json;
}

std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string program_json(const Package& package, std::size_t index, const ProgramCosts* costs) {
  return dumped(program_object(package, index, costs));
}

std::string programs_json(const Package& package) {
  Json list = Json::array();
  for (std::size_t i = 0; i < package.programs()->size(); ++i) list.push_back(program_object(package, i, nullptr));
  return dumped(list);
}

}  // namespace plugc

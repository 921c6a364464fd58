// Everything is drawn from few names, so that effects meet: two have a uniform `level`, one calls the `noise` that another
// defines. Within one effect names keep their kind, type and tag (else it would be no GLSL), except for planted mistakes;
// between effects a third of them mix the kinds up, so that one's helper is another's varying.

#include <algorithm>
#include <array>

#include "oracle/effect_set.h"
#include "oracle/plug_rows.h"
#include "oracle/random.h"

namespace plugc::oracle {
namespace {

enum class Place { light, texture, shape };

/// The words that one effect uses, by what it uses them for.
struct Names {
  std::array<std::string, 9> words = {"level", "level_2", "height", "depth", "noise", "lighting", "base", "SHARE", "Pair"};
  const std::string& of(GlobalKind kind, std::size_t number) const {
    constexpr std::array<std::size_t, 5> kFirst = {0, 2, 6, 7, 8};  // by GlobalKind
    return words[kFirst[static_cast<std::size_t>(kind)] + (static_cast<int>(kind) < 2 ? number : 0)];
  }
  const std::string& helper(std::size_t number) const { return words[4 + number]; }
};

class Generator {
 public:
  Generator(std::uint64_t seed, bool mistakes) : random_(seed), mistakes_(mistakes) {}

  EffectSet run() {
    set_.headlight = random_.percent(70);
    for (int i = random_.between(0, 2); i > 0; --i) add_light();
    for (int i = random_.between(1, 3); i > 0; --i) add_group();
    const int shapes = random_.percent(60) ? 1 : random_.between(2, 4);
    for (int i = 0; i < shapes; ++i) add_shape();
    std::stable_sort(set_.shapes.begin(), set_.shapes.end(),
                     [](const ShapeModel& a, const ShapeModel& b) { return a.group < b.group; });
    return std::move(set_);
  }

 private:
  bool slip(int chance) { return mistakes_ && random_.percent(chance); }

  void add_light() {
    LightModel light{random_.one_of({"DirectionalLight", "PointLight", "SpotLight"}), random_.percent(90), {}};
    if (light.on) light.effects = effects_at(Place::light, random_.between(0, 1));
    set_.lights.push_back(light);
  }

  void add_group() {
    const int count = static_cast<int>(set_.groups.size());
    set_.groups.push_back({count == 0 ? -1 : random_.between(0, count - 1), effects_at(Place::shape, random_.between(0, 1))});
  }

  void add_shape() {
    ShapeModel shape;
    shape.lit = random_.percent(75);
    shape.gouraud = random_.percent(30);
    for (int i = random_.percent(50) ? 0 : random_.between(1, 2); i > 0; --i) {
      const std::string sampler = random_.one_of({"sampler2D", "sampler2D", "sampler2D", "sampler3D", "samplerCube", ""});
      shape.textures.push_back({sampler, effects_at(Place::texture, random_.between(0, 1))});
    }
    shape.effects = effects_at(Place::shape, random_.between(0, 3));
    shape.group = random_.between(0, static_cast<int>(set_.groups.size()) - 1);
    set_.shapes.push_back(shape);
  }

  std::vector<int> effects_at(Place place, int count) {
    std::vector<int> effects;
    for (; count > 0; --count) effects.push_back(random_.percent(15) ? used_effect(place) : new_effect(place));
    return effects;
  }

  /// One that is there already, if there is. Names of "this light" make sense on lights alone.
  int used_effect(Place place) {
    if (set_.effects.empty()) return new_effect(place);
    const std::size_t index = random_.below(set_.effects.size());
    return places_[index] == Place::light && place != Place::light ? new_effect(place) : static_cast<int>(index);
  }

  int new_effect(Place place) {
    EffectModel effect;
    effect.enabled = random_.percent(95);
    if (slip(2)) effect.language = "CG";
    effect.ignore_missing = random_.percent(20);
    names_ = Names();
    for (auto& overloads : sought_) {
      for (bool& sought : overloads) sought = random_.percent(20);
    }
    if (random_.percent(30)) {
      for (std::size_t i = names_.words.size() - 1; i > 0; --i) std::swap(names_.words[i], names_.words[random_.below(i + 1)]);
    }
    for (int i = random_.between(1, 3); i > 0; --i) add_part(effect, place);
    if (random_.percent(5)) effect.parts.push_back(effect.parts.front());
    if (random_.percent(30)) std::reverse(effect.parts.begin(), effect.parts.end());
    add_fields(effect);
    set_.effects.push_back(effect);
    places_.push_back(place);
    return static_cast<int>(set_.effects.size()) - 1;
  }

  void add_part(EffectModel& effect, Place place) {
    if (random_.percent(8) && !set_.parts.empty()) {
      const int used = static_cast<int>(random_.below(set_.parts.size()));
      if (suits(effect, set_.parts[static_cast<std::size_t>(used)]) && place == Place::shape)
        return effect.parts.push_back(used);
    }
    PartModel part;
    const std::size_t drawn = random_.below(10);
    part.type = drawn < 3 ? PartType::vertex : drawn < (place == Place::light ? 4U : 8U) ? PartType::fragment : PartType::light;
    add_globals(effect, part);
    add_helpers(effect, part);
    for (int i = random_.between(0, 3); i > 0; --i) add_plug_function(part, place);
    set_.parts.push_back(std::move(part));
    effect.parts.push_back(static_cast<int>(set_.parts.size()) - 1);
  }

  // ---- globals and fields

  const GlobalModel* find_global(const EffectModel& effect, const std::string& name) const {
    for (const int part : effect.parts) {
      for (const GlobalModel& global : set_.parts[static_cast<std::size_t>(part)].globals) {
        if (global.name == name) return &global;
      }
    }
    return nullptr;
  }

  bool defines(const EffectModel& effect, const FunctionModel& helper) const {
    return std::any_of(effect.parts.begin(), effect.parts.end(), [&](int index) {
      const auto& functions = set_.parts[static_cast<std::size_t>(index)].functions;
      return std::any_of(functions.begin(), functions.end(), [&](const FunctionModel& function) {
        return function.name == helper.name && function.parameters == helper.parameters && function.defined;
      });
    });
  }

  /// Whether a part of another effect says nothing that contradicts this effect's.
  bool suits(const EffectModel& effect, const PartModel& part) const {
    const auto uses_own_light = [](const FunctionModel& function) {
      return std::any_of(function.statements.begin(), function.statements.end(),
                         [](const StatementModel& statement) { return statement.name == "castle_LightSourceColor"; });
    };
    const std::vector<std::string> helpers = {names_.helper(0), names_.helper(1)};
    for (const FunctionModel& function : part.functions) {
      if (uses_own_light(function)) return false;
      const bool clashes = !function.defined || defines(effect, function) || !is_one_of(function.name, helpers);
      if (!function.is_plug && (clashes || sought(function.name == helpers[1] ? 1 : 0, function))) return false;
    }
    return std::all_of(part.globals.begin(), part.globals.end(), [&](const GlobalModel& global) {
      const GlobalModel* known = find_global(effect, global.name);
      if (global.kind == GlobalKind::macro || global.name != names_of(global)) return false;
      return known == nullptr || (known->kind == global.kind && known->type == global.type && known->tag == global.tag);
    });
  }

  static bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  /// The name if this effect uses it for the same kind, else "".
  std::string names_of(const GlobalModel& global) const {
    for (const std::size_t number : {0U, 1U}) {
      if (names_.of(global.kind, number) == global.name) return global.name;
    }
    return "";
  }

  void add_globals(const EffectModel& effect, PartModel& part) {
    for (const std::size_t number : {0U, 1U}) {
      if (random_.percent(35)) add_global(effect, part, GlobalKind::uniform, number);
      if (random_.percent(25) && part.type != PartType::light) add_global(effect, part, GlobalKind::varying, number);
    }
    for (const GlobalKind kind : {GlobalKind::constant, GlobalKind::macro, GlobalKind::structure}) {
      if (random_.percent(20)) add_global(effect, part, kind, 0);
    }
  }

  void add_global(const EffectModel& effect, PartModel& part, GlobalKind kind, std::size_t number) {
    GlobalModel global{kind, "float", names_.of(kind, number), next_tag_++};
    if (kind == GlobalKind::uniform) {
      global.type = random_.one_of({"float", "float", "vec3", "vec4", "int"});
      global.initialised = global.type == "float" && random_.percent(15);
    }
    if (kind == GlobalKind::structure) global.tag = random_.between(1, 2);
    const GlobalModel* known = find_global(effect, global.name);
    if (known != nullptr && kind != GlobalKind::macro) global = *known;
    const bool is_variable = kind == GlobalKind::uniform || kind == GlobalKind::varying;
    if (known != nullptr && is_variable && slip(5)) {
      global.type = known->type == "float" ? "vec3" : "float";
      global.initialised = false;
    }
    part.globals.push_back(global);
  }

  void add_fields(EffectModel& effect) {
    for (const int part : effect.parts) {
      for (const GlobalModel& global : set_.parts[static_cast<std::size_t>(part)].globals) {
        const bool known = std::any_of(effect.fields.begin(), effect.fields.end(),
                                       [&](const FieldModel& field) { return field.name == global.name; });
        if (global.kind == GlobalKind::uniform && !known && random_.percent(75)) {
          effect.fields.push_back({slip(6) ? "SFVec2f" : field_type(global.type), global.name});
        }
      }
    }
    if (slip(6)) effect.fields.push_back({"SFFloat", "unused"});
  }

  std::string field_type(const std::string& type) {
    if (type == "float") return "SFFloat";
    if (type == "int") return "SFInt32";
    return type == "vec4" ? "SFRotation" : random_.one_of({"SFVec3f", "SFColor"});
  }

  // ---- functions

  bool sought(std::size_t number, const FunctionModel& helper) const {
    return sought_[number][helper.parameters[0].type == "vec3" ? 1 : 0];
  }

  void add_helpers(const EffectModel& effect, PartModel& part) {
    for (const std::size_t number : {0U, 1U}) {
      if (!random_.percent(25)) continue;
      FunctionModel helper;
      helper.tag = next_tag_++;
      helper.name = names_.helper(number);
      helper.returned = "float";
      helper.parameters = {{"", random_.percent(75) ? "float" : "vec3"}};
      helper.defined = !sought(number, helper) && !defines(effect, helper);
      if (helper.defined) add_statements(part, helper, false);
      part.functions.push_back(helper);
    }
  }

  void add_plug_function(PartModel& part, Place place) {
    FunctionModel function;
    function.is_plug = true;
    function.tag = next_tag_++;
    if (random_.percent(20)) {
      function.name = random_.one_of({"dim", "warp"});
      function.parameters = {{random_.one_of({"inout", "in", "const in", ""}), function.name == "dim" ? "float" : "vec3"}};
      if (slip(5)) function.parameters.push_back({"in", function.parameters[0].type});
    } else {
      const PlugRow& row = draw_row(part, place);
      function.name = row.name;
      const bool without_sampler = row.name == "texture_color" && random_.percent(15);
      for (const ParameterModel& parameter : row.parameters) {
        if (!without_sampler || parameter.type != "samplerT") function.parameters.push_back(weakened(parameter));
      }
      spoil(function);
    }
    add_statements(part, function, place == Place::light);
    part.functions.push_back(function);
    if (!random_.percent(15)) return;
    function.tag = next_tag_++;  // a second definition, sometimes as an overload
    if (random_.percent(50) && is_custom(function.name)) {
      for (ParameterModel& parameter : function.parameters) parameter.type = function.name == "dim" ? "vec3" : "float";
    }
    const bool has_sampler = function.name == "texture_color" && function.parameters.size() == 3;
    if (random_.percent(50) && has_sampler) function.parameters[1].type = random_.one_of({"sampler3D", "samplerCube"});
    part.functions.push_back(function);
  }

  static bool is_custom(const std::string& name) { return name == "dim" || name == "warp"; }

  /// A row of the table for the part's stage; rarely one of another. Geometry and what no template calls yet stay out, and
  /// add_light, whose parameter is a struct of the templates.
  const PlugRow& draw_row(const PartModel& part, Place place) {
    while (true) {
      const PlugRow& row = plug_rows()[random_.below(plug_rows().size())];
      if (row.stage == 'G' || row.name == "tangent_object_space" || row.name == "material_metallic_roughness") continue;
      if (row.name == "add_light" || (place == Place::texture && row.name != "texture_color" && random_.percent(60))) continue;
      if (place == Place::light && row.name != "light_scale" && random_.percent(60)) continue;
      const bool fits = part.type == PartType::vertex  ? row.stage == 'V'
                        : part.type == PartType::light ? row.stage == 'L'
                                                       : row.stage != 'V';
      if (fits || random_.percent(mistakes_ ? 6 : 2)) return row;
    }
  }

  ParameterModel weakened(ParameterModel parameter) {
    if (parameter.type == "samplerT")
      parameter.type = random_.one_of({"sampler2D", "sampler2D", "sampler2D", "sampler3D", "samplerCube"});
    if (random_.percent(60)) return parameter;
    parameter.qualifier = parameter.qualifier == "inout" ? random_.one_of({"inout", "in", "const in", "out", "", "const"})
                                                         : random_.one_of({"in", "const in", "", "const"});
    return parameter;
  }

  void spoil(FunctionModel& function) {
    if (slip(3)) function.name = random_.one_of({"fragment_modfy", "nothing_of_the_kind"});
    if (slip(3)) function.returned = "float";
    if (slip(3)) function.parameters.pop_back();
    if (slip(3)) function.parameters.push_back({"in", "float"});
    if (function.parameters.empty()) return;
    if (slip(3)) function.parameters[0].type = function.parameters[0].type == "vec4" ? "vec3" : "vec4";
    if (slip(3)) function.parameters.back().qualifier = random_.one_of({"inout", "out"});
  }

  void add_statements(const PartModel& part, FunctionModel& function, bool of_light) {
    for (const GlobalModel& global : part.globals) {
      if (!random_.percent(50)) continue;
      const bool writes = global.kind == GlobalKind::varying && part.type == PartType::vertex;
      function.statements.push_back({writes ? StatementKind::write : StatementKind::read, global.name, global.type});
    }
    for (const FunctionModel& helper : part.functions) {
      // an author's plug calls none: it may be filled from within a helper, and GLSL knows no recursion
      if (function.is_plug && !is_custom(function.name) && !helper.is_plug && random_.percent(60)) {
        function.statements.push_back({StatementKind::call, helper.name, helper.parameters[0].type});
      }
    }
    if (random_.percent(15)) {
      const std::string name = random_.one_of({"dim", "warp"});
      function.statements.push_back({StatementKind::marker, name, name == "dim" ? "float" : "vec3", slip(8) ? 2 : 1});
    }
    if (random_.percent(15)) {
      const std::string name = random_.one_of({"castle_MaterialShininess", "castle_GlobalAmbient", "castle_LightSource0Color"});
      function.statements.push_back({StatementKind::renderer, name, name == "castle_MaterialShininess" ? "float" : "vec3"});
    }
    if (of_light && random_.percent(40))
      function.statements.push_back({StatementKind::renderer, "castle_LightSourceColor", "vec3"});
    for (std::size_t i = function.statements.size(); i > 1; --i) {
      std::swap(function.statements[i - 1], function.statements[random_.below(i)]);
    }
  }

  Random random_;
  const bool mistakes_;
  EffectSet set_;
  std::vector<Place> places_;                    // where each effect was first put
  Names names_;                                  // of the effect in the making
  std::array<std::array<bool, 2>, 2> sought_{};  // by helper and overload: it is sought in other effects, not defined
  int next_tag_ = 100;
};

}  // namespace

EffectSet generate_effect_set(std::uint64_t seed, bool mistakes) {
  return Generator(seed, mistakes).run();
}

}  // namespace plugc::oracle

// Which pieces of code make up a program, in the order in which they are called: the base shader (or a ComposedShader),
// the renderer's lights and textures, then the effects of each light with its shadow, of each texture, of the shape. Libraries
// that effects name come last: they only define functions.

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/geometry_stage.h"
#include "compose/placed_unit.h"
#include "compose/screen_library.h"
#include "compose/shading_features.h"
#include "compose/shadow_units.h"
#include "compose/style_features.h"
#include "compose/texture_features.h"

namespace plugc {
namespace {

class Placer {
 public:
  explicit Placer(Composition& composition)
      : c_(composition), recipe_(composition.recipe), lighting_(recipe_.gouraud ? ShaderStage::vertex : ShaderStage::fragment) {
    c_.has_geometry = wants_geometry_stage(c_);
    for (const int effect : all_effects(recipe_)) note_used_names(c_.input.effects[static_cast<std::size_t>(effect)]);
    if (recipe_.shader >= 0) note_used_names(c_.input.shaders[static_cast<std::size_t>(recipe_.shader)]);
  }

  void place();

 private:
  void note_used_names(const EffectCode& code);
  void add_switches();
  std::vector<std::size_t> guards(PlugScope scope, int effect = -1) const;
  void add_template(std::string_view name, ShaderStage stage, const Features& features, PlugScope scope);
  void place_screen(const Features& features, bool own_vertex_stage);
  void place_base();
  bool place_shader();
  void place_light(int number);
  void place_shadow(const LightRecipe& light, PlugScope scope);
  void place_texture(int number);
  void place_further_texture(int number);
  void place_effects(const std::vector<int>& effects, PlugScope scope);
  void place_code(const EffectCode& code, std::size_t owner, PlugScope scope);
  void place_wanted_coordinates();
  void place_fog();
  void place_libraries();
  void place_style();
  bool base_has_marker(std::string_view name) const;
  bool authors_use(std::string_view castle_name) const { return used_names_.contains(castle_name); }

  Composition& c_;
  const Recipe& recipe_;
  ShaderStage lighting_;
  UsedNames used_names_;
  bool base_adds_lights_ = false;  // the base shader has the plug `add_light`, not only its older form
};

/// Of the code that can come to stand in the program.
void Placer::note_used_names(const EffectCode& code) {
  for (const EffectCode::Part& part : code.parts) {
    const std::pair<const CodeUnit*, bool> forms[] = {{part.in_vertex.get(), true},
                                                      {part.in_geometry.get(), c_.has_geometry},
                                                      {part.in_fragment.get(), !recipe_.depth_only},
                                                      {part.behind_geometry.get(), c_.has_geometry && !recipe_.depth_only}};
    for (const auto& [unit, placed] : forms) {
      if (unit != nullptr && placed) used_names_.insert(unit->castle_names.begin(), unit->castle_names.end());
    }
  }
}

/// A switch for each effect and each light that may be off while the program runs.
void Placer::add_switches() {
  auto& switches = c_.result.switches;
  const auto add = [&](bool of_light, int index) {
    switches.push_back({fmt::format("plugc_on_{}", switches.size()), of_light, index});
  };
  for (const int effect : recipe_.guarded) add(false, effect);
  for (std::size_t i = 0; i < recipe_.lights.size(); ++i) {
    if (recipe_.lights[i].guarded) add(true, static_cast<int>(i));
  }
}

std::vector<std::size_t> Placer::guards(PlugScope scope, int effect) const {
  std::vector<std::size_t> found;
  const auto& switches = c_.result.switches;
  for (std::size_t i = 0; i < switches.size(); ++i) {
    const bool guards = switches[i].of_light ? scope.kind == ScopeKind::light && switches[i].index == scope.number
                                             : switches[i].index == effect;
    if (guards) found.push_back(i);
  }
  return found;
}

void Placer::add_template(std::string_view name, ShaderStage stage, const Features& features, PlugScope scope) {
  c_.units.push_back(make_placed_unit(c_.input.templates.get(name, features, scope.number), stage, 0, scope));
  c_.units.back().guards = guards(scope);
}

bool Placer::base_has_marker(std::string_view name) const {
  return std::any_of(c_.units.begin(), c_.units.end(), [&](const PlacedUnit& unit) {
    const auto& markers = unit.code->outline.markers;
    return std::any_of(markers.begin(), markers.end(), [&](const MarkerOutline& marker) { return marker.name == name; });
  });
}

/// A ComposedShader takes the place of the base shader. One that has fragment code alone stands behind the base's vertex stage,
/// as it stood behind the fixed functions once (thesis, chapter 3).
bool Placer::place_shader() {
  if (recipe_.shader < 0 || c_.result.faulty_shader) return false;
  const auto index = static_cast<std::size_t>(recipe_.shader);
  const EffectCode& code = c_.input.shaders[index];
  const auto has = [&](auto member) {
    return std::any_of(code.parts.begin(), code.parts.end(),
                       [&](const EffectCode::Part& part) { return part.*member != nullptr; });
  };
  if (!has(&EffectCode::Part::in_fragment)) {
    c_.diagnostics.report(DiagnosticId::shader_without_stage, c_.input.scene.shaders[index].span,
                          fmt::format("this `ComposedShader` needs a `FRAGMENT` part; {}", without_shader(recipe_)));
    c_.result.faulty_shader = true;
    return false;
  }
  const bool of_screen = recipe_.screen_pass != ScreenPass::none;
  const bool own_vertex_stage = has(&EffectCode::Part::in_vertex);
  if (of_screen)
    place_screen(screen_features(code, recipe_.screen_pass, c_.target), own_vertex_stage);
  else if (!own_vertex_stage)
    add_template("phong.vert", ShaderStage::vertex, base_features(recipe_, used_names_), {});
  c_.owners.push_back({OwnerKind::shader, recipe_.shader, {}, {}});
  place_code(code, c_.owners.size() - 1, {});
  return true;
}

/// In front of the author's code, which calls functions of the library without declaring them. What an own vertex stage hands
/// on is its author's to declare.
void Placer::place_screen(const Features& features, bool own_vertex_stage) {
  constexpr std::string_view kPosition = "POSITION_01";
  Features kept;
  for (const std::string_view feature : features.names())
    if (feature != kPosition || !own_vertex_stage) kept.insert(feature);
  add_template("screen_effect.frag", ShaderStage::fragment, kept, {});
  if (own_vertex_stage) return;
  add_template("screen_effect.vert", ShaderStage::vertex, kept.contains(kPosition) ? Features{kPosition} : Features{}, {});
}

void Placer::place_base() {
  if (recipe_.map_pass != MapPass::none) {
    add_template("shadows/whole_map.vert", ShaderStage::vertex, {}, {});
    for (const ShadowUnit& unit : map_pass_units(recipe_.map_pass))
      add_template(unit.file, ShaderStage::fragment, unit.features, {});
  } else if (recipe_.screen_pass != ScreenPass::none) {
    if (!place_shader()) place_screen({"COLOR", "F_GET_ORIGINAL_COLOR", "PLAIN"}, false);  // what is drawn stays
  } else if (recipe_.depth_only) {
    add_template("depth.vert", ShaderStage::vertex, base_features(recipe_, used_names_), {});
    const bool has_end = recipe_.of_point_light || recipe_.clip_planes > 0;
    add_template("depth.frag", ShaderStage::fragment, has_end ? Features{"FRAGMENT_END"} : Features{}, {});
  } else if (!place_shader()) {
    const Features features = base_features(recipe_, used_names_);
    add_template(recipe_.gouraud ? "gouraud.vert" : "phong.vert", ShaderStage::vertex, features, {});
    add_template(recipe_.gouraud ? "gouraud.frag" : "phong.frag", ShaderStage::fragment, features, {});
  }
}

void Placer::place_light(int number) {
  const LightRecipe& light = recipe_.lights[static_cast<std::size_t>(number)];
  if (light.off) return;
  const PlugScope scope{ScopeKind::light, number};
  add_template("light.glsl", lighting_, light_features(c_, light, base_adds_lights_), scope);
  if (!light.shadow || light.shadow_method == ShadowMethod::traced) return;
  add_template("shadow.vert", ShaderStage::vertex, keeps_moments(light.shadow_method) ? Features{"MOMENTS"} : Features{},
               scope);
  c_.units.back().of_shadow = true;
}

void Placer::place_shadow(const LightRecipe& light, PlugScope scope) {
  for (const ShadowUnit& unit : shadow_units(light, c_.target)) {
    add_template(unit.file, lighting_, unit.features, scope);
    c_.units.back().of_shadow = true;
  }
}

/// A texture beside the material's main ones.
void Placer::place_further_texture(int number) {
  const TextureRecipe& texture = recipe_.textures[static_cast<std::size_t>(number)];
  if (texture.role == TextureRole::unused) return;
  constexpr std::string_view kRoles[] = {"",         "AMBIENT",   "SPECULAR",           "SHININESS",
                                         "EMISSIVE", "OCCLUSION", "METALLIC_ROUGHNESS", "NORMAL"};
  const PlugScope scope{ScopeKind::texture, number};
  Features features = {kRoles[static_cast<std::size_t>(texture.role)]};
  if (recipe_.physical && texture.role == TextureRole::emissive) features.insert("LINEAR_LIGHT");
  if (recipe_.two_sided) features.insert("TWO_SIDED");
  add_template("texture.vert", ShaderStage::vertex, coordinate_features(texture), scope);
  if (texture.role == TextureRole::normal) add_template("tangent.vert", ShaderStage::vertex, {}, scope);
  add_template("surface.frag", ShaderStage::fragment, features, scope);
  c_.units.back().offers_to_scope_alone = true;
}

void Placer::place_texture(int number) {
  const TextureRecipe& texture = recipe_.textures[static_cast<std::size_t>(number)];
  if (texture.role != TextureRole::main) return place_further_texture(number);
  const PlugScope scope{ScopeKind::texture, number};
  Features features = texture_features(texture, number == 0);
  if (recipe_.physical) features.insert("LINEAR_LIGHT");
  add_template("texture.vert", ShaderStage::vertex, coordinate_features(texture), scope);
  add_template("texture.frag", ShaderStage::fragment, features, scope);
  for (const Features& mode : mode_features(texture.combination))
    add_template("texture_mode.glsl", ShaderStage::fragment, mode, scope);
}

/// Coordinates that effects read though the shape has no texture there (effects.md: a castle_ name that is used is fed).
void Placer::place_wanted_coordinates() {
  constexpr int kMaxUnits = 8;
  for (int unit = 0; unit < kMaxUnits; ++unit) {
    const auto number = static_cast<std::size_t>(unit);
    const bool is_there = number < recipe_.textures.size() && recipe_.textures[number].role != TextureRole::unused;
    if (!is_there && authors_use("castle_TexCoord" + std::to_string(unit))) {
      add_template("texture.vert", ShaderStage::vertex, coordinate_features({}), {ScopeKind::texture, unit});
    }
  }
}

/// What says how deep a vertex lies in the fog.
Features fog_depth_features(const Recipe& recipe) {
  if (recipe.fog_coord) return {"FOG_COORD"};
  return recipe.fog_plane ? Features{"FOG_PLANE"} : Features{};
}

void Placer::place_fog() {
  constexpr PlugScope kScope{ScopeKind::fog, 0};
  const bool drawn = recipe_.fog != FogKind::none;
  if (!drawn && !authors_use("castle_FogFragCoord")) return;
  add_template("fog.vert", ShaderStage::vertex, fog_depth_features(recipe_), kScope);
  if (!drawn) return;
  constexpr std::string_view kKinds[] = {"", "LINEAR", "EXPONENTIAL", "EITHER"};
  add_template("fog.frag", ShaderStage::fragment, {kKinds[static_cast<std::size_t>(recipe_.fog)]}, kScope);
}

/// How lines, points and the filling of faces are drawn, and what cuts the shape.
void Placer::place_style() {
  if (recipe_.point_size) add_template("point_size.vert", ShaderStage::vertex, {}, {});
  if (const std::string_view word = line_type_word(recipe_.line_type); !word.empty()) {
    add_template("line_type.vert", ShaderStage::vertex, {}, {});
    add_template("line_type.frag", ShaderStage::fragment, {word}, {});
  }
  for (int plane = 0; plane < static_cast<int>(recipe_.clip_planes); ++plane) {
    const PlugScope scope{ScopeKind::clip_plane, plane};
    add_template("clip_plane.vert", ShaderStage::vertex, {}, scope);
    add_template("clip_plane.frag", ShaderStage::fragment, {}, scope);
  }
}

/// Adds the features of the library's functions that a part names.
void note_library_features(const CodeUnit& code, std::set<std::string_view>& features) {
  constexpr std::pair<std::string_view, std::string_view> kFunctions[] = {
      {"position_world_to_eye_space", "POSITION_WORLD_TO_EYE"},
      {"position_eye_to_world_space", "POSITION_EYE_TO_WORLD"},
      {"direction_world_to_eye_space", "DIRECTION_WORLD_TO_EYE"},
      {"direction_eye_to_world_space", "DIRECTION_EYE_TO_WORLD"}};
  for (const auto& [function, feature] : kFunctions) {
    if (code.text.text().find(function) != std::string_view::npos) features.insert(feature);
  }
}

/// `castle-shader:/EyeWorldSpace.glsl` once in each stage in which an effect that names it has code (the scene knows no other).
void Placer::place_libraries() {
  std::map<ShaderStage, std::set<std::string_view>> stages;
  for (const PlacedUnit& unit : c_.units) {
    const Owner& owner = c_.owners[unit.owner];
    if (owner.kind == OwnerKind::effect && !c_.author(owner).libraries.empty())
      note_library_features(*unit.code, stages[unit.stage]);
  }
  for (const auto& [stage, names] : stages) {
    Features features;
    for (const std::string_view name : names) features.insert(name);
    if (!names.empty()) add_template("eye_world_space.glsl", stage, features, {});
  }
}

void Placer::place_code(const EffectCode& code, std::size_t owner, PlugScope scope) {
  const auto add = [&](const std::shared_ptr<const CodeUnit>& unit, ShaderStage stage) {
    c_.units.push_back(make_placed_unit(unit, stage, owner, scope));
  };
  for (const EffectCode::Part& any_form : code.parts) {
    const EffectCode::Part& part = any_form.form(c_.target);
    const auto& in_fragment = c_.has_geometry && part.behind_geometry ? part.behind_geometry : part.in_fragment;
    if (part.stage == PartStage::light) {
      add(lighting_ == ShaderStage::vertex ? part.in_vertex : in_fragment, lighting_);
    } else if (part.stage == PartStage::vertex) {
      add(part.in_vertex, ShaderStage::vertex);
    } else if (part.stage == PartStage::geometry && c_.has_geometry) {
      add(part.in_geometry, ShaderStage::geometry);
    } else if (part.stage == PartStage::fragment && !recipe_.depth_only) {
      add(in_fragment, ShaderStage::fragment);
    }
  }
}

void Placer::place_effects(const std::vector<int>& effects, PlugScope scope) {
  const auto& faulty = c_.result.faulty_effects;  // those that the target cannot have
  for (const int effect : effects) {
    if (std::find(faulty.begin(), faulty.end(), effect) != faulty.end()) continue;
    c_.owners.push_back({OwnerKind::effect, effect, {}, {}});
    const std::size_t first = c_.units.size();
    place_code(c_.input.effects[static_cast<std::size_t>(effect)], c_.owners.size() - 1, scope);
    for (std::size_t unit = first; unit < c_.units.size(); ++unit) c_.units[unit].guards = guards(scope, effect);
  }
}

void Placer::place() {
  add_switches();
  place_base();
  base_adds_lights_ = base_has_marker("add_light");
  for (std::size_t i = 0; i < recipe_.lights.size(); ++i) place_light(static_cast<int>(i));
  if (std::ranges::any_of(recipe_.textures, uses_diffuse, &TextureRecipe::combination))
    add_template("texture_diffuse.frag", ShaderStage::fragment, {}, {});
  for (std::size_t i = 0; i < recipe_.textures.size(); ++i) place_texture(static_cast<int>(i));
  place_wanted_coordinates();
  place_fog();
  if (recipe_.alpha_test)
    add_template("alpha_test.frag", ShaderStage::fragment, recipe_.alpha_cutoff ? Features{"CUTOFF"} : Features{}, {});
  place_style();
  if (recipe_.of_point_light)
    add_template("point_depth.frag", ShaderStage::fragment, recipe_.cut_near ? Features{"NEAR"} : Features{}, {});
  for (std::size_t i = 0; i < recipe_.lights.size(); ++i) {
    const LightRecipe& light = recipe_.lights[i];
    const PlugScope scope{ScopeKind::light, static_cast<int>(i)};
    place_effects(light.effects, scope);
    if (light.shadow) place_shadow(light, scope);
  }
  for (std::size_t i = 0; i < recipe_.textures.size(); ++i) {
    place_effects(recipe_.textures[i].effects, {ScopeKind::texture, static_cast<int>(i)});
  }
  place_effects(recipe_.effects, {});
  if (recipe_.hatch != 0 || !recipe_.filled)  // over what effects have made of the colour
    add_template("hatch.frag", ShaderStage::fragment, hatch_features(recipe_), {});
  place_libraries();
}

}  // namespace

void place_units(Composition& composition) {
  Placer(composition).place();
}

}  // namespace plugc

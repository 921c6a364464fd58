// A switch is on while some slots have certain values: an effect's `enabled` is TRUE; a light's `on` is TRUE and every
// Switch above it has chosen its branch. All values that those slots can take together are gone through, and the sets of
// switches that are on then are the states that can occur: two lights in two branches of one Switch make two states, not
// four. Where they ask for too many programs, one program has them all, each under a uniform.

#include "compose/shape_states.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>

#include "base/check.h"
#include "compose/compose.h"

namespace plugc {
namespace {

/// More switches than this are never composed one by one; a table has an entry for each of their combinations.
constexpr std::size_t kMaxSwitches = 8;
/// How many combinations of slots' values are looked at.
constexpr std::size_t kMaxCombinations = 4096;
/// Geometry shaders that have programs of their own: no uniform can stand in front of a `main`.
constexpr std::size_t kMaxSwitchedMains = 3;

using State = std::uint32_t;

struct Condition {
  std::uint32_t slot = kSceneNoSlot;
  double value = 1;
};

/// All must hold.
using Conditions = std::vector<Condition>;

/// The slot itself, or the one that always holds the same.
std::uint32_t leading_slot(const Scene& scene, std::uint32_t slot) {
  const std::uint32_t mirrored = scene.slots[slot].mirrors;
  return mirrored == kSceneNoSlot ? slot : mirrored;
}

/// The choices of the Switches above a place.
void add_choices(const Scene& scene, int transform, Conditions& conditions) {
  for (; transform >= 0; transform = scene.transforms[static_cast<std::size_t>(transform)].parent) {
    const SceneTransform& here = scene.transforms[static_cast<std::size_t>(transform)];
    if (here.switch_slot != kSceneNoSlot)
      conditions.push_back({leading_slot(scene, here.switch_slot), static_cast<double>(here.choice)});
  }
}

Conditions conditions_of(const Scene& scene, const ShapeSwitch& one) {
  if (!one.of_light) return {{leading_slot(scene, scene.effects[static_cast<std::size_t>(one.index)].enabled), 1}};
  const SceneLight& light = scene.lights[static_cast<std::size_t>(one.index)];
  Conditions conditions;
  if (scene.slots[light.on].routed) conditions.push_back({leading_slot(scene, light.on), 1});
  add_choices(scene, light.transform, conditions);
  return conditions;
}

class StateMaker {
 public:
  StateMaker(const Scene& scene, const SceneShape& shape, const ShapeFacts& facts, const std::vector<EffectCode>& codes)
      : scene_(scene), shape_(shape), facts_(facts), codes_(codes), full_(make_recipe(scene, shape, facts, codes)) {}
  ShapeStates make();

 private:
  std::vector<ShapeSwitch> find_switches() const;
  std::optional<std::set<State>> occurring(const std::vector<ShapeSwitch>& switches) const;
  std::optional<ShapeStates> try_table(const std::vector<ShapeSwitch>& switches, const SwitchedParts& always) const;
  Recipe recipe_in(State state, const std::vector<ShapeSwitch>& switches, SwitchedParts parts) const;
  ShapeStates with_guards(const std::vector<ShapeSwitch>& switches) const;

  const Scene& scene_;
  const SceneShape& shape_;
  const ShapeFacts& facts_;
  const std::vector<EffectCode>& codes_;
  const Recipe full_;  // with everything on
};

/// Only what has code in the shape's program.
std::vector<ShapeSwitch> StateMaker::find_switches() const {
  std::vector<ShapeSwitch> found;
  for (const int effect : all_effects(full_)) {
    if (scene_.effects[static_cast<std::size_t>(effect)].enabled != kSceneNoSlot) found.push_back({false, effect});
  }
  for (std::size_t i = 0; i < full_.lights.size(); ++i) {
    const ShapeSwitch light{true, shape_.lights[i]};
    if (!conditions_of(scene_, light).empty()) found.push_back(light);
  }
  return found;
}

/// The values that matter of each slot, and one that is none of them; a slot that decides whether the shape itself is shown
/// has the value with which it is.
std::map<std::uint32_t, std::vector<double>> slot_values(const Scene& scene, const SceneShape& shape,
                                                         const std::vector<Conditions>& conditions) {
  std::map<std::uint32_t, std::vector<double>> values;
  for (const Conditions& all : conditions) {
    for (const Condition& one : all) {
      auto& known = values[one.slot];
      if (std::ranges::find(known, one.value) == known.end()) known.push_back(one.value);
    }
  }
  for (auto& [slot, known] : values) known.push_back(scene.slots[slot].type == SlotType::bool_ ? 0 : -1);
  Conditions shown;
  add_choices(scene, shape.transform, shown);
  for (const Condition& one : shown) {
    if (const auto found = values.find(one.slot); found != values.end()) found->second = {one.value};
  }
  return values;
}

std::optional<std::set<State>> StateMaker::occurring(const std::vector<ShapeSwitch>& switches) const {
  std::vector<Conditions> conditions;
  for (const ShapeSwitch& one : switches) conditions.push_back(conditions_of(scene_, one));
  const auto values = slot_values(scene_, shape_, conditions);
  std::size_t combinations = 1;
  for (const auto& [slot, known] : values) {
    combinations *= known.size();
    if (combinations > kMaxCombinations) return std::nullopt;
  }
  std::set<State> states;
  for (std::size_t number = 0; number < combinations; ++number) {
    std::map<std::uint32_t, double> chosen;
    std::size_t rest = number;
    for (const auto& [slot, known] : values) {
      chosen[slot] = known[rest % known.size()];
      rest /= known.size();
    }
    State state = 0;
    for (std::size_t i = 0; i < switches.size(); ++i) {
      const bool on =
          std::ranges::all_of(conditions[i], [&](const Condition& one) { return chosen.at(one.slot) == one.value; });
      if (on) state |= State{1} << i;
    }
    states.insert(state);
  }
  return states;
}

Recipe StateMaker::recipe_in(State state, const std::vector<ShapeSwitch>& switches, SwitchedParts parts) const {
  for (std::size_t i = 0; i < switches.size(); ++i) {
    if ((state >> i & 1U) == 0) (switches[i].of_light ? parts.lights_off : parts.effects_off).insert(switches[i].index);
  }
  return make_recipe(scene_, shape_, facts_, codes_, parts);
}

/// Finds for each recipe one with more switched on. Every switch is on in some recipe without such a one, and there mistakes
/// are reported: in the others an effect may merely miss what is off.
void note_fuller(const std::vector<State>& order, const std::vector<std::uint8_t>& states, std::vector<StateRecipe>& recipes) {
  std::vector<State> full;
  State covered = 0;
  for (const State state : order) {
    const bool adds = full.empty() || (state & ~covered) != 0;
    if (!adds) continue;
    covered |= state;
    full.push_back(state);
  }
  std::vector<bool> is_full(recipes.size(), false);
  for (const State state : full) is_full[states[state]] = true;
  for (const State state : order) {
    if (is_full[states[state]]) continue;
    const auto superset = std::ranges::find_if(full, [&](State other) { return (state & ~other) == 0; });
    recipes[states[state]].fuller = states[superset == full.end() ? full.front() : *superset];
  }
}

/// A program for each state; nothing when those are too many. `always`: what holds in all of them.
std::optional<ShapeStates> StateMaker::try_table(const std::vector<ShapeSwitch>& switches, const SwitchedParts& always) const {
  if (switches.size() > kMaxSwitches) return std::nullopt;
  const auto occurring_states = occurring(switches);
  if (!occurring_states) return std::nullopt;
  std::vector<State> order(occurring_states->begin(), occurring_states->end());
  std::ranges::stable_sort(order, [](State a, State b) { return std::popcount(a) > std::popcount(b); });
  ShapeStates result;
  result.switches = switches;
  result.states.assign(std::size_t{1} << switches.size(), 0);
  for (const State state : order) {
    Recipe recipe = recipe_in(state, switches, always);
    auto known = std::ranges::find(result.recipes, recipe, &StateRecipe::recipe);
    if (known == result.recipes.end()) {
      if (result.recipes.size() == kMaxShapePrograms) return std::nullopt;
      known = result.recipes.insert(known, {std::move(recipe), -1});
    }
    result.states[state] = static_cast<std::uint8_t>(known - result.recipes.begin());
  }
  if (result.recipes.size() == 1) return ShapeStates{{}, {0}, std::move(result.recipes)};
  note_fuller(order, result.states, result.recipes);
  return result;
}

/// One program with every switch in it, save those of geometry shaders.
ShapeStates StateMaker::with_guards(const std::vector<ShapeSwitch>& switches) const {
  std::vector<ShapeSwitch> mains;
  SwitchedParts guarded;
  for (const ShapeSwitch& one : switches) {
    const bool has_main = !one.of_light && codes_[static_cast<std::size_t>(one.index)].has_geometry_main;
    if (has_main && mains.size() < kMaxSwitchedMains)
      mains.push_back(one);
    else
      (one.of_light ? guarded.lights_guarded : guarded.effects_guarded).insert(one.index);
  }
  auto table = try_table(mains, guarded);
  PLUGC_CHECK(table.has_value(), "so few switches have a table");
  return std::move(*table);
}

ShapeStates StateMaker::make() {
  const std::vector<ShapeSwitch> switches = find_switches();
  if (switches.empty()) return {{}, {0}, {{full_, -1}}};
  if (auto table = try_table(switches, {})) return std::move(*table);
  return with_guards(switches);
}

}  // namespace

ShapeStates make_shape_states(const Scene& scene, const SceneShape& shape, const ShapeFacts& facts,
                              const std::vector<EffectCode>& codes) {
  return StateMaker(scene, shape, facts, codes).make();
}

}  // namespace plugc

// Effects of different lists are called in an order that no author can change, so pairs are sought within lists only. Effects
// whose plugs differ cannot be told apart by order: each plug function is called at its own marker, and what one of them
// writes for another (a varying, a global) is its own.

#include "compose/effect_pairs.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace plugc {
namespace {

template <typename Function>
void each_list(auto& scene, Function function) {
  for (auto& light : scene.lights) function(light.effects);
  for (auto& texture : scene.textures) function(texture.effects);
  for (auto& shape : scene.shapes) function(shape.effects);
}

std::vector<std::string> common_plugs(const EffectCode& a, const EffectCode& b) {
  std::vector<std::string> common;
  std::ranges::set_intersection(a.plugs, b.plugs, std::back_inserter(common));
  return common;
}

}  // namespace

std::vector<EffectPair> find_effect_pairs(const Scene& scene, const std::vector<EffectCode>& codes) {
  std::vector<EffectPair> pairs;
  std::set<std::pair<int, int>> known;
  each_list(scene, [&](const std::vector<int>& effects) {
    for (std::size_t i = 0; i < effects.size(); ++i) {
      for (std::size_t j = i + 1; j < effects.size(); ++j) {
        if (effects[i] == effects[j] || !known.insert(std::minmax(effects[i], effects[j])).second) continue;
        auto plugs = common_plugs(codes[static_cast<std::size_t>(effects[i])], codes[static_cast<std::size_t>(effects[j])]);
        if (!plugs.empty()) pairs.push_back({effects[i], effects[j], std::move(plugs)});
      }
    }
  });
  return pairs;
}

void arrange_pair(Scene& scene, int first, int second, PairOrder order) {
  each_list(scene, [&](std::vector<int>& effects) {
    const auto place = std::ranges::find(effects, first);
    if (place == effects.end() || std::ranges::find(effects, second) == effects.end()) return;
    const auto at = place - effects.begin() - std::count(effects.begin(), place, second);
    std::erase_if(effects, [&](int effect) { return effect == first || effect == second; });
    if (order == PairOrder::neither) return;
    const std::vector<int> pair = order == PairOrder::as_written ? std::vector{first, second} : std::vector{second, first};
    effects.insert(effects.begin() + at, pair.begin(), pair.end());
  });
}

}  // namespace plugc

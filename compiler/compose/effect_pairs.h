#pragma once
// Which effects meet at a plug, and scenes in which two of them are called in another order.

#include <string>
#include <vector>

#include "compose/code_unit.h"
#include "scene/scene.h"

namespace plugc {

/// Two effects of one list (of a shape's, a light's, a texture's) that fill a plug both: the list alone decides their order.
struct EffectPair {
  int first = -1, second = -1;  ///< Into Scene::effects, in the order of the list.
  std::vector<std::string> plugs;
};

/// Each pair once, in the order of the first list that has it.
std::vector<EffectPair> find_effect_pairs(const Scene& scene, const std::vector<EffectCode>& codes);

/// What becomes of a pair in a scene.
enum class PairOrder : std::uint8_t { as_written, exchanged, neither };

/// In every list that has both, the second follows the first at once, or precedes it at once, or both are gone.
void arrange_pair(Scene& scene, int first, int second, PairOrder order);

}  // namespace plugc

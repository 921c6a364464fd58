// Needs are few: a program has as many as its effects declare functions and varyings of others. So each question walks the
// whole set until nothing changes.

#include "validate/effect_needs.h"

namespace plugc {
namespace {

/// Plugs are left out: a function that nothing calls is valid all the same.
bool is_for_validity(const EffectNeed& need) {
  return !need.of_shader && need.kind != NeedKind::plug;
}

void add_behind_providers(int effect, const EffectNeeds& needs, std::set<int>& added, std::vector<int>& order) {
  std::vector<int> path = {effect};
  while (!path.empty()) {
    added.insert(path.back());
    const auto next = [&] {
      for (const EffectNeed& need : needs) {
        if (need.effect == path.back() && is_for_validity(need) && !added.contains(need.provider)) return need.provider;
      }
      return -1;
    }();
    if (next >= 0) {
      path.push_back(next);
    } else {
      order.push_back(path.back());
      path.pop_back();
    }
  }
}

}  // namespace

std::set<int> with_providers(std::set<int> effects, const EffectNeeds& needs) {
  for (bool grew = true; grew;) {
    grew = false;
    for (const EffectNeed& need : needs) {
      if (is_for_validity(need) && effects.contains(need.effect)) grew = effects.insert(need.provider).second || grew;
    }
  }
  return effects;
}

std::vector<int> providers_first(const std::vector<int>& effects, const EffectNeeds& needs) {
  std::vector<int> order;
  std::set<int> added;
  for (const int effect : effects) {
    if (!added.contains(effect)) add_behind_providers(effect, needs, added, order);
  }
  return order;
}

std::vector<EffectNeed> lost_needs(std::set<int> gone, bool shader_gone, const EffectNeeds& needs) {
  std::vector<EffectNeed> lost;
  for (bool grew = true; grew;) {
    grew = false;
    for (const EffectNeed& need : needs) {
      const bool met = need.of_shader ? !shader_gone : !gone.contains(need.provider);
      if (met || !gone.insert(need.effect).second) continue;
      lost.push_back(need);
      grew = true;
    }
  }
  return lost;
}

}  // namespace plugc

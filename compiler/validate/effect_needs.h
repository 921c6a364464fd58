#pragma once
// Which effects cannot do without which others.

#include <set>
#include <vector>

#include "compose/compose.h"

namespace plugc {

using EffectNeeds = std::set<EffectNeed>;

/// The effects, and all those without whose functions and varyings their code is not valid.
std::set<int> with_providers(std::set<int> effects, const EffectNeeds& needs);

/// The same effects, each behind those without which its code is not valid; else in the order given.
std::vector<int> providers_first(const std::vector<int>& effects, const EffectNeeds& needs);

/// One need that is no longer met for each effect that has to go with `gone` (and with the ComposedShader when
/// `shader_gone`), in the order in which they fall.
std::vector<EffectNeed> lost_needs(std::set<int> gone, bool shader_gone, const EffectNeeds& needs);

}  // namespace plugc

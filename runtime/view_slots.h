#pragma once
// What a rendered texture's view changes among the scene's values.

#include <utility>
#include <vector>

#include "runtime/events.h"
#include "runtime/world.h"

namespace plugc {

/// Slots with what they held before.
using LentSlots = std::vector<std::pair<std::uint32_t, std::vector<double>>>;

/// Before the texture is drawn: `rendering` is TRUE, and what it has of its own (its fog) stands in place of the world's.
LentSlots begin_view(Slots& slots, const PackedRenderedTexture& texture);
/// Once its camera is known: where `viewing` and `projection` are routed to.
void tell_view(Slots& slots, const PackedRenderedTexture& texture, const View& camera);
/// Afterwards.
void end_view(Slots& slots, const PackedRenderedTexture& texture, const LentSlots& lent);

}  // namespace plugc

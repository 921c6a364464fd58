#pragma once
// Whether and by whom a name is used. Internal to the compose room.

#include <cstdint>
#include <set>
#include <string_view>

#include "compose/placed_unit.h"

namespace plugc {

/// Whether the name stands anywhere in the unit but at `declared_at`.
bool is_used(const CodeUnit& code, std::string_view name, std::uint32_t declared_at);

/// An effect that acts in several places, on two lights or in two lists, is an owner in each, and one candidate.
std::set<std::size_t> one_for_each_author(const Composition& composition, const std::set<std::size_t>& owners);

}  // namespace plugc

#pragma once
// Outputs of a stage that the next one does not read become its private variables, so that the optimiser may drop them.

#include <cstdint>
#include <set>
#include <vector>

namespace plugc {

/// Locations that a stage's inputs take, of those that it uses. `array_of_vertices`: a geometry stage, which has each input
/// once a vertex. May throw what SPIRV-Cross throws.
std::set<std::uint32_t> read_locations(const std::vector<std::uint32_t>& module, bool array_of_vertices);

/// Rewrites every output of `module` at none of these locations, built-in ones apart. A stage may read its own outputs, so
/// that stores to them cannot just be left out.
void demote_outputs(std::vector<std::uint32_t>& module, const std::set<std::uint32_t>& read);

}  // namespace plugc

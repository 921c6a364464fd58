#pragma once
// Scenes of any size to measure reading with: nearly all numbers, or many small nodes with few fields; laid out as modelling
// tools do. The same in each encoding.

#include <string>

#include "document/document.h"

namespace plugc {

/// One PointSet of at least that many bytes.
std::string numbers_scene(Encoding encoding, std::size_t bytes);

/// Shapes of five nodes and seven fields each, at least that many bytes of them in one Group.
std::string nodes_scene(Encoding encoding, std::size_t bytes);

}  // namespace plugc

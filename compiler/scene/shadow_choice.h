#pragma once
// What was chosen for a shadow map so that its errors stay within a budget (`plugc build --shadow-error`), and what that came
// to. Whoever chooses has drawn the scene; here it is only taken over.

#include <cstdint>

#include "scene/shadow_method.h"

namespace plugc {

/// Shares are of the pixels that the map shadows, as means over the viewpoints. What the scene writes about its map still
/// stands before what is chosen.
struct ShadowChoice {
  std::uint32_t map = 0;  ///< Of Scene::shadow_maps.
  ShadowMethod method = kDefaultShadowMethod;
  std::uint32_t size = 0;  ///< Texels along a side.
  double scale = 0;        ///< glPolygonOffset's factor; 0: what suits the method.
  double budget = 0;       ///< Share of wrong pixels that was allowed,
  double error = 0;        ///< and the share that was measured; larger where nothing reaches the budget.
  std::uint32_t views = 0;
  bool traced_truth = false;  ///< Measured against traced shadows; else against a map as large as can be.
};

}  // namespace plugc

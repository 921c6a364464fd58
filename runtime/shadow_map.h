#pragma once
// The depth maps of a scene's lights: their textures, what each light sees, and when one must be drawn again.

#include <cstdint>
#include <vector>

#include "runtime/gl/target.h"
#include "runtime/gl/texture.h"
#include "runtime/messages.h"
#include "runtime/projection.h"

namespace plugc {

/// A shape in one of its variants.
struct MapReader {
  std::uint32_t shape = 0;
  std::uint8_t variant = 0;
};

struct ShadowMap {
  gl::Texture texture;  ///< None when the map is never drawn: whoever reads it is lit.
  gl::Framebuffer framebuffer;
  GLsizei size = 0;
  bool reversed = false;             ///< Stores depths that fall from 1 to 0: nobody but the renderer's own code reads them.
  std::vector<MapReader> readers;    ///< Whose programs look into it.
  bool only_projects = false;        ///< Never drawn, but some shape's texture coordinates are what its light sees.
  View view;                         ///< What the light saw when the map was drawn last.
  std::uint64_t drawn_revision = 0;  ///< Of the slots, at that time; 0: never.
  glm::dvec2 shift{0};               ///< Texels that it is moved under the scene: measurements average over several.
};

/// The view with the map moved by its `shift`.
View shifted(const View& view, const ShadowMap& map);

/// One per PackedShadowMap. Sizes beyond what can be made, and lights that cannot have a map yet, are reported.
std::vector<ShadowMap> make_shadow_maps(const gl::Functions& functions, const PackedScene& scene, Messages& messages);

/// Whether somebody visible looks into the map and it may differ from what it holds: it was never drawn, or it follows
/// the scene (`always`) and a slot has changed since. Nothing but slots moves a light, a caster or an effect.
bool must_be_drawn(const ShadowMap& map, PackedShadowUpdate update, const Slots& slots, const World& world);

/// Whether its light must be looked from again, though the map is not drawn.
bool must_be_fitted(const ShadowMap& map, const Slots& slots);

/// Shapes that are drawn into depth maps: visible, with a depth program.
bool casts(const PackedScene& scene, const World& world, std::uint32_t shape);

/// What the light of map `index` sees now, for depths that are stored so.
View fit_shadow_map(const Package& package, const PackedScene& scene, const Slots& slots, const World& world,
                    std::uint32_t index, bool reversed, Messages& messages);

}  // namespace plugc

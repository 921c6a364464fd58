#pragma once
// One scene ready to be drawn: its values, where everything is, and what the GPU holds of it.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/event_graph.h"
#include "runtime/events.h"
#include "runtime/live_meshes.h"
#include "runtime/program_pool.h"
#include "runtime/projected_coords.h"
#include "runtime/rendered_texture.h"
#include "runtime/resource_pool.h"
#include "runtime/screen_targets.h"
#include "runtime/shadow_map.h"
#include "runtime/traced_shadows.h"
#include "runtime/world.h"

namespace plugc {

struct LoadedScene {
  const Package* package = nullptr;
  const PackedScene* packed = nullptr;
  Slots slots;
  World world;  ///< As of `placed_revision` of the watched slots.
  std::uint64_t placed_revision = 0;
  ProgramPool programs;
  ResourcePool resources;
  std::vector<ShadowMap> shadow_maps;
  ProjectedCoordsPool projected_coords = {};
  std::optional<Viewer> placed_for = {};  ///< Whom Billboards are turned to.
  std::int32_t placed_scene = -1;         ///< What is visible in `world`: see place().
  Box framed = {};                        ///< World::framed of the world, not of a texture's own scene.
  TracedShadows traced = {};
  std::vector<RenderedTexture> rendered_textures = {};
  ScreenTargets screen = {};
  EventGraph events = {};
  LiveMeshes live_meshes = {};

  std::uint32_t shape_count() const { return packed->shapes()->size(); }
  const PackedShape& shape(std::uint32_t index) const { return *packed->shapes()->Get(index); }
  /// What the shape is drawn with, as its switches stand now.
  ShapePrograms programs_of(std::uint32_t index) const { return shape_programs(shape(index), world.shape_variant[index]); }
};

/// With its programs built and its geometry uploaded; what the driver rejects is reported. The package must outlive it.
LoadedScene load_scene(const gl::Functions& functions, const Package& package, const PackedScene& packed, Messages& messages);

}  // namespace plugc

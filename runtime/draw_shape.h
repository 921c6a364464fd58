#pragma once
// One shape in one pass: its program, its values, its textures, its triangles.

#include <set>
#include <vector>

#include "runtime/gl/pass.h"
#include "runtime/loaded_scene.h"
#include "runtime/render.h"

namespace plugc {

/// A pass seen from `view`.
struct Pass {
  const View& view;
  bool depth_only = false;                ///< A light's depth map: its view is `view`, and nothing reads a shadow map.
  bool shadows = true;                    ///< False: shadow maps are read as lit.
  std::vector<View> shadow_views = {};    ///< One per shadow map; none in a depth pass.
  std::set<std::uint32_t> programs = {};  ///< Used so far.
  bool of_point_light = false;            ///< A depth map all of whose depths are distances to a point light.
  glm::dvec4 depth_range{0};              ///< Of such a pass: PackedSource::depth_pass_range.
  std::int32_t bound_viewpoint = -1;      ///< Through which `view` looks; -1: through none of the scene's.
  glm::dvec2 target_size{1};              ///< Width and height of what is drawn into, in pixels.
  const View* wearer = nullptr;           ///< Who wears the headlight; null: `view`.
};

/// Draws over the whole target that is bound, with a program of its own: over a shadow map in a depth pass, over the picture in
/// another. False when the driver rejected the program.
bool draw_over_target(const gl::Functions& functions, LoadedScene& scene, Pass& pass, std::uint32_t program,
                      const flatbuffers::Vector<const PackedBinding*>& bindings, Messages& messages);

/// False when nothing was drawn: the driver rejected the program, or the mesh is empty.
bool draw_shape(const gl::Functions& functions, LoadedScene& scene, Pass& pass, std::uint32_t shape, Messages& messages);

/// How a shape is drawn into a picture: its faces, its blending, its lines and points.
gl::DrawState draw_state_of(const PackedShape& shape, const Slots& slots, const glm::dmat4& object_to_world);

/// The visible shapes that the view may show. Opaque ones first, by program, then state, then mesh, so that neighbours
/// share; then the blended ones from far to near.
std::vector<std::uint32_t> draw_order(const LoadedScene& scene, const View& view);

/// The shapes to draw into a depth map, or one face of a point light's, seen from `view`.
std::vector<std::uint32_t> caster_order(const LoadedScene& scene, const View& view, bool of_point_light);

}  // namespace plugc

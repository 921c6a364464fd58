#pragma once
// The triangles of a scene as rays meet them: in double, with what an alpha test reads.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "package/package_file.h"
#include "runtime/camera_rays.h"
#include "runtime/world.h"

namespace plugc {

/// Texels below `cutoff` are holes. Points into the package.
struct AlphaTest {
  std::uint32_t texture_index = 0;  ///< Of the package.
  const PackedTexture* texture = nullptr;
  const PackedImage* image = nullptr;
  double cutoff = 0.5;  ///< stdlib_plugs/templates/alpha_test.frag
};

/// A shape that is drawn as triangles.
struct Surface {
  std::uint32_t shape = 0;  ///< Of the scene.
  glm::dmat4 to_world{1.0};
  std::vector<glm::dvec3> points;      ///< Object space, three to a triangle; triangle i is the i-th that OpenGL draws.
  std::vector<glm::dvec2> tex_coords;  ///< The same, where an alpha test needs them; else empty.
  std::optional<AlphaTest> alpha_test;
  bool casts = false;
  bool may_move = false;  ///< Its program may move vertices: nothing is known of where it is.
};

/// The visible shapes of the scene. Lines and points are left out. `live`: meshes that events change.
std::vector<Surface> read_surfaces(const Package& package, const PackedScene& scene, const Slots& slots, const World& world,
                                   const LiveMeshes& live);

/// The planes of its triangles, normals by the order of their corners.
std::vector<Plane> world_planes(const Surface& surface);

/// The alpha of the texture there: linear between texels of the full picture (or the nearest, where the texture says so).
double alpha_at(const AlphaTest& test, const glm::dvec2& tex_coord);

}  // namespace plugc

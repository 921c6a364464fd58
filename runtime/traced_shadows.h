#pragma once
// The method `traced`: no map, but one ray to the light for each pixel of the picture, and their answers as a texture of the
// picture's size that shapes look their own pixel up in.

#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/gl/triangle_pass.h"
#include "runtime/messages.h"
#include "runtime/surfaces.h"
#include "runtime/tracer.h"

namespace plugc {

struct LoadedScene;

/// What a shape's triangles and their holes come from.
struct SurfaceKey {
  bool visible = false;
  glm::dmat4 to_world{1.0};
  std::uint8_t variant = 0;  ///< Says whether it casts, and which texture is tested.
  double alpha_cutoff = 0;
  std::uint32_t version = 0;  ///< LiveMesh::version.
  bool operator==(const SurfaceKey&) const = default;
};

/// What tracing keeps from frame to frame.
struct TracedShadows {
  gl::TrianglePass pass;
  bool placed = false;           ///< The geometry below is that of `keys`.
  std::vector<SurfaceKey> keys;  ///< By shape.
  std::vector<Surface> surfaces;
  std::vector<std::vector<Plane>> planes;  ///< By surface.
  std::vector<std::int32_t> surface_of;    ///< By shape of the scene; -1 for none.
  std::unique_ptr<Tracer> tracer;          ///< Null where nothing can be traced: then all is lit.
};

/// Traces the shadows of every light of that method for a picture of that size; each answer is the texture of the light's
/// ShadowMap. Blended shapes get the shadow of what is behind them. With `clips_depth` what is before the camera's near plane
/// or behind its far plane is not seen. Says in `messages` why nothing can be traced.
void trace_shadows(const gl::Functions& gl, LoadedScene& scene, const View& camera, bool clips_depth, GLsizei width,
                   GLsizei height, Messages& messages);

}  // namespace plugc

#pragma once
// One view of the scene into one target: what the picture, a rendered texture and each face of a cube have in common.

#include "runtime/draw_shape.h"
#include "runtime/frame.h"

namespace plugc {

struct SceneView {
  View camera;
  View shadow_camera;               ///< Whom shadow maps serve: the camera, or one `all_around` for all faces of a cube.
  const View* wearer = nullptr;     ///< Who wears the headlight; null: the camera.
  std::int32_t viewpoint = -1;      ///< Through which the camera looks; -1: through none of the scene's.
  std::int32_t without_shape = -1;  ///< It is not drawn, though it casts its shadow.
  std::uint32_t background_color = kNoSlot;
  std::int32_t backdrop_of = -1;  ///< The rendered texture that has its own backdrop; -1: the world's is around the view.
  bool clips_depth = false;       ///< Nothing is before the camera's near plane, or behind its far plane.
};

/// Looks through the camera at the scene as it is placed, as far as the viewer sees.
void look_through(const LoadedScene& scene, const View& camera, SceneView& view);

/// Draws the shadow maps that are out of date for the view, then the view, which `scene.world` must be placed for.
void draw_view(Frame& frame, const FrameTarget& target, const SceneView& view);

/// The pass of that view into that target, with the shadow maps as they are now.
Pass color_pass(const Frame& frame, const FrameTarget& target, const SceneView& view);

}  // namespace plugc

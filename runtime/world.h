#pragma once
// Where everything is: matrices in double, which shapes are shown, their boxes, and the camera.

#include <cstdint>
#include <string>
#include <vector>

#include "base/box.h"
#include "base/transform_matrix.h"
#include "package/package_file.h"
#include "runtime/events.h"
#include "runtime/live_meshes.h"
#include "runtime/messages.h"

namespace plugc {

/// A transform of the scene after its parents: object to world.
struct PlacedTransform {
  glm::dmat4 matrix{1.0};
  bool visible = true;  ///< No Switch above chose another child.
};

struct World {
  std::vector<PlacedTransform> transforms;
  std::vector<Box> object_bounds;  ///< Of each shape, in its own space.
  std::vector<Box> shape_bounds;   ///< World space; empty for a shape that is hidden, without vertices or of the backdrop.
  std::vector<bool> shape_visible;
  std::vector<std::uint8_t> shape_variant;  ///< Which of a shape's programs its switches ask for now.
  Box bounds;                               ///< Around all visible shapes.
  Box framed;                               ///< What a view of the whole shows; empty: `bounds`.

  /// The transform of that index; -1: the world.
  const PlacedTransform& at(std::int32_t transform) const;

 private:
  PlacedTransform root_;
};

/// Whoever looks at a scene whose Billboards turn and whose LODs choose: where the eye is, what is up to it, and what is behind
/// it.
struct Viewer {
  glm::dvec3 eye{0};
  glm::dvec3 up{0, 1, 0};
  glm::dvec3 back{0, 0, 1};
  bool operator==(const Viewer&) const = default;
};

/// Without a viewer, Billboards stay as they are written, and each LOD shows its nearest level. Visible is what stands in the
/// scene that rendered texture `own_scene_of` has of its own, or in the world (-1). `live`: those of the scene, up to date.
World place(const Package& package, const PackedScene& scene, const Slots& slots, const Viewer* viewer = nullptr,
            std::int32_t own_scene_of = -1, const LiveMeshes* live = nullptr);

/// Whether where things are, or which of them are shown, depends on the viewer.
bool depends_on_viewer(const PackedScene& scene);

/// Whether the light is on, and in no branch that a Switch has not chosen.
bool light_shines(const PackedLight& light, const Slots& slots, const World& world);

/// The way that the light shines where it stands at `to_world`: in world space, of unit length. Where it has no direction, -z
/// as in look_along().
glm::dvec3 light_direction(const PackedLight& light, const glm::dmat4& to_world, const Slots& slots);

/// How much of the light a shadow takes away: the field `shadowIntensity`, cut to 0 to 1.
double shadow_intensity(std::uint32_t slot, const Slots& slots);

/// Whether it can be seen what a shadow map darkens: not where its light does not shine, has `shadowIntensity` 0, or is black
/// and nothing else brings light.
bool shadow_shows(const PackedShadowMap& map, const PackedScene& scene, const Slots& slots, const World& world);

/// The shape's box in its own space: as its author wrote it where a program may move its vertices, else its mesh's. `live`: its
/// mesh, where events change it.
Box object_bounds(const Package& package, const PackedShape& shape, const LiveMesh* live = nullptr);

/// How much a matrix makes things longer, on the average of its axes.
double average_scale(const glm::dmat4& matrix);

/// The eye of a pass: a camera, or a light while its depth map is drawn.
struct View {
  glm::dmat4 world_to_eye{1.0};  ///< Rigid: no scale.
  glm::dmat4 eye_to_world{1.0};
  glm::dmat4 projection{1.0};
  double near = 0, far = 0;  ///< Of a light: between which distances along its view linear depth runs from 0 to 1; equal: none.
  bool all_around = false;   ///< Of a point light's map: no frustum; the projection divides by the largest distance, `far`.
  bool reversed = false;     ///< Clip depth runs from 1 (near) to 0 (far), as with glClipControl; else from -1 to 1.
};

/// A rigid frame with the eye at `position`, looking along `direction`. Neither vector needs to be unit or orthogonal; an
/// unusable one is replaced (direction by -z, up by whatever is orthogonal).
View look_along(const glm::dvec3& position, const glm::dvec3& direction, const glm::dvec3& up);

bool is_orthographic(const View& view);

/// What a matrix turns, without what it moves, scales, shears and mirrors. Always a rotation.
glm::dmat3 rotation_of(const glm::dmat4& matrix);

/// What a viewpoint sees in a picture of that shape.
View view_from(const PackedViewpoint& viewpoint, const Slots& slots, const World& world, double aspect);

/// The viewpoint that is looked through: `wanted` is a DEF name or an index from 0, else the one that is bound now. -1: none;
/// the whole scene is looked at.
std::int32_t bound_viewpoint(const PackedScene& scene, const Slots& slots, const std::string& wanted);

/// `wanted` is a DEF name or an index from 0; unknown ones are reported and the bound viewpoint taken. `aspect` is width /
/// height.
View make_camera(const PackedScene& scene, const Slots& slots, const World& world, const std::string& wanted, double aspect,
                 Messages& messages);

/// From in front of all that is visible, as where a scene has no viewpoint.
View view_of_world(const World& world, double aspect);

/// True when the box lies wholly on the outer side of the left, right, lower or upper plane of the clip space.
bool outside_sideways(const Box& box, const glm::dmat4& to_clip);

}  // namespace plugc

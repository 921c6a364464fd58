#pragma once
// What stands around the eye: the parts of a Background as meshes, seen from within. The eye is at the origin, the distance 1.

#include <optional>

#include "base/diagnostics.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

namespace plugc {

/// One part of a Background or TextureBackground: the gradients of sky and ground as a sphere with colours, or a side of the
/// cube with texture coordinates from 0 to 1. Nullopt (with a diagnostic) where there are more colours than a mesh can hold.
/// Source: X3D 4.1 (ISO/IEC 19775-1) 24.2.1, 24.3.1, 24.4.5.
std::optional<Mesh> make_backdrop_mesh(const NodeGraph& graph, NodeId background, ScenePart part, Diagnostics& diagnostics);

}  // namespace plugc

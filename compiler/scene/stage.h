#pragma once
// The stage on which effects without shapes are tried: a lit, shadowed shape above a floor.

#include <string>
#include <string_view>

namespace plugc {

/// A classic X3D scene for build_graph to append to the author's, so that group effects at the file's top level reach it as
/// they reach any shape. `name` is teapot, sphere, box or plane.
std::string stage_scene(std::string_view name);

/// The geometry node of that name.
std::string_view stage_geometry(std::string_view name);

}  // namespace plugc

#pragma once
// Varyings on their way through a geometry stage. In GLSL a stage cannot read and write one name, so `x` comes out as
// `x_geoshader` (the names of the engine whose effects plugc takes), and fragment code that says `x` gets that name.
// Internal to the compose room.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compose/code_unit.h"

namespace plugc {

inline constexpr std::string_view kBehindGeometry = "_geoshader";

/// `castle_Color_geoshader` -> `castle_Color`; "" for names without that end.
std::string_view name_before_geometry(std::string_view name);

/// What `/* VARYING-PASSTHROUGH-GEOMETRY-SHADERS */` stands in front of: the varyings of the declaration behind it. Empty
/// where that is none, or one that cannot pass (an array, a struct).
std::vector<const GlobalOutline*> marked_varyings(const CodeUnit& code, const MarkerOutline& marker);

/// Reports markers that have no varying to pass.
void check_passthrough_markers(const CodeUnit& code, ShaderStage stage, Diagnostics& diagnostics);

struct PassedVarying {
  std::string qualifiers;  ///< `flat`, or empty.
  std::string type;
  std::string name;  ///< In front of the geometry stage.
};

/// Code that declares the varyings on both sides and fills the three geometry plugs with what passes them on.
std::string passthrough_text(std::span<const PassedVarying> varyings, int input_size);

}  // namespace plugc

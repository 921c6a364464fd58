#pragma once
// Old GLSL to the one dialect that plugc writes (GLSL 3.30 core, which ESSL 3.00 shares apart from its first lines).
// Works on tokens: `varying`, `attribute`, `texture2D(...)`, `shadow2DProj(...).r`, `gl_FragColor`, the fixed-function
// names. Sources: GLSL 1.20 and 3.30 specifications; castle_ names for what fixed-function names meant.

#include <string_view>
#include <vector>

#include "base/source.h"
#include "glsl/stage.h"
#include "glsl/tokens.h"

namespace plugc {

/// Names that an upgraded text uses and the composer must declare (castle_Vertex for gl_Vertex, ...), each once.
struct UpgradedText {
  MappedText text;
  std::vector<std::string_view> used_names;  ///< Static strings: castle_FragColor, castle_ModelViewMatrix, ...
};

/// - `varying` -> `out` (vertex) / `in` (fragment); `attribute` -> `in`
/// - `texture2D|3D|Cube`, `...Proj`, `...Lod`, `shadow1D|2D[Proj]` -> `texture`, `textureProj`, ...; a shadow call that is
///   followed by a swizzle, or whose result was a vec4, becomes `vec4(texture(...))`
/// - `gl_FragColor`, `gl_FragData[0]` -> `castle_FragColor`
/// - gl_Vertex, gl_Normal, gl_Color, gl_MultiTexCoordN, gl_TexCoord[N], gl_FrontColor, gl_ModelViewMatrix,
///   gl_ProjectionMatrix, gl_ModelViewProjectionMatrix, gl_NormalMatrix, gl_TextureMatrix[N], ftransform() -> castle_ names
/// - where a part has both an old texture call and a variable named `texture`, the variable becomes `texture_`
/// - a variable whose name has become a keyword or a built-in function is renamed with a trailing `_`
/// `#version`, `#extension` and `precision` stay where they are; the outline finds them and the composer hoists them.
UpgradedText upgrade(const MappedText& text, ShaderStage stage, std::span<const MacroDefinition> predefined);

}  // namespace plugc

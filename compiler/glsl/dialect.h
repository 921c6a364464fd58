#pragma once
// Old GLSL to the one dialect that plugc writes (GLSL 3.30 core, which ESSL 3.00 shares apart from its first lines).
// Works on tokens: `varying`, `attribute`, `texture2D(...)`, `shadow2DProj(...).r`, `gl_FragColor`, the fixed-function
// names. Sources: GLSL 1.20 and 3.30 specifications; castle_ names for what fixed-function names meant.

#include <span>
#include <string>
#include <vector>

#include "base/source.h"
#include "glsl/stage.h"
#include "glsl/tokens.h"

namespace plugc {

/// A name of the author's that could not stay: `texture` is now `texture_`.
struct RenamedName {
  std::string written;
  std::string renamed;
};

struct UpgradedText {
  MappedText text;
  /// Every castle_ name that the text now uses, each once: those that took the place of gl_ names
  /// (castle_Vertex for gl_Vertex) and the author's own. The composer must see to it that they are declared.
  std::vector<std::string> used_names;
  /// Each once. A uniform among them is still fed by the field of the written name.
  std::vector<RenamedName> renamed_names;
  /// The words of each parameter that had several directions, as `inout in vec3 normal`: places of the author's.
  std::vector<Span> merged_directions;
};

/// Live code, the bodies of macros and the arguments of markers are upgraded:
/// - `varying` -> `out` (vertex) / `in` (fragment); `attribute` -> `in` (vertex)
/// - `texture1D|2D|3D|Cube|Rect`, `...Proj`, `...Lod`, `...Grad` -> `texture`, `textureProj`, ...
/// - `shadow1D|2D[Proj]`, whose result was a vec4 -> `vec4(texture(...))`, `vec4(textureProj(...))`
/// - `gl_FragColor`, `gl_FragData[0]` -> `castle_FragColor`
/// - gl_Vertex, gl_Normal, gl_Color, gl_MultiTexCoordN, gl_TexCoord[N], gl_FrontColor, gl_ModelViewMatrix,
///   gl_ProjectionMatrix, gl_ModelViewProjectionMatrix, gl_NormalMatrix, gl_TextureMatrix[N], ftransform() -> castle_ names;
///   `varying vec4 gl_TexCoord[4];` goes
/// - where a part has both an old texture call and a variable named `texture`, or a global of that name, the variable
///   becomes `texture_`
/// - several directions of a parameter -> one: `inout in` -> `inout`, which some drivers take
/// - a name that has become a keyword since, or is one in some target, and a global or function named like a newer built-in
///   function, gets a trailing `_`, unless the text's own `#version` says that such words are meant (130 for most)
/// - a `\` at a line's end, which GLSL 3.30 lacks, goes together with the line end
/// A function or macro of the author's that is named like an old built-in function stays.
/// `#version`, `#extension` and `precision` stay where they are; the outline finds them and the composer hoists them.
UpgradedText upgrade(const MappedText& text, ShaderStage stage, std::span<const MacroDefinition> predefined);

}  // namespace plugc

#pragma once
// What a geometry shader says it takes and makes: `layout(triangles) in;`, `layout(points, max_vertices = 1) out;` (GLSL 3.30,
// clause 4.3.8). Internal to the compose room.

#include <optional>

#include "compose/code_unit.h"

namespace plugc {

/// `layout(triangles) in;`
struct InputLayout {
  TextRange range;
  std::string_view primitive;
  bool alone = false;  ///< It says nothing else, so that the head of the stage can say it in its place.
};

/// The first that names a primitive, be it through a macro.
std::optional<InputLayout> find_input_layout(const CodeUnit& code);
bool has_output_layout(const CodeUnit& code);

/// Vertices of an input primitive, which `primitive` names.
int input_size(std::string_view primitive);

}  // namespace plugc

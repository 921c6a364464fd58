#pragma once
// The stage on which effects without shapes are tried: a lit, shadowed shape above a floor.

#include <string>
#include <string_view>

namespace plugc {

/// Classic X3D statements to stand behind the author's own (so that no place of theirs moves). `name` is teapot, sphere,
/// box or plane. Group effects at the file's top level then reach the stage as they reach any shape.
std::string stage_statements(std::string_view name);

/// The same as XML, to stand in front of `</Scene>`.
std::string stage_elements(std::string_view name);

}  // namespace plugc

#pragma once
// The code of a Script, as a package holds it.

#include <cstdint>
#include <functional>
#include <memory>

#include "package/package_file.h"
#include "scene/scene.h"

namespace plugc {

/// All but the origin of the code. `line_of` says which line a place is on.
std::unique_ptr<PackedScriptT> pack_script(const ScriptProgram& program,
                                           const std::function<std::uint32_t(const Span&)>& line_of);

}  // namespace plugc

#pragma once
// The middle of the pipeline for a library: a file with effects and no shape. Each effect becomes a scene of its own, on the
// built-in stage (scene/library_stage.h), with a program for each kind of shape that its plugs can tell apart.

#include <vector>

#include "base/file_access.h"
#include "compose/compose.h"
#include "package/assemble_package.h"
#include "validate/validate_recipes.h"

namespace plugc {

/// One scene an effect, in the order of the file. `graph` holds the stage behind the library's own nodes.
std::vector<SceneParts> compile_library(const NodeGraph& graph, SourceSet& sources, FileAccess& files,
                                        const ProgramOptions& options, const ShadowDefaults& shadows, Validator& validator,
                                        Diagnostics& diagnostics, ValidationStatistics& statistics);

}  // namespace plugc

#pragma once
// Validated programs in packed form.

#include <memory>
#include <string>

#include "package/assemble_package.h"
#include "package/source_list.h"

namespace plugc {

/// A ValidRecipe that has at least one target.
std::unique_ptr<PackedProgramT> pack_program(const ValidRecipe& recipe, std::string name, SourceList& sources);
/// All that makes two programs the same program: targets, stages, texts, and which targets share a uniform.
std::string program_content(const ValidRecipe& recipe);

}  // namespace plugc

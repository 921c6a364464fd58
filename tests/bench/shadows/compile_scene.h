#pragma once
// Scene files to packages for the laboratory, by the compiler in this process.

#include <filesystem>
#include <string>
#include <vector>

#include "validate/validate.h"

namespace plugc {

/// The package's bytes; empty, with `error`, where the scene has mistakes. `method` is a name of the command line's
/// `--shadows`; empty: what the scene gets by itself.
std::vector<std::uint8_t> compile_scene(const std::filesystem::path& scene, const std::string& method, Validator& validator,
                                        std::string& error);

}  // namespace plugc

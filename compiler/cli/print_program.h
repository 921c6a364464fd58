#pragma once
// One program of a package as `plugc inspect --program` shows it: what it is for, what feeds it, what it costs, and its text
// with the origin of every line.

#include <string>

#include "compile.h"
#include "package/package_file.h"

namespace plugc {

/// `scene.x3dv:31`; "" for what nobody wrote.
std::string origin_text(const Package& package, const PackedLineOrigin& origin);
/// `costs` may be null: a package without its scene cannot be composed anew.
std::string program_text(const Package& package, std::size_t index, const ProgramCosts* costs);
/// The same as one JSON object.
std::string program_json(const Package& package, std::size_t index, const ProgramCosts* costs);
/// All programs as a JSON array.
std::string programs_json(const Package& package);

}  // namespace plugc

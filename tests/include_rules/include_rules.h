#pragma once
// The one-way rule, as a table: which room may include which, and which library belongs to one room alone. The build does
// not see a wrong include of a header that needs no linking; this does.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plugc {

/// A room and the rooms beside itself that it may include, blank-separated; all of them stand above it in the table.
struct RoomRule {
  std::string_view room;
  std::string_view may_include;
};
std::span<const RoomRule> room_rules();

/// Reads every C++ file below `tree`/compiler, /runtime and /stdlib_plugs. One line for each include that breaks the rule,
/// in the order of the files' names: "compiler/glsl/edit.cpp:3: `glsl` includes `scene/scene.h`; it may include only base".
std::vector<std::string> broken_includes(const std::filesystem::path& tree);

/// How many includes of rooms there are below `tree`, to tell a clean tree from one that was not found.
std::size_t count_includes(const std::filesystem::path& tree);

}  // namespace plugc

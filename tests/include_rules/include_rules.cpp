// Finds the includes of every file line by line, names the room of the file and the room of what it includes, and looks
// the pair up in the table. The room of a path is its longest prefix among kPrefixes; so package/package_file*, which the
// runtime shares, is a room of its own within `package`, and runtime/gl is one within `runtime`. An include in angle
// brackets is looked up in kLibraries: most libraries belong to one room.

#include "include_rules/include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::array kRooms = {
    RoomRule{"base", ""},
    RoomRule{"stdlib_plugs", ""},
    RoomRule{"document", "base"},
    RoomRule{"script", "base"},
    RoomRule{"scene", "base document script"},
    RoomRule{"mesh", "base scene"},
    RoomRule{"image", "base scene"},
    RoomRule{"glsl", "base"},
    RoomRule{"compose", "stdlib_plugs base document scene glsl"},
    RoomRule{"validate", "base document scene glsl compose"},
    RoomRule{"lint", "base document scene glsl compose validate"},
    RoomRule{"package_file", "base"},
    RoomRule{"package", "base document scene mesh image glsl compose validate package_file"},
    RoomRule{"compiler", "base document scene mesh image glsl compose validate lint package package_file"},
    RoomRule{"runtime/gl", "base package_file"},
    RoomRule{"runtime", "base package_file runtime/gl"},
    RoomRule{"runtime/measure", "base package_file runtime/gl runtime"},
    RoomRule{"cli",
             "base document scene mesh image glsl compose validate lint package package_file compiler runtime runtime/measure"},
};

struct Prefix {
  std::string_view path;
  std::string_view room;
};

// clang-format off

/// Paths from the top of the tree. A longer prefix stands before the one that it begins with.
constexpr std::array kPrefixes = {
    Prefix{"compiler/base/", "base"},
    Prefix{"compiler/document/", "document"},
    Prefix{"compiler/script/", "script"},
    Prefix{"compiler/scene/", "scene"},
    Prefix{"compiler/mesh/", "mesh"},
    Prefix{"compiler/image/", "image"},
    Prefix{"compiler/glsl/", "glsl"},
    Prefix{"compiler/compose/", "compose"},
    Prefix{"compiler/validate/", "validate"},
    Prefix{"compiler/lint/", "lint"},
    Prefix{"compiler/package/package_file", "package_file"},
    Prefix{"compiler/package/", "package"},
    Prefix{"compiler/cli/", "cli"},
    Prefix{"compiler/", "compiler"},
    Prefix{"runtime/gl/", "runtime/gl"},
    Prefix{"runtime/measure/", "runtime/measure"},
    Prefix{"runtime/", "runtime"},
    Prefix{"stdlib_plugs/", "stdlib_plugs"},
};

/// Headers of libraries that one room alone may include.
constexpr std::array kLibraries = {
    Prefix{"pugixml.hpp", "tests/bench"},
    Prefix{"embree3/", "runtime"},
    Prefix{"tiny_gltf.h", "document"},
    Prefix{"ft2build.h", "mesh"},
    Prefix{"png.h", "image"},
    Prefix{"jpeglib.h", "image"},
    Prefix{"jerror.h", "image"},
    Prefix{"gif_lib.h", "image"},
    Prefix{"glslang/", "validate"},
    Prefix{"SPIRV/", "validate"},
    Prefix{"spirv-tools/", "validate"},
    Prefix{"spirv_cross/", "validate"},
    Prefix{"flatbuffers/", "package_file"},
    Prefix{"GL/", "runtime/gl"},
    Prefix{"EGL/", "runtime/gl"},
    Prefix{"KHR/", "runtime/gl"},
    Prefix{"CLI/", "cli"},
    Prefix{"nlohmann/", "cli"},
};

// clang-format on

/// What the build makes; these stand in no folder of the tree.
constexpr std::array<std::string_view, 3> kGenerated = {"node_table_data.inc", "package_generated.h", "stdlib_data.inc"};

std::string_view room_of(std::string_view path, std::span<const Prefix> prefixes) {
  const auto found =
      std::find_if(prefixes.begin(), prefixes.end(), [&](const Prefix& one) { return path.starts_with(one.path); });
  return found == prefixes.end() ? "" : found->room;
}

/// A room writes its own headers and those of others as "room/header.h", from compiler/ or from the top of the tree.
std::string_view room_of_include(std::string_view name) {
  if (name.find("..") != std::string_view::npos) return "";
  const bool from_top = name.starts_with("runtime/") || name.starts_with("stdlib_plugs/");
  return room_of(from_top ? std::string(name) : "compiler/" + std::string(name), kPrefixes);
}

bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

std::string_view allowed_rooms(std::string_view room) {
  const auto found = std::find_if(kRooms.begin(), kRooms.end(), [&](const RoomRule& one) { return one.room == room; });
  return found == kRooms.end() ? "" : found->may_include;
}

struct Include {
  std::string_view name;
  bool angled = false;
};

/// `  #include "base/source.h"`; nothing for another line, and for an include whose name is a macro.
std::optional<Include> include_in(std::string_view line) {
  constexpr std::string_view kWord = "#include";
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || !line.substr(begin).starts_with(kWord)) return std::nullopt;
  const std::size_t open = line.find_first_of("\"<", begin + kWord.size());
  const std::size_t close = open == std::string_view::npos ? open : line.find_first_of("\">", open + 1);
  if (close == std::string_view::npos) return std::nullopt;
  return Include{line.substr(open + 1, close - open - 1), line[open] == '<'};
}

std::string quoted(std::string_view name) {
  return "`" + std::string(name) + "`";
}

/// What is wrong with the include, or "".
std::string complaint(std::string_view room, const Include& include) {
  const std::string says = quoted(room) + " includes " + quoted(include.name) + "; ";
  if (include.angled) {
    const std::string_view owner = room_of(include.name, kLibraries);
    return owner.empty() || owner == room ? "" : says + "only " + quoted(owner) + " may";
  }
  if (std::find(kGenerated.begin(), kGenerated.end(), include.name) != kGenerated.end()) return "";
  const std::string_view target = room_of_include(include.name);
  const std::string_view allowed = allowed_rooms(room);
  if (target.empty()) return says + "write it as `room/header.h`";
  if (target == room || has_word(allowed, target)) return "";
  return says + "it may include " + (allowed.empty() ? "no other room" : "only " + std::string(allowed));
}

std::vector<std::string> cpp_files(const fs::path& tree) {
  std::vector<std::string> files;
  for (const char* const top : {"compiler", "runtime", "stdlib_plugs"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / top)) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".h" || ending == ".cpp") files.push_back(entry.path().lexically_relative(tree).generic_string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Calls `visit(file, line number, include)` for every include of the tree.
template <typename Visitor>
void visit_includes(const fs::path& tree, Visitor visit) {
  for (const std::string& file : cpp_files(tree)) {
    std::ifstream stream(tree / file);
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
      if (const auto include = include_in(line)) visit(file, number, *include);
    }
  }
}

}  // namespace

std::span<const RoomRule> room_rules() {
  return kRooms;
}

std::vector<std::string> broken_includes(const fs::path& tree) {
  std::vector<std::string> broken;
  visit_includes(tree, [&](const std::string& file, std::size_t line, const Include& include) {
    const std::string what = complaint(room_of(file, kPrefixes), include);
    if (!what.empty()) broken.push_back(file + ":" + std::to_string(line) + ": " + what);
  });
  return broken;
}

std::size_t count_includes(const fs::path& tree) {
  std::size_t count = 0;
  visit_includes(tree, [&](const std::string&, std::size_t, const Include& include) { count += include.angled ? 0 : 1; });
  return count;
}

}  // namespace plugc

#pragma once
// What the parts of a dump share: one line a fact, and how values are written. Inner header of package_file_dump*.cpp.

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

#include "base/clean_text.h"
#include "package/package_file.h"

namespace plugc {

using Text = fmt::memory_buffer;

template <typename... Args>
void line(Text& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  text.push_back('\n');
}

/// In backticks, and on one line.
inline std::string quoted(const flatbuffers::String& string) {
  return fmt::format("`{}`", printable(string.string_view()));
}

inline std::string quoted(const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>& list) {
  std::string result;
  for (const auto* string : list) result.append(" ").append(quoted(*string));
  return result.empty() ? " none" : result;
}

template <typename Range>
std::string sized(const Range& data, std::string_view unit) {
  const std::size_t bytes = data.size() * sizeof(*data.data());
  return fmt::format("{} {}, hash {:016x}", data.size(), unit, XXH3_64bits(data.data(), bytes));
}

/// A type's name in the schema has a final `_` where C++ has that word already.
inline std::string_view word(const char* enumerator_name) {
  std::string_view name = enumerator_name;
  if (name.ends_with('_')) name.remove_suffix(1);
  return name;
}

inline std::string slot(std::uint32_t index) {
  return index == kNoSlot ? "-" : std::to_string(index);
}

inline std::string vec3(const PackedVec3& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

inline std::string slots(const flatbuffers::Vector<std::uint32_t>& list) {
  std::string text;
  for (const std::uint32_t index : list) text.append(" ").append(slot(index));
  return text;
}

inline std::string border(const PackedBorder* color) {
  if (color == nullptr) return "";
  return fmt::format(", border {:g} {:g} {:g} {:g}", color->red(), color->green(), color->blue(), color->alpha());
}

template <typename List, typename Function>
void each(const List& list, Function function) {
  for (flatbuffers::uoffset_t i = 0; i < list.size(); ++i) function(*list.Get(i), i);
}

void dump_scene(Text& text, const Package& package, const PackedScene& scene, std::size_t index);
void dump_shape(Text& text, const Package& package, const PackedShape& shape, std::size_t index);
/// What feeds the uniforms of a program.
void dump_bindings(Text& text, const flatbuffers::Vector<const PackedBinding*>& bindings, const PackedProgram& program);

// What changes while the scene is drawn.
void dump_events(Text& text, const PackedScene& scene);
void dump_live_mesh(Text& text, const PackedLiveMesh& live);
/// What is bound now, where that changes.
void dump_bindings_now(Text& text, const PackedScene& scene);

// Views beside the picture's.
void dump_rendered_texture(Text& text, const PackedRenderedTexture& texture, std::size_t index);
void dump_screen_effect(Text& text, const Package& package, const PackedScreenEffect& effect, std::size_t index);

}  // namespace plugc

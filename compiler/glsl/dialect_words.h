#pragma once
// Which words changed between GLSL 1.10 and 3.30, as tables, and which that are still names there a target refuses.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "glsl/stage.h"

namespace plugc {

/// A texture look-up of old GLSL, in the words of 3.30.
struct TextureCall {
  std::string name;            ///< `texture`, `textureProjLod`, ...
  bool returned_vec4 = false;  ///< A shadow look-up, which returns a float now.
};
/// For `texture2D`, `shadow2DProj`, `textureCubeLod`, `texture2DGradARB`, ...
std::optional<TextureCall> upgraded_texture_call(std::string_view word);

/// What `gl_Vertex` and the like became: a castle_ name, without index. Empty for all other words.
std::string_view castle_name(std::string_view gl_word, ShaderStage stage);
/// For `gl_TexCoord[N]` and `gl_TextureMatrix[N]`: the castle_ name that N is appended to. Empty for all other words.
std::string_view indexed_castle_name(std::string_view gl_word);

/// How a word of 3.30 may be told from an author's name of the same spelling.
enum class NewWord : std::uint8_t {
  none,       ///< It was no name to take, or still is one.
  reserved,   ///< Has no meaning in 3.30 or ESSL 3.00, but may not be used.
  qualifier,  ///< As a keyword it stands before another word or a bracket.
  keyword,    ///< A type or statement: as a keyword it never follows a type.
};
NewWord new_word(std::string_view word);
/// The version of GLSL from which on the word is none to take: 130 for most. Those of a later one are names in GLSL 3.30, and
/// ESSL 3.00 reserves them (`shared` glslang reserves in both, though neither does).
int new_word_version(std::string_view word);

/// A function that became built-in after 1.20.
bool is_new_builtin_function(std::string_view word);
/// A function that is built into ESSL 3.00.
bool is_builtin_function(std::string_view word);

}  // namespace plugc

// Texture look-ups are taken apart by prefix, dimension, variant and vendor, as their names were built; all other words are
// found in sorted tables. Sources: GLSL 1.20 clauses 3.6, 7 and 8; GLSL 3.30 clauses 3.6 and 8; ESSL 3.00 clause 3.7.

#include "glsl/dialect_words.h"

#include <algorithm>
#include <array>

namespace plugc {
namespace {

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

// Longer names first, so that `1DArray` is not taken for `1D`.
constexpr std::array<std::string_view, 8> kDimensions = {"1DArray", "2DArray", "2DRect", "1D", "2D", "3D", "Cube", "Rect"};
constexpr std::array<std::string_view, 6> kVariants = {"", "Proj", "Lod", "ProjLod", "Grad", "ProjGrad"};

struct CastleName {
  std::string_view gl_word;
  std::string_view castle_word;
};
constexpr std::array kCastleNames = {
    CastleName{"gl_FragColor", "castle_FragColor"},
    CastleName{"gl_FrontColor", "castle_Color"},
    CastleName{"gl_ModelViewMatrix", "castle_ModelViewMatrix"},
    CastleName{"gl_MultiTexCoord0", "castle_MultiTexCoord0"},
    CastleName{"gl_MultiTexCoord1", "castle_MultiTexCoord1"},
    CastleName{"gl_MultiTexCoord2", "castle_MultiTexCoord2"},
    CastleName{"gl_MultiTexCoord3", "castle_MultiTexCoord3"},
    CastleName{"gl_MultiTexCoord4", "castle_MultiTexCoord4"},
    CastleName{"gl_MultiTexCoord5", "castle_MultiTexCoord5"},
    CastleName{"gl_MultiTexCoord6", "castle_MultiTexCoord6"},
    CastleName{"gl_MultiTexCoord7", "castle_MultiTexCoord7"},
    CastleName{"gl_Normal", "castle_Normal"},
    CastleName{"gl_NormalMatrix", "castle_NormalMatrix"},
    CastleName{"gl_ProjectionMatrix", "castle_ProjectionMatrix"},
    CastleName{"gl_Vertex", "castle_Vertex"},
};
static_assert(std::ranges::is_sorted(kCastleNames, {}, &CastleName::gl_word));

struct WordKind {
  std::string_view word;
  NewWord kind;
  int version = 130;
};
using enum NewWord;
constexpr std::array kNewWords = {
    WordKind{"active", reserved},
    WordKind{"atomic_uint", keyword, 420},
    WordKind{"case", keyword},
    WordKind{"centroid", qualifier},
    WordKind{"coherent", reserved, 420},
    WordKind{"common", reserved},
    WordKind{"filter", reserved},
    WordKind{"flat", qualifier},
    WordKind{"highp", qualifier},
    WordKind{"layout", qualifier},
    WordKind{"lowp", qualifier},
    WordKind{"mediump", qualifier},
    WordKind{"noperspective", qualifier},
    WordKind{"partition", reserved},
    WordKind{"patch", qualifier, 400},
    WordKind{"readonly", reserved, 420},
    WordKind{"resource", reserved, 420},
    WordKind{"restrict", reserved, 420},
    WordKind{"sample", qualifier, 400},
    WordKind{"shared", keyword, 430},
    WordKind{"smooth", qualifier},
    WordKind{"subroutine", reserved, 400},
    WordKind{"uint", keyword},
    WordKind{"uvec2", keyword},
    WordKind{"uvec3", keyword},
    WordKind{"uvec4", keyword},
    WordKind{"writeonly", reserved, 420},
};
static_assert(std::ranges::is_sorted(kNewWords, {}, &WordKind::word));

// For each first byte the lengths of the new words that start with it, as bits: one look turns away nearly every name.
constexpr std::array<std::uint32_t, 256> kNewWordLengths = [] {
  std::array<std::uint32_t, 256> lengths{};
  for (const WordKind& each : kNewWords) lengths[static_cast<unsigned char>(each.word[0])] |= 1U << each.word.size();
  return lengths;
}();

const WordKind* find_new_word(std::string_view word) {
  constexpr std::size_t kLongest = 31;
  if (word.empty() || word.size() > kLongest) return nullptr;
  if ((kNewWordLengths[static_cast<unsigned char>(word[0])] >> word.size() & 1U) == 0) return nullptr;
  const auto found = std::ranges::lower_bound(kNewWords, word, {}, &WordKind::word);
  return found != kNewWords.end() && found->word == word ? &*found : nullptr;
}

constexpr std::array<std::string_view, 31> kNewBuiltins = {
    "acosh",
    "asinh",
    "atanh",
    "cosh",
    "determinant",
    "floatBitsToInt",
    "floatBitsToUint",
    "intBitsToFloat",
    "inverse",
    "isinf",
    "isnan",
    "modf",
    "outerProduct",
    "round",
    "roundEven",
    "sinh",
    "tanh",
    "texelFetch",
    "texelFetchOffset",
    "texture",
    "textureGrad",
    "textureLod",
    "textureLodOffset",
    "textureOffset",
    "textureProj",
    "textureProjGrad",
    "textureProjLod",
    "textureSize",
    "transpose",
    "trunc",
    "uintBitsToFloat",
};
static_assert(std::ranges::is_sorted(kNewBuiltins));

// Of ESSL 3.00, clause 8, beside those of kNewBuiltins.
constexpr std::array<std::string_view, 58> kOldBuiltins = {
    "abs",
    "acos",
    "all",
    "any",
    "asin",
    "atan",
    "ceil",
    "clamp",
    "cos",
    "cross",
    "dFdx",
    "dFdy",
    "degrees",
    "distance",
    "dot",
    "equal",
    "exp",
    "exp2",
    "faceforward",
    "floor",
    "fract",
    "fwidth",
    "greaterThan",
    "greaterThanEqual",
    "inversesqrt",
    "length",
    "lessThan",
    "lessThanEqual",
    "log",
    "log2",
    "matrixCompMult",
    "max",
    "min",
    "mix",
    "mod",
    "normalize",
    "not",
    "notEqual",
    "packHalf2x16",
    "packSnorm2x16",
    "packUnorm2x16",
    "pow",
    "radians",
    "reflect",
    "refract",
    "sign",
    "sin",
    "smoothstep",
    "sqrt",
    "step",
    "tan",
    "textureGradOffset",
    "textureProjGradOffset",
    "textureProjLodOffset",
    "textureProjOffset",
    "unpackHalf2x16",
    "unpackSnorm2x16",
    "unpackUnorm2x16",
};
static_assert(std::ranges::is_sorted(kOldBuiltins));

}  // namespace

std::optional<TextureCall> upgraded_texture_call(std::string_view word) {
  const bool shadow = take_prefix(word, "shadow");
  if (!shadow && !take_prefix(word, "texture")) return std::nullopt;
  const auto dimension = std::ranges::find_if(kDimensions, [&](std::string_view each) { return take_prefix(word, each); });
  if (dimension == kDimensions.end()) return std::nullopt;
  const bool extension = word.ends_with("EXT");
  if (extension || word.ends_with("ARB")) word.remove_suffix(3);
  if (std::ranges::find(kVariants, word) == kVariants.end()) return std::nullopt;
  // EXT_shadow_samplers, the one form that returned a float all along.
  const bool returned_float = extension && (word.empty() || word == "Proj");
  return TextureCall{"texture" + std::string(word), shadow && !returned_float};
}

std::string_view castle_name(std::string_view gl_word, ShaderStage stage) {
  if (gl_word == "gl_Color" && stage == ShaderStage::vertex) return "castle_ColorPerVertex";
  if (gl_word == "gl_Color" && stage == ShaderStage::fragment) return "castle_Color";
  const auto found = std::ranges::lower_bound(kCastleNames, gl_word, {}, &CastleName::gl_word);
  return found != kCastleNames.end() && found->gl_word == gl_word ? found->castle_word : std::string_view{};
}

std::string_view indexed_castle_name(std::string_view gl_word) {
  if (gl_word == "gl_TexCoord") return "castle_TexCoord";
  return gl_word == "gl_TextureMatrix" ? "castle_TextureMatrix" : std::string_view{};
}

NewWord new_word(std::string_view word) {
  const WordKind* found = find_new_word(word);
  return found == nullptr ? none : found->kind;
}

int new_word_version(std::string_view word) {
  const WordKind* found = find_new_word(word);
  return found == nullptr ? 0 : found->version;
}

bool is_new_builtin_function(std::string_view word) {
  return std::ranges::binary_search(kNewBuiltins, word);
}

bool is_builtin_function(std::string_view word) {
  return is_new_builtin_function(word) || std::ranges::binary_search(kOldBuiltins, word);
}

}  // namespace plugc

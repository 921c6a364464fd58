// A table sorted by name, searched by bisection.

#include "glsl/qualifiers.h"

#include <algorithm>
#include <array>

namespace plugc {
namespace {

struct Qualifier {
  std::string_view word;
  QualifierKind kind;
};
using enum QualifierKind;
constexpr std::array kQualifiers = {
    Qualifier{"attribute", storage},
    Qualifier{"buffer", storage},
    Qualifier{"centroid", interpolation},
    Qualifier{"coherent", memory},
    Qualifier{"const", storage},
    Qualifier{"flat", interpolation},
    Qualifier{"highp", precision},
    Qualifier{"in", storage},
    Qualifier{"inout", storage},
    Qualifier{"invariant", interpolation},
    Qualifier{"layout", layout},
    Qualifier{"lowp", precision},
    Qualifier{"mediump", precision},
    Qualifier{"noperspective", interpolation},
    Qualifier{"out", storage},
    Qualifier{"patch", interpolation},
    Qualifier{"precise", interpolation},
    Qualifier{"readonly", memory},
    Qualifier{"restrict", memory},
    Qualifier{"sample", interpolation},
    Qualifier{"shared", storage},
    Qualifier{"smooth", interpolation},
    Qualifier{"uniform", storage},
    Qualifier{"varying", storage},
    Qualifier{"volatile", memory},
    Qualifier{"writeonly", memory},
};
static_assert(std::ranges::is_sorted(kQualifiers, {}, &Qualifier::word));

}  // namespace

QualifierKind qualifier_kind(std::string_view word) {
  const auto found = std::ranges::lower_bound(kQualifiers, word, {}, &Qualifier::word);
  return found != kQualifiers.end() && found->word == word ? found->kind : none;
}

bool is_basic_type(std::string_view word) {
  constexpr std::string_view kStems[] = {"float", "int",  "uint", "bool", "void", "vec",
                                         "ivec",  "uvec", "bvec", "mat",  "dvec", "dmat"};
  if (word.starts_with("sampler") || word.starts_with("isampler") || word.starts_with("usampler")) return true;
  const std::string_view stem = word.substr(0, word.find_first_of("23456789"));
  const std::string_view size = word.substr(stem.size());
  const bool plain = stem == "float" || stem == "int" || stem == "uint" || stem == "bool" || stem == "void";
  const bool sized = size.size() == 1 || (size.size() == 3 && size[1] == 'x');
  return std::ranges::find(kStems, stem) != std::end(kStems) && (plain ? size.empty() : sized);
}

}  // namespace plugc

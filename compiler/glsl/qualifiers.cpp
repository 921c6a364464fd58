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

}  // namespace plugc

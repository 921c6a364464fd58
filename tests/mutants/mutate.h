#pragma once
// One token of shader code deleted, written twice or changed.

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "mutants/check_scene.h"

namespace plugc::mutants {

enum class MutationKind : std::uint8_t { deleted, repeated, changed };

struct Mutation {
  MutationKind kind = MutationKind::deleted;
  Span token;                ///< In the unchanged source.
  std::string replacement;   ///< What stands there now.
  std::string changed_text;  ///< The whole source with it.
};

/// Where a part's tokens stand in its source: live ones, and those of directives. Tokens that are written with escapes, which
/// stand nowhere byte for byte, are left out.
std::vector<Span> token_places(const CheckedScene& scene, const Author& author);

/// `places` is not empty. The same generator makes the same mutation on every machine.
Mutation mutate(const SourceSet& sources, const std::vector<Span>& places, std::mt19937& random);

}  // namespace plugc::mutants

#pragma once
// The words that may stand before a type. Sources: GLSL 1.20 clause 4.3, GLSL 3.30 clauses 4.3 to 4.7.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace plugc {

enum class QualifierKind : std::uint8_t {
  none,           ///< Not a qualifier.
  storage,        ///< `in`, `uniform`, `varying`, ...
  interpolation,  ///< `flat`, `centroid`, `invariant`, ...: kept as written.
  precision,      ///< `highp`, ...
  memory,         ///< `readonly`, ...: passed over.
  layout,         ///< With brackets.
};

QualifierKind qualifier_kind(std::string_view word);

/// `float`, `ivec3`, `mat2x4`, `samplerCube`, ...: a type that the language brings along, whose name nothing else can have.
bool is_basic_type(std::string_view word);

}  // namespace plugc

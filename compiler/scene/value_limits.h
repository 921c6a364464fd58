#pragma once
// What the node table says of a field's values beyond their type: a range for numbers, a list of words for strings.

#include <optional>
#include <span>
#include <string>

#include "base/diagnostics.h"
#include "scene/field_values.h"

namespace plugc {

/// The first number out of the field's range, and what to say of it and those behind it.
struct OutOfRange {
  std::size_t index = 0;
  std::string message;
};
std::optional<OutOfRange> find_out_of_range(const ValueContract& contract, std::span<const double> numbers);

/// Reports (field_value) each string that is none of the field's words.
void check_words(const ValueContract& contract, const Span& value, std::span<const MappedText> strings,
                 Diagnostics& diagnostics);

}  // namespace plugc

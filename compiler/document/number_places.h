#pragma once
// Places of single numbers. A Document keeps the place of a value only: numbers are many, and few of them are spoken of.

#include "document/document.h"

namespace plugc {

/// Where the number or boolean with that index stands in `value`, which holds numbers, booleans or the text of such; the
/// whole value where that cannot be told.
Span number_span(const ValueSyntax& value, const Document& document, const SourceSet& sources, std::size_t index);

}  // namespace plugc

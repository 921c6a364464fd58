#pragma once
// What attribute values and text of XML say once decoded, place by place.

#include "document/document_builder.h"

namespace plugc {

/// Replaces `&lt;`, `&#10;` and their kind, and CR LF by LF, in what the file holds at `span`. An entity that XML does not
/// define is reported and kept as it is.
MappedText decode_xml(const Span& span, DocumentBuilder& builder);

}  // namespace plugc

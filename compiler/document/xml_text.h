#pragma once
// What pugixml does not tell: where elements end, and what attribute values say once decoded, place by place.

#include <string_view>
#include <vector>

#include "document/document_builder.h"

namespace plugc {

/// An element from its `<` to behind its last `>`; one that is never closed ends with the text.
struct XmlExtent {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

struct XmlExtents {
  std::vector<XmlExtent> elements;     ///< By `begin`.
  std::vector<std::string_view> open;  ///< Names that are open where the scan stopped, outermost first.
};

/// Scans the tags of `text` up to `end`. Stray end tags are passed over: pugixml reports what is not well-formed.
XmlExtents find_xml_extents(std::string_view text, std::size_t end);

/// Replaces `&lt;`, `&#10;` and their kind, and CR LF by LF, in what the file holds at `span`. An entity that XML does not
/// define is reported and kept as it is.
MappedText decode_xml(const Span& span, DocumentBuilder& builder);

}  // namespace plugc

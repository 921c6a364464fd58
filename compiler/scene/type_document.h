#pragma once
// A document as its writers want it: every value of the kind that its field has, whatever the encoding looked like.

#include "document/document.h"

namespace plugc {

/// Types the values of a document by the node table, by the interfaces that nodes declare and by the prototypes in scope, and
/// makes one form of what the encodings write differently:
///
/// - no value is lexical: `size="1 2 3"` is three numbers, as in `size 1 2 3`; lists (MF) are bracketed, other values are not;
/// - no field lacks a name: child elements of XML stand in fields, `containerField` only where the field is not the one that
///   the node would go to by itself; a USE and the ProtoInstance of a USE carry the type of their node, where it is known;
/// - in a node plain values come first, then nodes, then IS; prototypes before routes;
/// - code is in `cdata` where it is the last url (`data:text/plain,...`, `ecmascript:...`) or stands inside the element;
/// - VRML 2.0 becomes X3D 3.0, and a field goes by its name in X3D, not by that in VRML: `choice` of a Switch is `children`.
///
/// Nothing is reported: what does not fit its type is kept as text, and the values of unknown fields as what they look like
/// (whether they were bracketed only the classic encoding tells). Of the fields of a node that are empty on purpose (`NULL`,
/// `[ ]`) nothing is dropped.
Document type_document(Document document);

}  // namespace plugc

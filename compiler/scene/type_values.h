#pragma once
// One value of a document as its field's type wants it; for type_document.

#include "document/document.h"
#include "scene/node_table.h"

namespace plugc {

/// Gives a value its kind: text becomes numbers, booleans or strings, lists (MF) and only they are bracketed, an empty list of
/// nodes is of the kind `nodes` and another one `empty`. What does not fit stays what it is, text as one string. With `unknown`
/// a text of XML is taken for what it looks like. Nodes inside are not looked at.
void type_value(Document& document, ValueSyntax& value, FieldType type);

}  // namespace plugc

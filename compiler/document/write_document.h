#pragma once
// A Document as text again, in any encoding. What is written reads as the same document, comments and places aside.
//
// The writers know no node: they want values of the kinds that their fields have, as type_document() of the scene room makes
// them. Where an encoding has no words for something, the nearest is written:
//
// - classic: a name with characters that no name may hold (`a b`) gets their codes (`a_x20_b`); a carriage return in a
//   string becomes a line feed; code beside a `url IS ...` is lost; an interface field without a value gets its type's usual.
// - XML: control characters (but tab, line feed, carriage return) become U+FFFD; `NULL` and `[ ]` in a field of a node is
//   left out, because that is what the field holds then; the value of an unknown field reads as what it looks like.
// - JSON: the character NUL becomes U+FFFD; `[ ]` in the `children` of a node that holds routes or prototypes is left out.

#include <string>

#include "document/document.h"

namespace plugc {

/// In the encoding named (classic for VRML 2.0, which type_document() makes X3D).
std::string write_document(const Document& document, Encoding as);

/// `#X3D V3.3 utf8`. Code (NodeSyntax::cdata) becomes the last url, `data:text/plain,` in front of it if it is no script.
std::string write_classic(const Document& document);

/// Code in CDATA; nodes as child elements, with `containerField` where NodeSyntax has one.
std::string write_xml(const Document& document);

/// `{"X3D": {"Scene": {"-children": [...]}}}`; code in `#sourceCode`, line by line.
std::string write_json(const Document& document);

}  // namespace plugc

#pragma once
// Text to Document. Mistakes are reported and reading goes on behind them; there is always a Document.

#include "base/diagnostics.h"
#include "document/document.h"

namespace plugc {

/// Tells the encoding by content (`#X3D`, `#VRML V2.0`, `#VRML V1.0`, `<`, `{`), whatever the name says, and reads it.
/// A text in no known encoding gets one diagnostic and an empty Document.
/// Source: ISO/IEC 19776-1 (XML), 19776-2 (classic), 19776-5 (JSON), 14772-1 (VRML 2.0).
Document read_document(SourceId source, const SourceSet& sources, Diagnostics& diagnostics);

/// Whether a text begins as classic X3D or VRML of any version does, in letters of either case; as VRML 1.0 does.
bool is_classic_header(std::string_view text);
bool is_vrml1_header(std::string_view text);

/// Classic X3D (`#X3D V3.2 utf8`) and VRML 2.0; they differ in the words for access types only.
Document read_classic(SourceId source, const SourceSet& sources, Diagnostics& diagnostics);

/// VRML 1.0 as the nodes of X3D that mean the same. What X3D cannot say of it is noted (`not-drawn`).
Document read_vrml1(SourceId source, const SourceSet& sources, Diagnostics& diagnostics);

/// XML X3D. Entities of the XML standard only; no DTD is read.
Document read_xml(SourceId source, const SourceSet& sources, Diagnostics& diagnostics);

/// JSON X3D. Comments and other liberties that RFC 8259 does not grant are reported and understood.
Document read_json(SourceId source, const SourceSet& sources, Diagnostics& diagnostics);

/// The X3D word: `inputOutput`, ...
std::string_view to_text(AccessType access);

/// `plugc inspect --dump document`: one line a node, field and statement, with places.
std::string dump_document(const Document& document, const SourceSet& sources);

}  // namespace plugc

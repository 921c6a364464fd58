#pragma once
// Reads a text and gives back what a test compares: the dump, or all messages.

#include <string>

#include "document/read_document.h"

namespace plugc {

struct Reading {
  SourceSet sources;
  SourceId source;
  Diagnostics diagnostics{sources};
  Document document;

  explicit Reading(std::string text) : source(sources.add("s", std::move(text))) {
    document = read_document(source, sources, diagnostics);
  }
  Reading(const Reading&) = delete;

  std::string dump() const { return dump_document(document, sources); }

  /// `line:column length message` of each diagnostic.
  std::string messages() const {
    std::string all;
    for (const Diagnostic& one : diagnostics.all()) {
      const Position at = sources.position(one.span.source, one.span.begin);
      all += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + std::to_string(one.span.end - one.span.begin) +
             " " + one.message + "\n";
    }
    return all;
  }
};

/// The dump of a text that must have no mistake.
inline std::string dump_of(const std::string& text) {
  const Reading reading(text);
  return reading.messages() + reading.dump();
}

inline std::string messages_of(const std::string& text) {
  return Reading(text).messages();
}

/// A classic text behind its header, which is line 1.
inline std::string classic(const std::string& body) {
  return "#X3D V3.3 utf8\n" + body;
}

/// An XML scene; the body begins in line 2.
inline std::string xml(const std::string& body) {
  return "<X3D version='3.3'><Scene>\n" + body + "\n</Scene></X3D>";
}

}  // namespace plugc

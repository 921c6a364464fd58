// The first characters tell the encoding, as its standard demands of them: `#X3D`, `#VRML V2.0`, `#VRML V1.0`, a tag,
// or a brace.
// What plugc does not read is named where that is known, so that the author learns what to convert.

#include "document/read_document.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace plugc {
namespace {

constexpr std::size_t kLooksAt = 1024;

bool is_binary(std::string_view text) {
  return text.substr(0, kLooksAt).find('\0') != std::string_view::npos;
}

/// Whether the text begins like a page of the web.
bool is_html(std::string_view text) {
  std::string start(text.substr(0, kLooksAt));
  std::transform(start.begin(), start.end(), start.begin(), [](unsigned char c) { return std::tolower(c); });
  return start.starts_with("<!doctype html") || start.starts_with("<html");
}

std::string_view unreadable_because(std::string_view text) {
  if (is_html(text)) return "this is an HTML page; plugc reads X3D and VRML";
  if (text.starts_with("\x1F\x8B")) return "this file is compressed; unpack it with `gunzip` first";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "this text is in UTF-16; save it as UTF-8";
  if (text.empty()) return "this file is empty";
  if (text.starts_with("#Inventor")) return "this is an Open Inventor file; plugc reads X3D and VRML";
  if (is_binary(text)) return "this file is no text; plugc reads X3D and VRML";
  return "a scene begins with `#X3D V3.3 utf8`, `#VRML V2.0 utf8`, an XML tag or `{`; this text does not";
}

}  // namespace

Document read_document(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  std::string_view text = sources.text(source);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (is_vrml1_header(text)) return read_vrml1(source, sources, diagnostics);
  if (is_classic_header(text)) return read_classic(source, sources, diagnostics);
  const std::string_view content = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (content.starts_with('<') && !is_html(content)) return read_xml(source, sources, diagnostics);
  if (content.starts_with('{')) return read_json(source, sources, diagnostics);

  const auto begin = static_cast<std::uint32_t>(sources.text(source).size() - content.size());
  const auto line = static_cast<std::uint32_t>(std::min(content.find_first_of("\r\n"), content.size()));
  diagnostics.report(DiagnosticId::encoding_unknown, {source, begin, begin + line}, std::string(unreadable_because(content)));
  Document empty;
  empty.source = source;
  return empty;
}

}  // namespace plugc

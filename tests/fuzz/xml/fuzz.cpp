// Any bytes as an XML file, and its decoded attributes as numbers and strings.

#include <cstdint>

#include "../classic/check_document.h"
#include "document/read_lexical.h"

namespace {

plugc::Document read_with_values(plugc::SourceId source, const plugc::SourceSet& sources, plugc::Diagnostics& diagnostics) {
  plugc::Document document = plugc::read_xml(source, sources, diagnostics);
  for (const plugc::MappedText& text : document.strings) {
    plugc::read_lexical_numbers(text, plugc::LexicalKind::numbers, diagnostics);
    plugc::read_lexical_numbers(text, plugc::LexicalKind::booleans, diagnostics);
    plugc::read_lexical_strings(text, diagnostics);
  }
  return document;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plugc::read_and_check(std::string(reinterpret_cast<const char*>(data), size), read_with_values);
  return 0;
}

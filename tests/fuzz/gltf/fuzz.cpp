// Any bytes as a .gltf or .glb file, with a buffer beside it.

#include <cstdint>

#include "../classic/check_document.h"
#include "document/read_gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plugc;
  SourceSet sources;
  Diagnostics diagnostics(sources);
  MemoryFiles files;
  files.files["a.bin"] = std::string(256, '\x3e');
  const SourceId source = sources.add("fuzz.gltf", std::string(reinterpret_cast<const char*>(data), size));
  const Document document = read_gltf(source, "fuzz.gltf", files, sources, diagnostics);
  DocumentCheck{document, sources}.all();
  for (const Diagnostic& one : diagnostics.all()) {
    if (one.span.valid()) PLUGC_CHECK(!to_text(one, sources).empty(), "a message has words");
  }
  return dump_document(document, sources).empty() ? 1 : 0;
}

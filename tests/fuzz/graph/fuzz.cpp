// Classic text to a graph. The text may be divided by lines `==== NAME` into files that the first one includes.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/file_access.h"
#include "document/read_document.h"
#include "scene/node_graph.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plugc;
  constexpr std::string_view kMark = "\n==== ";
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  MemoryFiles files;
  std::string name = "scene.x3dv";
  while (true) {
    const std::size_t mark = rest.find(kMark);
    files.files[name] = rest.substr(0, mark);
    if (mark == std::string_view::npos) break;
    rest.remove_prefix(mark + kMark.size());
    const std::size_t line = std::min(rest.find('\n'), rest.size());
    name = rest.substr(0, line);
    rest.remove_prefix(std::min(line + 1, rest.size()));
  }
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const SourceId source = sources.add("scene.x3dv", files.files["scene.x3dv"]);
  Document document = read_document(source, sources, diagnostics);
  const NodeGraph graph = build_graph(std::move(document), "scene.x3dv", sources, files, diagnostics);
  return dump_graph(graph, sources).empty() ? 1 : 0;
}

// Writes a measured scene, or reads one and prints the peak of this process's memory in bytes: what reading takes, without
// the text of a dump. tests/bench/run starts it once for each number that it needs.
//
//     peak_memory write numbers|nodes classic|xml|json BYTES FILE
//     peak_memory document|graph FILE

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "document/read_document.h"
#include "read_scenes.h"
#include "scene/node_graph.h"

namespace {

using namespace plugc;

int write_scene(const std::string& kind, const std::string& encoding_name, std::size_t bytes, const char* path) {
  const Encoding encoding = encoding_name == "xml"    ? Encoding::xml
                            : encoding_name == "json" ? Encoding::json
                                                      : Encoding::classic;
  std::ofstream(path) << (kind == "numbers" ? numbers_scene(encoding, bytes) : nodes_scene(encoding, bytes));
  return EXIT_SUCCESS;
}

/// The high-water mark of this program alone: getrusage's starts with that of the process that started it.
std::size_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

int read_scene(bool graph, const char* path) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  DiskFiles files("");
  const SourceId source = sources.add(path, files.read(path).bytes);
  Document document = read_document(source, sources, diagnostics);
  NodeGraph built;
  if (graph) built = build_graph(std::move(document), path, sources, files, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) std::cerr << to_text(diagnostic, sources);
  std::cout << peak_bytes() << "\n";
  return diagnostics.all().empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  if (verb == "write" && argc == 6) return write_scene(argv[2], argv[3], std::stoul(argv[4]), argv[5]);
  if ((verb == "document" || verb == "graph") && argc == 3) return read_scene(verb == "graph", argv[2]);
  std::cerr << "see the head of peak_memory.cpp\n";
  return EXIT_FAILURE;
}

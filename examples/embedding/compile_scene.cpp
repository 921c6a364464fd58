// A program that holds plugc's compiler: a scene in, its messages on stderr, a package out. docs/embedding.md goes through it.
//
//     compile_scene examples/first_light/first_light.x3dv light.plugpack

#include <cstdio>
#include <fstream>
#include <vector>

#include "compile.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: compile_scene SCENE PACKAGE\n");
    return 2;
  }
  plugc::Validator validator({});  // forks: before any thread is started
  plugc::SourceSet sources;
  plugc::Diagnostics diagnostics(sources);
  plugc::CompileOptions options;
  options.dynamic = {"Rim.enabled", "Rings.ring_count"};
  const plugc::Compilation made = plugc::compile({argv[1]}, options, validator, sources, diagnostics);
  for (const plugc::Diagnostic& said : diagnostics.all()) {
    std::fprintf(stderr, "%s\n", plugc::to_text(said, sources).c_str());
  }
  const std::vector<std::uint8_t> bytes = plugc::write_package(made.package);  // with errors: what could be made
  std::ofstream stream(argv[2], std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return diagnostics.has_errors() || !stream.flush() ? 1 : 0;
}

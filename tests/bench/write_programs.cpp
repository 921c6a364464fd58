// write_programs OUT SCENE...: every program that `plugc lint` has validated for these scenes, as files that glslangValidator
// takes: OUT/N.vert, OUT/N.frag and where there is one OUT/N.geom.

#include <filesystem>
#include <fstream>
#include <string>

#include "compile.h"

namespace {

const char* ending(plugc::PackedStageKind stage) {
  constexpr const char* kEndings[] = {".vert", ".geom", ".frag"};
  return kEndings[static_cast<std::size_t>(stage)];
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path out = argc > 1 ? argv[1] : ".";
  std::filesystem::create_directories(out);
  plugc::Validator validator({});
  plugc::CompileOptions options;
  options.for_lint = true;
  options.stage = "teapot";
  int number = 0;
  for (int i = 2; i < argc; ++i) {
    plugc::SourceSet sources;
    plugc::Diagnostics diagnostics(sources);
    const plugc::Compilation made = plugc::compile({argv[i]}, options, validator, sources, diagnostics);
    for (const auto& program : made.package.programs) {
      if (program->targets.empty()) continue;
      for (const auto& stage : program->targets.front()->stages)
        std::ofstream(out / (std::to_string(number) + ending(stage->kind)), std::ios::binary) << stage->text;
      ++number;
    }
  }
  return 0;
}

// Every scene of the corpus that has shaders: its programs are valid for both dialects of GLSL, and the renderer's driver
// compiles and links them without a word. And of every scene lint says the same as compiling all of it. Where the corpus does
// not lie beside the checkout, this is skipped.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

/// Scenes whose own code is not legal: what they show is that plugc says so.
const std::set<std::string> kIllegal = {"compositing_shaders/warnings/invalid_effects.x3dv"};  // a collection of mistakes

fs::path corpus() {
  return fs::path(PLUGC_SOURCE_DIR "/../shared/corpus/scenes").lexically_normal();
}

bool has_shaders(const fs::path& scene) {
  std::ifstream stream(scene, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return text.find("EffectPart") != std::string::npos || text.find("ShaderPart") != std::string::npos;
}

std::vector<std::string> scenes_with(bool (*wanted)(const fs::path&)) {
  std::vector<std::string> scenes;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(corpus(), missing)) {
    const fs::path ending = entry.path().extension();
    const bool is_scene = ending == ".x3dv" || ending == ".x3d" || ending == ".wrl";
    if (is_scene && wanted(entry.path())) scenes.push_back(entry.path().lexically_relative(corpus()).string());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

/// Errors that concern shader code; what else plugc cannot read or draw of a scene is no matter here.
std::vector<std::string> shader_errors(const Compiled& compiled) {
  std::vector<std::string> errors;
  for (const Diagnostic& said : compiled.diagnostics->all()) {
    const DiagnosticKind& kind = diagnostic_kind(said.id);
    const bool of_code = kind.code.starts_with("effect-") || kind.code.starts_with("shader-") ||
                         kind.code.starts_with("uniform-") || kind.code.starts_with("varying-") ||
                         kind.code.starts_with("geometry-l") || said.id == DiagnosticId::unequal_declarations ||
                         said.id == DiagnosticId::ambiguous_function || said.id == DiagnosticId::validation_died;
    if (of_code && kind.severity == Severity::error)
      errors.push_back(message_line(said, *compiled.sources, compiled.sources->name({0})));
  }
  return errors;
}

bool has_geometry(const PackedTargetProgram& target) {
  return std::any_of(target.stages()->begin(), target.stages()->end(),
                     [](const PackedStage* stage) { return stage->kind() == PackedStageKind::geometry; });
}

class CorpusPrograms : public testing::TestWithParam<std::string> {
 protected:
  static Compiled compile_for(std::vector<Target> targets) {
    CompileOptions options;
    options.targets = std::move(targets);
    options.root = corpus();
    return compile_file(corpus() / GetParam(), options);
  }
};

TEST_P(CorpusPrograms, AreValidAndLinkWithoutAMessage) {
  const Compiled compiled = compile_for({Target::glsl330, Target::essl300});
  if (kIllegal.contains(GetParam())) {
    EXPECT_THAT(shader_errors(compiled), testing::Not(testing::IsEmpty())) << "is legal now: take it off the list";
  } else {
    EXPECT_THAT(shader_errors(compiled), testing::IsEmpty());
  }
  for (const PackedProgram* program : *compiled.package->programs()) {
    const std::size_t targets = has_geometry(*program->targets()->Get(0)) ? 1 : 2;
    EXPECT_GE(program->targets()->size(), targets) << program->name()->str();
  }
  if (compiled.package->programs()->size() > 0) draw_package(*compiled.package, 16, 16);
}

std::string test_name(const testing::TestParamInfo<std::string>& scene) {
  std::string name = scene.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, CorpusPrograms, testing::ValuesIn(scenes_with(has_shaders)), test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CorpusPrograms);

class CorpusLint : public testing::TestWithParam<std::string> {};

TEST_P(CorpusLint, SaysWhatCompilingSays) {
  CompileOptions options;
  options.root = corpus();
  options.stage = "teapot";
  options.for_lint = true;
  EXPECT_EQ(lint_messages(corpus() / GetParam(), options), compile_file(corpus() / GetParam(), options).messages());
}

INSTANTIATE_TEST_SUITE_P(Corpus, CorpusLint, testing::ValuesIn(scenes_with([](const fs::path&) { return true; })), test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CorpusLint);

}  // namespace
}  // namespace plugc

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  plugc::process_validator();  // forks: before the renderer starts its threads
  return RUN_ALL_TESTS();
}

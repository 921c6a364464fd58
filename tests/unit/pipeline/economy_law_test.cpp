// A program holds no more than its shape needs: of the examples and, where it is there, the corpus, every program is compiled
// as it is composed and optimised, and the two are compared. What plugc's templates declare is used; and without an author's
// code, which may make things dead, the optimiser finds no uniform, vertex input or varying that could go.

#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include <fmt/format.h>

#include "support/compile_text.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

std::vector<fs::path> all_scenes() {
  std::vector<fs::path> scenes;
  for (const char* folder :
       {PLUGC_SOURCE_DIR "/examples", PLUGC_SOURCE_DIR "/tests/bench/scenes", PLUGC_SOURCE_DIR "/../shared/corpus/scenes"}) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".x3dv" || extension == ".x3d" || extension == ".wrl") scenes.push_back(entry.path());
    }
  }
  std::ranges::sort(scenes);
  return scenes;
}

using Names = std::set<std::string>;

Names uniforms_of(const PackedProgram& program) {
  Names names;
  for (const PackedUniform* uniform : *program.uniforms()) names.insert(uniform->name()->str());
  return names;
}

Names attributes_of(const PackedProgram& program) {
  Names names;
  for (const PackedAttribute* attribute : *program.attributes()) names.insert(attribute->name()->str());
  return names;
}

const PackedStage& stage_of(const PackedProgram& program, PackedStageKind kind) {
  const auto& stages = *program.targets()->Get(0)->stages();
  return kind == PackedStageKind::vertex ? *stages.Get(0) : *stages.Get(stages.size() - 1);
}

bool is_of_template(const Package& package, const PackedStage& stage, std::size_t line) {
  if (line >= stage.origins()->size()) return false;
  const PackedLineOrigin& origin = *stage.origins()->Get(static_cast<flatbuffers::uoffset_t>(line));
  if (origin.line() == 0) return true;  // plugc's own head
  return package.sources()->Get(origin.source())->string_view().starts_with("plugc:");
}

/// Names that a stage declares with this word in lines that start with it: `uniform vec3 castle_X;`, `flat out vec4 y[2];`.
Names declared(const Package& package, const PackedStage& stage, std::string_view word, bool by_templates_only) {
  Names names;
  std::size_t number = 0;
  std::istringstream text(stage.text()->str());
  for (std::string line; std::getline(text, line); ++number) {
    if (by_templates_only && !is_of_template(package, stage, number)) continue;
    std::istringstream words(line);
    std::string first, type, name;
    words >> first;
    if (first == "flat" || first == "noperspective") words >> first;
    if (first != word || !(words >> type >> name)) continue;
    names.insert(name.substr(0, name.find_first_of(";[ =")));
  }
  return names;
}

Names difference(const Names& a, const Names& b) {
  Names left;
  std::ranges::set_difference(a, b, std::inserter(left, left.end()));
  return left;
}

bool has_author(const PackedProgram& program) {
  return program.recipe()->string_view().find('`') != std::string_view::npos;
}

void expect_used(const Package& package, const PackedProgram& program) {
  const PackedStage& vertex = stage_of(program, PackedStageKind::vertex);
  const PackedStage& fragment = stage_of(program, PackedStageKind::fragment);
  for (const PackedStage* stage : {&vertex, &fragment})
    EXPECT_THAT(difference(declared(package, *stage, "uniform", true), uniforms_of(program)), IsEmpty()) << "uniforms";
  EXPECT_THAT(difference(declared(package, vertex, "in", true), attributes_of(program)), IsEmpty()) << "vertex inputs";
  const bool has_geometry = program.targets()->Get(0)->stages()->size() > 2;
  if (has_geometry) return;
  EXPECT_THAT(difference(declared(package, vertex, "out", true), declared(package, fragment, "in", false)), IsEmpty())
      << "varyings";
}

void expect_nothing_to_optimize(const Package& package, const PackedProgram& program, const Package& optimized_package,
                                const PackedProgram& optimized) {
  EXPECT_EQ(uniforms_of(program), uniforms_of(optimized));
  EXPECT_EQ(attributes_of(program), attributes_of(optimized));
  EXPECT_EQ(declared(package, stage_of(program, PackedStageKind::vertex), "out", false),
            declared(optimized_package, stage_of(optimized, PackedStageKind::vertex), "out", false));
}

class Economy : public testing::TestWithParam<fs::path> {};

TEST_P(Economy, ProgramsHoldOnlyWhatTheirShapesUse) {
  CompileOptions options;
  options.stage = "teapot";
  const Compiled composed = compile_file(GetParam(), options);
  options.optimize = true;
  const Compiled optimized = compile_file(GetParam(), options);
  const auto& programs = *composed.package->programs();
  ASSERT_EQ(programs.size(), optimized.package->programs()->size());
  for (std::uint32_t i = 0; i < programs.size(); ++i) {
    const PackedProgram& program = *programs.Get(i);
    SCOPED_TRACE(fmt::format("program {}: {}", i, program.recipe()->string_view()));
    expect_used(*composed.package, program);
    if (!has_author(program))
      expect_nothing_to_optimize(*composed.package, program, *optimized.package, *optimized.package->programs()->Get(i));
  }
}

std::string test_name(const testing::TestParamInfo<fs::path>& scene) {
  std::string name = fmt::format("{}_{}", scene.index, scene.param.stem().string());
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Economy, testing::ValuesIn(all_scenes()), test_name);

}  // namespace
}  // namespace plugc

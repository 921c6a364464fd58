// Every .case file is a test. PLUGC_REWRITE=1 writes what is said now into the `diagnostics` sections; review it as a diff.
// One more test sees to it that every kind of diagnostic stands in some case.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <zlib.h>

#include "conformance/case_file.h"
#include "image/write_png.h"
#include "scene/shadow_defaults.h"
#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kPictureSide = 32;

bool is_rewriting() {
  return std::getenv("PLUGC_REWRITE") != nullptr;
}

/// Diagnostics that no case can show, each with the reason.
const std::map<std::string_view, std::string_view> kShownElsewhere = {
#include "conformance/shown_elsewhere.inc"
};

void write_image(const SceneFolder& folder, const CaseSection& section) {
  std::vector<std::uint8_t> pixels;
  std::uint32_t height = 0;
  for (auto line = section.lines.rbegin(); line != section.lines.rend(); ++line) {
    std::istringstream stream(*line);
    std::string pixel;
    height += line->empty() ? 0 : 1;
    while (stream >> pixel) {
      for (std::size_t i = 0; i < 8; i += 2)
        pixels.push_back(static_cast<std::uint8_t>(std::stoi(pixel.substr(i, 2), nullptr, 16)));
    }
  }
  const auto width = static_cast<std::uint32_t>(pixels.size() / 4 / std::max(height, 1U));
  EXPECT_TRUE(write_png((folder.path() / section.title.at(1)).string(), width, height, pixels, true));
}

std::string gzipped(std::string text) {
  z_stream stream{};
  constexpr int kGzipFormat = 16;
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS + kGzipFormat, 8, Z_DEFAULT_STRATEGY) != Z_OK) return "";
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// The names of the files that are compiled.
std::vector<std::string> scene_names(const CaseFile& file) {
  std::vector<std::string> names;
  for (const CaseSection& section : file.sections) {
    if (section.title.front() == "scene") names.push_back(section.title.at(1));
  }
  const CaseSection* first = file.find("file");
  if (names.empty() && first != nullptr) names.push_back(first->title.at(1));
  return names;
}

void write_files(const CaseFile& file, const SceneFolder& folder) {
  for (const CaseSection& section : file.sections) {
    const std::string& kind = section.title.front();
    if (kind == "image") write_image(folder, section);
    if (kind != "file" && kind != "scene") continue;
    const bool compressed = section.title.size() > 2 && section.title[2] == "gzip";
    folder.write(section.title.at(1), compressed ? gzipped(section_text(section)) : section_text(section));
  }
}

CompileOptions read_options(const CaseFile& file) {
  CompileOptions options;
  const CaseSection* section = file.find("options");
  if (section == nullptr) return options;
  std::vector<Target> targets;
  for (const std::string& line : section->lines) {
    std::istringstream stream(line);
    std::string word;
    std::string value;
    stream >> word >> value;
    if (word == "lint") options.for_lint = true;
    if (word == "library") options.library = true;
    if (word == "optimize") options.optimize = true;
    if (word == "stage") options.stage = value;
    if (word == "shadows") options.shadows = read_shadow_defaults(value).shadows;
    if (word == "dynamic") options.dynamic.push_back(value);
    if (word == "target") targets.push_back(target_named(value).value());
  }
  if (!targets.empty()) options.targets = std::move(targets);
  return options;
}

/// Blanks at the ends gone, others one.
std::string squeezed(std::string_view line) {
  std::string text;
  for (const char c : line) {
    const bool blank = c == ' ' || c == '\t' || c == '\r';
    if (!blank)
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::vector<std::string> squeezed_lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(squeezed(line));
  return lines;
}

void expect_in_order(const std::string& text, const CaseSection& section) {
  const std::vector<std::string> lines = squeezed_lines(text);
  auto from = lines.begin();
  for (const std::string& wanted : section.lines) {
    const std::string part = squeezed(wanted);
    if (part.empty()) continue;
    const auto found =
        std::find_if(from, lines.end(), [&](const std::string& line) { return line.find(part) != std::string::npos; });
    if (found == lines.end()) {
      ADD_FAILURE() << "line " << section.line << ": `" << part << "` is missing (or comes too early) in\n" << text;
      return;
    }
    from = found + 1;
  }
}

void expect_absent(const std::string& text, const CaseSection& section) {
  for (const std::string& line : squeezed_lines(text)) {
    for (const std::string& unwanted : section.lines) {
      const std::string part = squeezed(unwanted);
      const bool stands = !part.empty() && line.find(part) != std::string::npos;
      EXPECT_FALSE(stands) << "line " << section.line << ": `" << part << "` stands in\n" << text;
    }
  }
}

void expect_stage(const Compiled& compiled, PackedStageKind stage, const CaseSection& section) {
  const auto program = static_cast<std::uint32_t>(std::stoul(section.title.at(1)));
  const std::string text = compiled.stage_text(program, stage);
  ASSERT_NE(text, "") << "line " << section.line << ": there is no such program";
  if (section.title.size() > 2 && section.title[2] == "lacks")
    expect_absent(text, section);
  else
    expect_in_order(text, section);
}

/// `--- pixels Glow.enabled=0 Lamp.on=1 time=2`
FieldValues field_values(const CaseSection& section, double& time) {
  FieldValues values;
  for (std::size_t i = 1; i < section.title.size(); ++i) {
    const std::size_t equals = section.title[i].find('=');
    const double value = std::stod(section.title[i].substr(equals + 1));
    if (section.title[i].starts_with("time="))
      time = value;
    else
      values.emplace_back(section.title[i].substr(0, equals), value);
  }
  return values;
}

/// `Box.translation: 1 0 2`
void expect_values(const Compiled& compiled, const CaseSection& section) {
  constexpr double kError = 1e-6;
  std::vector<std::string> names;
  std::vector<std::vector<double>> expected;
  for (const std::string& line : section.lines) {
    if (line.empty()) continue;
    names.push_back(line.substr(0, line.find(':')));
    std::istringstream numbers(line.substr(names.back().size() + 1));
    expected.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
  }
  const auto found = fields_at(*compiled.package, names, std::stod(section.title.at(1)));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_THAT(found[i], testing::Pointwise(testing::DoubleNear(kError), expected[i]))
        << names[i] << ", line " << section.line;
  }
}

void expect_pixels(const Compiled& compiled, const CaseSection& section) {
  double time = 0;
  const FieldValues fields = field_values(section, time);
  const Picture picture = draw_package(*compiled.package, kPictureSide, kPictureSide, fields, time);
  for (const std::string& line : section.lines) {
    if (line.empty()) continue;
    std::istringstream stream(line);
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    char colon = 0;
    Color color{};
    stream >> x >> y >> colon >> color[0] >> color[1] >> color[2];
    ASSERT_TRUE(stream && colon == ':') << "line " << section.line << ": `" << line << "` is no `X Y: R G B`";
    EXPECT_THAT(color_at(picture, x, y), IsColor(color)) << "at " << x << ", " << y;
  }
}

/// `--dump scene` without the places, which differ between encodings.
std::string graph_text(const fs::path& scene, const CompileOptions& options) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  static const std::regex place(R"( \([^()]*:\d+:\d+\))");
  return std::regex_replace(dump_stage(scene, "scene", options, sources, diagnostics), place, "");
}

std::string words(const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>& list) {
  std::string text;
  for (const auto* word : list) text += (text.empty() ? "" : " ") + word->str();
  return text.empty() ? "nothing" : text;
}

/// What a library says of its effects.
void expect_effects(const Compiled& compiled, const CaseSection& section) {
  std::vector<std::string> found;
  for (const PackedEffect* effect : *compiled.package->effects()) {
    std::string line =
        fmt::format("{} needs {}; offers {}", effect->name()->string_view(), words(*effect->needs()), words(*effect->offers()));
    for (const PackedEffectKind* kind : *effect->kinds()) line += fmt::format("; {}", kind->name()->string_view());
    found.push_back(line);
  }
  std::vector<std::string> expected = section.lines;
  std::erase(expected, "");
  EXPECT_EQ(found, expected) << "line " << section.line;
}

void expect_section(const Compiled& compiled, const CaseSection& section) {
  const std::string& kind = section.title.front();
  if (kind == "vertex")
    expect_stage(compiled, PackedStageKind::vertex, section);
  else if (kind == "geometry")
    expect_stage(compiled, PackedStageKind::geometry, section);
  else if (kind == "fragment")
    expect_stage(compiled, PackedStageKind::fragment, section);
  else if (kind == "pixels")
    expect_pixels(compiled, section);
  else if (kind == "values")
    expect_values(compiled, section);
  else if (kind == "effects")
    expect_effects(compiled, section);
  else if (kind == "package")
    expect_in_order(dump_package(*compiled.package), section);
  else if (kind == "programs")
    EXPECT_EQ(std::to_string(compiled.package->programs()->size()), section.lines.at(0));
  else if (kind != "file" && kind != "scene" && kind != "image" && kind != "options" && kind != "diagnostics" &&
           kind != "graph") {
    ADD_FAILURE() << "line " << section.line << ": no section is called `" << kind << "`";
  }
}

/// A line of expectation may end behind the code; then any message is right.
bool is_expected(const std::string& said, const std::string& expected) {
  return said == expected || (std::count(expected.begin(), expected.end(), ' ') == 1 && said.starts_with(expected + " "));
}

/// What is said of a scene; `name` is "" where the case has but one.
void expect_diagnostics(const Compiled& compiled, CaseFile& file, std::string_view name) {
  const std::vector<std::string> said = compiled.messages();
  if (is_rewriting()) return rewrite_diagnostics(file, name, said);
  std::vector<std::string> expected;
  if (const CaseSection* section = file.find("diagnostics", name)) expected = section->lines;
  std::erase(expected, "");
  EXPECT_TRUE(std::equal(said.begin(), said.end(), expected.begin(), expected.end(), is_expected))
      << "said:\n  " << fmt::format("{}", fmt::join(said, "\n  ")) << "\nexpected:\n  "
      << fmt::format("{}", fmt::join(expected, "\n  "));
}

/// Lint looks less closely at what is only drawn, but misses nothing that compiling says.
void expect_equal_lint(const fs::path& scene, CompileOptions options) {
  options.for_lint = true;
  options.library = false;
  EXPECT_EQ(lint_messages(scene, options), compile_file(scene, options).messages());
}

class CaseTest : public testing::Test {
 public:
  explicit CaseTest(CaseFile file) : file_(std::move(file)) {}

  void TestBody() override {
    const SceneFolder folder;
    write_files(file_, folder);
    const std::vector<std::string> scenes = scene_names(file_);
    ASSERT_FALSE(scenes.empty()) << "the case has no `--- file` and no `--- scene`";
    for (const std::string& name : scenes) {
      SCOPED_TRACE(name);
      expect_all(folder, name, scenes.size() == 1 ? "" : name);
    }
  }

 private:
  void expect_all(const SceneFolder& folder, const std::string& scene, std::string_view name) {
    CompileOptions options = read_options(file_);
    options.root = folder.path();
    const Compiled compiled = compile_file(folder.path() / scene, options);
    expect_diagnostics(compiled, file_, name);
    for (const CaseSection& section : file_.sections) expect_section(compiled, section);
    expect_equal_lint(folder.path() / scene, options);
    if (const CaseSection* graph = file_.find("graph")) expect_in_order(graph_text(folder.path() / scene, options), *graph);
  }

  CaseFile file_;
};

/// Compiles a scene twice and compares the pictures: optimised programs draw the same.
void expect_same_picture(const fs::path& scene, CompileOptions options) {
  options.optimize = false;
  const Compiled readable = compile_file(scene, options);
  options.optimize = true;
  const Compiled optimized = compile_file(scene, options);
  const Picture expected = draw_package(*readable.package, kPictureSide, kPictureSide);
  const Picture drawn = draw_package(*optimized.package, kPictureSide, kPictureSide);
  constexpr int kRounding = 2;  // of folded constants
  std::size_t different = 0;
  for (std::uint32_t y = 0; y < kPictureSide; ++y) {
    for (std::uint32_t x = 0; x < kPictureSide; ++x)
      different += is_near(color_at(expected, x, y), color_at(drawn, x, y), kRounding) ? 0 : 1;
  }
  EXPECT_EQ(different, 0U) << "pixels differ";
}

/// A case that draws something, drawn again by optimised programs.
class OptimizedCaseTest : public testing::Test {
 public:
  explicit OptimizedCaseTest(CaseFile file) : file_(std::move(file)) {}

  void TestBody() override {
    const SceneFolder folder;
    write_files(file_, folder);
    CompileOptions options = read_options(file_);
    options.root = folder.path();
    expect_same_picture(folder.path() / scene_names(file_).front(), options);
  }

 private:
  CaseFile file_;
};

class OptimizedExampleTest : public testing::Test {
 public:
  explicit OptimizedExampleTest(fs::path scene) : scene_(std::move(scene)) {}
  void TestBody() override { expect_same_picture(scene_, {}); }

 private:
  fs::path scene_;
};

/// The codes that stand in `diagnostics` sections.
std::set<std::string> shown_codes(const std::vector<CaseFile>& files) {
  std::set<std::string> codes;
  for (const CaseFile& file : files) {
    for (const CaseSection& section : file.sections) {
      if (section.title.front() != "diagnostics") continue;
      for (const std::string& line : section.lines) {
        std::istringstream stream(line);
        std::string place;
        std::string code;
        if (stream >> place >> code) codes.insert(code);
      }
    }
  }
  return codes;
}

class CoverageTest : public testing::Test {
 public:
  explicit CoverageTest(std::set<std::string> shown) : shown_(std::move(shown)) {}

  void TestBody() override {
    std::vector<std::string_view> missing;
    for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(DiagnosticId::count); ++i) {
      const std::string_view code = diagnostic_kind(static_cast<DiagnosticId>(i)).code;
      const bool exempt = kShownElsewhere.contains(code);
      const bool shown = shown_.contains(std::string(code));
      if (!shown && !exempt) missing.push_back(code);
      EXPECT_FALSE(shown && exempt) << "`" << code << "` stands in a case now; take it out of shown_elsewhere.inc";
    }
    EXPECT_THAT(missing, testing::IsEmpty()) << "stand in no case; write one under tests/conformance";
  }

 private:
  std::set<std::string> shown_;
};

void register_tests(const std::vector<CaseFile>& files) {
  for (const CaseFile& file : files) {
    const std::size_t dot = file.name.rfind('.');
    const std::string suite = dot == std::string::npos ? "case" : file.name.substr(0, dot);
    const std::string name = dot == std::string::npos ? file.name : file.name.substr(dot + 1);
    testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, nullptr, file.path.c_str(), 1,
                          [file]() -> testing::Test* { return new CaseTest(file); });
    if (file.find("pixels") == nullptr) continue;
    testing::RegisterTest("Optimized", file.name.c_str(), nullptr, nullptr, file.path.c_str(), 1,
                          [file]() -> testing::Test* { return new OptimizedCaseTest(file); });
  }
  for (const auto& entry : fs::directory_iterator(PLUGC_SOURCE_DIR "/examples")) {
    const fs::path scene = entry.path() / (entry.path().filename().string() + ".x3dv");
    if (!fs::exists(scene)) continue;
    testing::RegisterTest("Optimized", entry.path().filename().c_str(), nullptr, nullptr, scene.c_str(), 1,
                          [scene]() -> testing::Test* { return new OptimizedExampleTest(scene); });
  }
  testing::RegisterTest("Diagnostics", "EachStandsInSomeCase", nullptr, nullptr, __FILE__, __LINE__,
                        [shown = shown_codes(files)]() -> testing::Test* { return new CoverageTest(shown); });
}

}  // namespace
}  // namespace plugc

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  plugc::process_validator();  // forks: before the renderer starts its threads
  plugc::register_tests(plugc::read_case_files(PLUGC_SOURCE_DIR "/tests/conformance"));
  return RUN_ALL_TESTS();
}

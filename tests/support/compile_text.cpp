// A folder a test below the system's temporary one; the root of what the scene may read is that folder.

#include "support/compile_text.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plugc {
namespace {

namespace fs = std::filesystem;

/// `noise.glsl:3:7`, or `3:7` in the scene itself, or `-` for no place.
std::string place_text(const Span& span, const SourceSet& sources, std::string_view scene) {
  if (!span.valid()) return "-";
  const Position at = sources.position(span.source, span.begin);
  const std::string_view name = sources.name(span.source);
  const std::string file = name == scene ? "" : fs::path(name).filename().string() + ":";
  return fmt::format("{}{}:{}", file, at.line, at.column);
}

}  // namespace

SceneFolder::SceneFolder() {
  std::string name = (fs::temp_directory_path() / "plugc_test_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "no temporary folder " << name;
  path_ = fs::canonical(name);
}

SceneFolder::~SceneFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

fs::path SceneFolder::write(std::string_view name, std::string_view text) const {
  const fs::path path = path_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string message_line(const Diagnostic& diagnostic, const SourceSet& sources, std::string_view scene) {
  std::string message = diagnostic.message;
  const std::string folder = fs::path(scene).parent_path().string() + "/";
  for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder))
    message.erase(at, folder.size());
  return fmt::format("{} {} {}", place_text(diagnostic.span, sources, scene), diagnostic_kind(diagnostic.id).code, message);
}

namespace {

std::vector<std::string> sorted_messages(const Diagnostics& diagnostics, const SourceSet& sources) {
  std::vector<Diagnostic> sorted(diagnostics.all().begin(), diagnostics.all().end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.span.source.value, a.span.begin) < std::pair(b.span.source.value, b.span.begin);
  });
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : sorted) lines.push_back(message_line(diagnostic, sources, sources.name({0})));
  return lines;
}

}  // namespace

std::vector<std::string> Compiled::messages() const {
  return sorted_messages(*diagnostics, *sources);
}

std::vector<std::string> lint_messages(const fs::path& scene, CompileOptions options) {
  if (options.root.empty()) options.root = scene.parent_path();
  static KnownImages known;  // of all tests: what was found out of another scene's images must not be heard
  options.known_images = &known;
  SourceSet sources;
  Diagnostics diagnostics(sources);
  lint(scene, options, process_validator(), sources, diagnostics);
  return sorted_messages(diagnostics, sources);
}

std::string Compiled::stage_text(std::uint32_t program, PackedStageKind stage) const {
  if (package == nullptr || program >= package->programs()->size()) return "";
  for (const PackedStage* candidate : *package->programs()->Get(program)->targets()->Get(0)->stages()) {
    if (candidate->kind() == stage) return candidate->text()->str();
  }
  return "";
}

Validator& process_validator() {
  // Tests run beside others, so a program gets more time than it has in the command line.
  static Validator validator([] {
    ValidatorOptions options;
    options.timeout = std::chrono::milliseconds(60'000);
    return options;
  }());
  return validator;
}

Compiled compile_file(const fs::path& scene, CompileOptions options) {
  if (options.root.empty()) options.root = scene.parent_path();
  Compiled compiled;
  compiled.sources = std::make_unique<SourceSet>();
  compiled.diagnostics = std::make_unique<Diagnostics>(*compiled.sources);
  Compilation made = compile({scene}, options, process_validator(), *compiled.sources, *compiled.diagnostics);
  compiled.statistics = made.statistics;
  compiled.costs = std::move(made.costs);
  compiled.bytes = write_package(made.package);
  const PackageView view = open_package(compiled.bytes);
  EXPECT_EQ(view.error, "");
  compiled.package = view.package;
  return compiled;
}

Compiled compile_text(std::string_view text, const CompileOptions& options, std::string_view name) {
  const SceneFolder folder;
  return compile_file(folder.write(name, text), options);
}

std::vector<std::string> program_texts(const Compiled& compiled) {
  std::vector<std::string> texts;
  for (std::uint32_t program = 0; program < compiled.package->programs()->size(); ++program) {
    texts.push_back(compiled.stage_text(program, PackedStageKind::vertex));
    texts.push_back(compiled.stage_text(program, PackedStageKind::fragment));
  }
  return texts;
}

}  // namespace plugc

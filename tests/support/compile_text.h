#pragma once
// Scenes written down in a test, compiled by the whole pipeline.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compile.h"
#include "package/package_file.h"

namespace plugc {

/// A folder for one test's files; removed with all it holds.
class SceneFolder {
 public:
  SceneFolder();
  ~SceneFolder();
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file, folders above it included, and says where it lies.
  std::filesystem::path write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

/// A package with all that its messages point into.
struct Compiled {
  std::unique_ptr<SourceSet> sources;
  std::unique_ptr<Diagnostics> diagnostics;
  std::vector<std::uint8_t> bytes;
  const Package* package = nullptr;  ///< A view of `bytes`.
  CompileStatistics statistics;
  std::vector<ProgramCosts> costs;  ///< By program, with CompileOptions::measure.

  /// `line:column code message`, in order of place; a file other than the scene goes in front (`noise.glsl:3:1 ...`).
  std::vector<std::string> messages() const;
  /// The text of a stage of program `program` for its first target; "" when there is no such program.
  std::string stage_text(std::uint32_t program, PackedStageKind stage) const;
};

/// What `plugc lint` says of a scene, as Compiled::messages() has it.
std::vector<std::string> lint_messages(const std::filesystem::path& scene, CompileOptions options = {});

/// The vertex and fragment texts of every program, in order.
std::vector<std::string> program_texts(const Compiled& compiled);

/// The validator of this process. It forks when it is first asked for, so ask before any thread is started.
Validator& process_validator();

/// Compiles a scene that may read files beside it.
Compiled compile_file(const std::filesystem::path& scene, CompileOptions options = {});
/// The same for a scene without other files. `name` tells the encoding.
Compiled compile_text(std::string_view text, const CompileOptions& options = {}, std::string_view name = "scene.x3dv");

/// `line:column code message` for one diagnostic, as messages() has it. `scene` is the file that needs no name; its folder is
/// left out of messages.
std::string message_line(const Diagnostic& diagnostic, const SourceSet& sources, std::string_view scene);

}  // namespace plugc

#pragma once
// The verbs of the command line, one file each. A verb returns the process's exit status: 0 fine, 1 the input has errors
// (what could be made is still written), 2 wrong usage or a broken environment.

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compile.h"

namespace plugc {

inline constexpr int kFine = 0;
inline constexpr int kInputErrors = 1;
inline constexpr int kBrokenUse = 2;

/// What every verb takes.
struct CommonOptions {
  std::string root;
  std::vector<std::string> targets = {"glsl330"};
  bool no_cache = false;
  bool optimize = false;
  std::size_t jobs = 1;
  std::vector<std::string> dynamic;
  std::string shadows;  ///< METHOD[,SIZE], checked; empty: not given.
};
void add_common_options(CLI::App& verb, CommonOptions& options);
/// `--dynamic`, for the verbs that make packages.
void add_dynamic_option(CLI::App& verb, CommonOptions& options);
/// `--optimize`, for the same.
void add_optimize_option(CLI::App& verb, CommonOptions& options);
/// `--shadows`, for every verb that compiles.
void add_shadows_option(CLI::App& verb, CommonOptions& options);
/// Says that `--shadows` changes no package.
int refuse_shadows_of_package();
CompileOptions compile_options(const CommonOptions& options);
/// `-j N`: what is said and made does not depend on it.
void add_jobs_option(CLI::App& verb, CommonOptions& options, const std::string& meaning);
/// Forks the validating workers: call it before any thread is started.
Validator make_validator(const CommonOptions& options);

/// plugc's private cache folder (`$PLUGC_CACHE_DIR`, `$XDG_CACHE_HOME/plugc`, `~/.cache/plugc`), made on demand; empty
/// when there is none that can be written.
std::filesystem::path cache_folder(std::string_view subfolder);

/// Prints to stderr as text, sorted by file and line; returns the exit status that the diagnostics ask for.
int report(const Diagnostics& diagnostics);

/// Files as given; folders are searched for scenes, in name order.
std::vector<std::filesystem::path> scene_files(const std::vector<std::string>& paths);

/// Whether that is a package; anything else is taken for a scene.
bool is_package_file(const std::filesystem::path& path);

/// Each declares its verb; the callback sets `status`.
void add_build_command(CLI::App& app, int& status);
void add_lint_command(CLI::App& app, int& status);
void add_preview_command(CLI::App& app, int& status);
void add_inspect_command(CLI::App& app, int& status);

}  // namespace plugc

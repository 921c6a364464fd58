// What the verbs share.

#include "cli/commands.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sys/stat.h>

#include "scene/shadow_defaults.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

fs::path cache_root() {
  if (const auto own = environment("PLUGC_CACHE_DIR"); !own.empty()) return own;
  if (const auto xdg = environment("XDG_CACHE_HOME"); !xdg.empty()) return fs::path(xdg) / "plugc";
  if (const auto home = environment("HOME"); !home.empty()) return fs::path(home) / ".cache" / "plugc";
  return {};
}

auto sort_key(const Diagnostic& diagnostic) {
  return std::make_tuple(diagnostic.span.source.value, diagnostic.span.begin);
}

/// Most `.json` files of a folder are no scenes; one that is says so right away.
bool begins_with_x3d(const fs::path& path) {
  std::string beginning(1024, '\0');
  std::ifstream(path, std::ios::binary).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find("\"X3D\"") != std::string::npos;
}

bool is_scene_file(const fs::path& path) {
  constexpr std::string_view kEndings[] = {".x3dv", ".x3d", ".x3dj", ".wrl", ".x3dvz", ".x3dz", ".wrz"};
  const std::string ending = path.extension().string();
  if (ending == ".json") return begins_with_x3d(path);
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

}  // namespace

std::vector<fs::path> scene_files(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.emplace_back(path);
      continue;
    }
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied, error)) {
      if (entry.is_regular_file(error) && is_scene_file(entry.path())) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

void add_common_options(CLI::App& verb, CommonOptions& options) {
  verb.add_option(
      "--root", options.root,
      "Folder that scenes may read files from (default: the nearest one above the scene that holds .plugc.toml or .git, "
      "else the current folder where the scene lies in it, else the scene's own)");
  verb.add_flag("--no-cache", options.no_cache,
                "Neither read nor write the cache folder ($PLUGC_CACHE_DIR, else $XDG_CACHE_HOME/plugc, else ~/.cache/plugc)");
}

void add_dynamic_option(CLI::App& verb, CommonOptions& options) {
  verb.add_option("--dynamic", options.dynamic,
                  "A field that the host may change while the scene is drawn, as DEF.field; may be given several times")
      ->take_all()
      ->allow_extra_args(false);
}

void add_optimize_option(CLI::App& verb, CommonOptions& options) {
  verb.add_flag("--optimize", options.optimize,
                "Leave out of programs what does not reach the picture (spirv-opt, SPIRV-Cross); less readable");
}

void add_shadows_option(CLI::App& verb, CommonOptions& options) {
  verb.add_option(
          "--shadows", options.shadows,
          fmt::format("How shadow maps are looked up, and their size in texels, where the scene does not say it: METHOD or "
                      "METHOD,SIZE with a method of {}",
                      fmt::join(shadow_method_names(), ", ")))
      ->check([](const std::string& text) { return read_shadow_defaults(text).error; });
}

int refuse_shadows_of_package() {
  fmt::print(stderr, "plugc: `--shadows` is decided when a package is built; give it to `plugc build`, or give the scene\n");
  return kBrokenUse;
}

CompileOptions compile_options(const CommonOptions& options) {
  CompileOptions compile;
  if (!options.shadows.empty()) compile.shadows = read_shadow_defaults(options.shadows).shadows;
  compile.dynamic = options.dynamic;
  compile.root = options.root;
  compile.optimize = options.optimize;
  compile.targets.clear();
  for (const std::string& name : options.targets) {
    if (const auto target = target_named(name)) compile.targets.push_back(*target);
  }
  return compile;
}

void add_jobs_option(CLI::App& verb, CommonOptions& options, const std::string& meaning) {
  constexpr std::size_t kMostJobs = 256;
  verb.add_option("-j,--jobs", options.jobs, meaning)->check(CLI::Range(std::size_t{1}, kMostJobs))->capture_default_str();
}

Validator make_validator(const CommonOptions& options) {
  ValidatorOptions validator;
  validator.workers = options.jobs;
  if (!options.no_cache) validator.cache_folder = cache_folder("verdicts");
  return Validator(validator);
}

fs::path cache_folder(std::string_view subfolder) {
  const fs::path root = cache_root();
  if (root.empty()) return {};
  std::error_code error;
  const fs::path folder = root / subfolder;
  fs::create_directories(folder, error);
  if (error) return {};
  fs::permissions(root, fs::perms::owner_all, error);  // private: what lies in it is trusted
  return folder;
}

bool is_package_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;  // a pipe would wait
  std::ifstream stream(path, std::ios::binary);
  std::string magic(8, '\0');
  return stream.read(magic.data(), 8) && magic == "PLUGPACK";
}

int report(const Diagnostics& diagnostics) {
  std::vector<Diagnostic> sorted(diagnostics.all().begin(), diagnostics.all().end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return sort_key(a) < sort_key(b); });
  for (const Diagnostic& diagnostic : sorted) {
    const std::string text = to_text(diagnostic, diagnostics.sources());
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
  return diagnostics.has_errors() ? kInputErrors : kFine;
}

}  // namespace plugc

// What the verbs share.

#include "cli/commands.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include <sys/stat.h>

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

}  // namespace

void add_common_options(CLI::App& verb, CommonOptions& options) {
  verb.add_option(
      "--root", options.root,
      "Folder that scenes may read files from (default: the nearest one above the scene that holds .plugc.toml or .git, "
      "else the current folder where the scene lies in it, else the scene's own)");
  verb.add_flag("--no-cache", options.no_cache, "Neither read nor write plugc's cache folder");
}

void add_dynamic_option(CLI::App& verb, CommonOptions& options) {
  verb.add_option("--dynamic", options.dynamic,
                  "A field that the host may change while the scene is drawn, as DEF.field; may be given several times")
      ->take_all()
      ->allow_extra_args(false);
}

CompileOptions compile_options(const CommonOptions& options) {
  CompileOptions compile;
  compile.dynamic = options.dynamic;
  compile.root = options.root;
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

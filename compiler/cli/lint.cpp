// plugc lint: every effect of the files given, also those that are disabled or in branches that are not drawn. Files are
// independent of each other: with `-j N`, N threads, each with a validating process of its own, take the next file that
// nobody has taken. What is said of them is joined in the order of the files.

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/message_formats.h"

namespace plugc {
namespace {

struct LintOptions {
  CommonOptions common;
  std::vector<std::string> paths;
  std::string format = "text";
};

/// What was said of one file, and what that points into.
struct LintedFile {
  SourceSet sources;
  Diagnostics diagnostics{sources};
};

using LintedFiles = std::vector<std::unique_ptr<LintedFile>>;

LintedFiles lint_files(const std::vector<std::filesystem::path>& files, const LintOptions& options) {
  CommonOptions one_job = options.common;
  one_job.jobs = 1;
  CompileOptions compile_with = compile_options(options.common);
  compile_with.stage = "teapot";
  std::vector<Validator> validators;
  const std::size_t jobs = std::clamp<std::size_t>(files.size(), 1, options.common.jobs);
  for (std::size_t i = 0; i < jobs; ++i) validators.push_back(make_validator(one_job));
  LintedFiles linted(files.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&](Validator& validator) {
    KnownImages images;
    CompileOptions with_images = compile_with;
    with_images.known_images = &images;
    for (std::size_t i = next++; i < files.size(); i = next++) {
      linted[i] = std::make_unique<LintedFile>();
      lint(files[i], with_images, validator, linted[i]->sources, linted[i]->diagnostics);
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < jobs; ++i) threads.emplace_back(work, std::ref(validators[i]));
  work(validators.front());
  return linted;
}

int run_lint(const LintOptions& options) {
  const std::vector<std::filesystem::path> files = scene_files(options.paths);
  const LintedFiles linted = lint_files(files, options);
  SourceSet sources;
  Diagnostics diagnostics(sources);
  for (const auto& file : linted) diagnostics.append(file->diagnostics, sources.append(std::move(file->sources)));
  if (options.format == "text") {
    const int status = report(diagnostics);
    fmt::print("{} files, {} errors, {} warnings, {} notes\n", files.size(), diagnostics.count(Severity::error),
               diagnostics.count(Severity::warning), diagnostics.count(Severity::note));
    return status;
  }
  fmt::print("{}", formatted_messages(diagnostics, options.format));
  return diagnostics.has_errors() ? kInputErrors : kFine;
}

}  // namespace

void add_lint_command(CLI::App& app, int& status) {
  auto options = std::make_shared<LintOptions>();
  CLI::App* verb = app.add_subcommand("lint", "Check the effects of scenes without drawing anything");
  verb->add_option("PATH", options->paths, "X3D scenes, or folders to search for them")->required()->check(CLI::ExistingPath);
  verb->add_option("--format", options->format, "How to print messages: text (stderr), json, sarif or github (stdout)")
      ->check(CLI::IsMember({"text", "json", "sarif", "github"}))
      ->capture_default_str();
  verb->add_option("--target", options->common.targets, "Dialects to check for, separated by commas (default: glsl330)")
      ->delimiter(',')
      ->check(CLI::IsMember({"glsl330", "essl300", "spirv"}));
  add_shadows_option(*verb, options->common);
  add_common_options(*verb, options->common);
  add_jobs_option(*verb, options->common, "Files that are checked at a time");
  verb->footer(
      "Each message names the author's file, line and column, and a stable code in brackets.\n\n"
      "Example: plugc lint --format github effects/");
  verb->callback([options, &status] { status = run_lint(*options); });
}

}  // namespace plugc

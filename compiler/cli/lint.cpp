// plugc lint: every effect of the files given, also those that are disabled or in branches that are not drawn.

#include <memory>

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

int lint(const LintOptions& options) {
  Validator validator = make_validator(options.common);
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions compile_with = compile_options(options.common);
  compile_with.for_lint = true;
  compile_with.stage = "teapot";
  const std::vector<std::filesystem::path> files = scene_files(options.paths);
  for (const std::filesystem::path& file : files) compile({file}, compile_with, validator, sources, diagnostics);
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
  verb->add_option("--target", options->common.targets, "Dialects to check for: glsl330, essl300, spirv")
      ->delimiter(',')
      ->check(CLI::IsMember({"glsl330", "essl300", "spirv"}));
  add_common_options(*verb, options->common);
  verb->footer(
      "Each message names the author's file, line and column, and a stable code in brackets.\n\n"
      "Example: plugc lint --format github effects/");
  verb->callback([options, &status] { status = lint(*options); });
}

}  // namespace plugc

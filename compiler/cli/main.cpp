// plugc: the command line. Each verb is declared by its own file; this one ties them together.

#include "cli/commands.h"

namespace {

constexpr const char* kFooter = R"(Examples:
  plugc build scene.x3dv -o scene.plugpack     compile a scene into a package
  plugc lint effects/                          check every effect below a folder
  plugc preview scene.x3dv -o picture.png      compile and draw
  plugc inspect scene.x3dv --program 0         read a composed shader

Messages go to stderr, results to stdout. Exit status: 0 fine, 1 the input has errors
(what could be made is still written), 2 wrong usage or a broken environment.
`plugc VERB --help` explains a verb.)";

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("plugc compiles the shader effects of X3D scenes ahead of time.", "plugc");
  app.footer(kFooter);
  app.require_subcommand(1);
  app.set_version_flag("--version", "plugc " PLUGC_VERSION);
  int status = plugc::kFine;
  plugc::add_build_command(app, status);
  plugc::add_lint_command(app, status);
  plugc::add_preview_command(app, status);
  plugc::add_inspect_command(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? plugc::kFine : plugc::kBrokenUse;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plugc: %s\n", error.what());
    return plugc::kBrokenUse;
  }
  return status;
}

// plugc build: scenes in, one package out.

#include <fstream>
#include <memory>

#include <fmt/format.h>

#include "cli/choose_shadows.h"
#include "cli/commands.h"
#include "cli/picture_size.h"

namespace plugc {
namespace {

struct BuildOptions {
  CommonOptions common;
  std::vector<std::string> scenes;
  std::string output;
  std::string depfile;
  std::string shadow_error;  ///< Empty: nothing is measured.
  std::string size = "1280x720";
};

bool write_file(const std::string& path, const void* data, std::size_t size) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  stream.flush();
  if (!stream) fmt::print(stderr, "plugc: cannot write `{}`\n", path);
  return static_cast<bool>(stream);
}

/// Blanks and dollars as make wants them.
std::string make_escaped(std::string_view path) {
  std::string escaped;
  for (const char c : path) {
    if (c == ' ' || c == '#') escaped += '\\';
    if (c == '$') escaped += '$';
    escaped += c;
  }
  return escaped;
}

/// `out: scene effect.frag ...` for make and ninja.
std::string depfile_text(const BuildOptions& options, const std::set<std::filesystem::path>& files) {
  std::string text = make_escaped(options.output) + ":";
  for (const std::filesystem::path& file : files) text += " " + make_escaped(file.string());
  return text + "\n";
}

void print_summary(const Compilation& made, const BuildOptions& options, std::size_t bytes) {
  std::size_t filled = 0;
  for (const auto& program : made.package.programs) filled += program->plugs_filled.size();
  std::size_t shapes = 0;
  for (const auto& scene : made.package.scenes) shapes += scene->shapes.size();
  const CompileStatistics& s = made.statistics;
  fmt::print("{}: {} programs for {} shapes, {} plugs filled, {} bytes\n", options.output, made.package.programs.size(), shapes,
             filled, bytes);
  if (!made.package.effects.empty()) fmt::print("  a library of {} effects\n", made.package.effects.size());
  for (const auto& program : made.package.programs) {
    fmt::print("  {}\n", program->recipe);
    for (const std::string& plug : program->plugs_filled) fmt::print("    fills {}\n", plug);
  }
  fmt::print("read {:.1f} ms, prepare {:.1f} ms, compose {:.2f} ms ({} programs), validate {:.1f} ms, assemble {:.1f} ms\n",
             s.read, s.prepare, s.compose, s.compositions, s.validate, s.assemble);
}

/// Into `compile_with`; false where pictures cannot be drawn or the size of them is none.
bool choose_all_shadows(const BuildOptions& options, Validator& validator, CompileOptions& compile_with) {
  const auto size = read_picture_size(options.size);
  if (!size) refuse_picture_size(options.size);
  if (!size) return false;
  std::string error;
  const std::string mesa_cache = options.common.no_cache ? "" : cache_folder("mesa").string();
  const std::unique_ptr<Studio> studio = Studio::make(mesa_cache, error, true);
  if (studio == nullptr) fmt::print(stderr, "plugc: `--shadow-error` has to draw, and cannot: {}\n", error);
  if (studio == nullptr) return false;
  const ShadowErrorRequest request{*read_percentage(options.shadow_error), size->width, size->height,
                                   !options.common.shadows.empty()};
  for (const std::filesystem::path& scene : scene_files(options.scenes)) {
    for (const ChosenShadow& chosen : choose_shadows(scene, compile_with, request, validator, *studio)) {
      compile_with.shadow_choices[scene].push_back(chosen.choice);
      fmt::print("{}", explain(chosen));
    }
  }
  for (const std::string& message : studio->take_messages()) fmt::print(stderr, "{}\n", message);
  return true;
}

int build(const BuildOptions& options) {
  Validator validator = make_validator(options.common);
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions compile_with = compile_options(options.common);
  compile_with.library = true;
  if (!options.shadow_error.empty() && !choose_all_shadows(options, validator, compile_with)) return kBrokenUse;
  const Compilation made = compile(scene_files(options.scenes), compile_with, validator, sources, diagnostics);
  const int status = report(diagnostics);
  const std::vector<std::uint8_t> bytes = write_package(made.package);
  if (!write_file(options.output, bytes.data(), bytes.size())) return kBrokenUse;
  if (!options.depfile.empty()) {
    const std::string text = depfile_text(options, made.files_read);
    if (!write_file(options.depfile, text.data(), text.size())) return kBrokenUse;
  }
  print_summary(made, options, bytes.size());
  return status;
}

}  // namespace

void add_build_command(CLI::App& app, int& status) {
  auto options = std::make_shared<BuildOptions>();
  CLI::App* verb = app.add_subcommand("build", "Compile scenes into a package that the runtime draws");
  verb->add_option("SCENE", options->scenes,
                   "X3D scenes (.x3dv, .x3d, .x3dj, .wrl) or glTF models, or folders to search for scenes")
      ->required()
      ->check(CLI::ExistingPath);
  verb->add_option("-o,--output", options->output, "The package to write (.plugpack)")->required();
  verb->add_option("--target", options->common.targets, "Dialects to compile for, separated by commas (default: glsl330)")
      ->delimiter(',')
      ->check(CLI::IsMember({"glsl330", "essl300", "spirv"}));
  verb->add_option("--depfile", options->depfile, "Also write a file that tells make or ninja what the package depends on");
  add_dynamic_option(*verb, options->common);
  add_optimize_option(*verb, options->common);
  add_shadows_option(*verb, options->common);
  verb->add_option(
          "--shadow-error", options->shadow_error,
          "Choose for each light the cheapest shadow map with which at most this share of the pixels is wrong, e.g. 0.5%: "
          "draws the scene from all its viewpoints and measures")
      ->check([](const std::string& text) {
        return read_percentage(text) ? ""
                                     : fmt::format("`{}` is no share of wrong pixels; write a percentage, e.g. 0.5%", text);
      });
  verb->add_option("--size", options->size,
                   "Size of the pictures in which --shadow-error counts pixels; smaller where all viewpoints together pass 16 "
                   "megapixels")
      ->capture_default_str();
  add_common_options(*verb, options->common);
  add_jobs_option(*verb, options->common, "Programs that are validated at a time");
  verb->footer(
      "Programs that are equal are stored once. An effect that does not compile is left out alone, with a message;\n"
      "the package then holds the rest and the exit status is 1. A file with effects and no shape becomes a library:\n"
      "each effect is compiled alone, for every kind of shape that it can tell from others.\n\n"
      "Example: plugc build scene.x3dv -o scene.plugpack --target glsl330,essl300");
  verb->callback([options, &status] { status = build(*options); });
}

}  // namespace plugc

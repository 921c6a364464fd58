// plugc preview: a scene or a package as a picture. The context is made in a second thread while the first one compiles, and
// taken down there while the first one writes the picture.

#include <algorithm>
#include <fstream>
#include <future>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/field_setting.h"
#include "cli/frame_series.h"
#include "cli/picture_size.h"
#include "image/write_png.h"
#include "runtime/render.h"
#include "scene/library_stage.h"

namespace plugc {
namespace {

struct PreviewOptions {
  CommonOptions common;
  std::string input;
  std::string output;
  std::string size = "1280x720";
  std::string viewpoint;
  std::string stage = "teapot";
  std::string effect;
  std::uint32_t samples = 1;
  std::vector<std::string> settings;
  FrameSeries series;
  bool no_shadows = false;
  bool statistics = false;
};

RendererOptions renderer_options(const PreviewOptions& options) {
  constexpr std::uint32_t kManyPictures = 60;  // from which on well generated code pays
  RendererOptions renderer;
  renderer.single_picture = options.series.pictures() < kManyPictures;
  if (!options.common.no_cache) renderer.cache_folder = cache_folder("mesa").string();
  return renderer;
}

/// What is to be drawn.
struct Choice {
  const Package* package = nullptr;  ///< Null: nothing, there was an error.
  std::uint32_t scene = 0;
  std::vector<FieldSetting> settings;
};

/// What the drawing thread leaves behind.
struct Drawn {
  std::string error;
  Picture picture;  ///< The last one; those before it are written.
  FrameStatistics statistics;
  std::vector<std::string> messages;
};

/// Finds the effect of a library, the first one where none is named, and which shape shows it; false when there is none.
bool choose_effect(const Package& package, const PreviewOptions& options, std::uint32_t& scene,
                   std::vector<FieldSetting>& settings) {
  for (const PackedEffect* effect : *package.effects()) {
    if (!options.effect.empty() && effect->name()->string_view() != options.effect) continue;
    scene = effect->scene();
    const auto geometry = std::ranges::find(kStageGeometries, options.stage) - kStageGeometries.begin();
    const std::size_t kind = effect->kinds()->size() == 0 ? 0 : effect->kinds()->Get(0)->choice();
    const auto choice = static_cast<double>(stage_choice(static_cast<std::size_t>(geometry), kind));
    settings.push_back({std::string(kLibraryStage) + ".whichChoice", {choice}});
    return true;
  }
  return options.effect.empty();
}

bool apply(const std::vector<FieldSetting>& settings, Renderer& renderer, std::string& error) {
  return std::ranges::all_of(settings,
                             [&](const FieldSetting& one) { return renderer.set_field(one.name, one.values, error); });
}

bool write_picture(const std::string& path, const Picture& picture) {
  return write_png(path, picture.width, picture.height, picture.pixels, false);
}

/// All pictures of the series; each is written in a thread of its own while the next one is drawn. Returns the last one.
Picture draw_series(Renderer& renderer, FrameOptions frame, const PreviewOptions& options, std::string& error) {
  std::future<bool> written;
  const auto has_written = [&](std::uint32_t picture) {
    if (!written.valid() || written.get()) return true;
    error = fmt::format("cannot write `{}`", picture_name(options.output, options.series, picture));
    return false;
  };
  const std::uint32_t last = options.series.pictures() - 1;
  for (std::uint32_t i = 0; i < last; ++i) {
    frame.time = options.series.time_of(i);
    Picture picture = renderer.draw(frame);
    if (i != 0 && !has_written(i - 1)) return {};
    written =
        std::async(std::launch::async, write_picture, picture_name(options.output, options.series, i), std::move(picture));
  }
  frame.time = options.series.time_of(last);
  Picture picture = renderer.draw(frame);
  if (last != 0 && !has_written(last - 1)) return {};
  return picture;
}

/// Makes the context at once, then waits for the package. All GL of a renderer happens in one thread, its end too.
void draw(const PreviewOptions& options, const FrameOptions& frame, std::future<Choice> chosen, std::promise<Drawn> done) {
  Drawn drawn;
  const std::unique_ptr<Renderer> renderer = Renderer::make(renderer_options(options), drawn.error);
  const Choice choice = chosen.get();
  if (renderer != nullptr && choice.package != nullptr && renderer->load(*choice.package, choice.scene, drawn.error) &&
      apply(choice.settings, *renderer, drawn.error)) {
    drawn.picture = draw_series(*renderer, frame, options, drawn.error);
    drawn.statistics = renderer->statistics();
    drawn.messages = renderer->messages();
  }
  done.set_value(std::move(drawn));
}

/// The package's bytes, read or compiled; `status` says how it went.
std::vector<std::uint8_t> package_bytes(const PreviewOptions& options, const std::vector<FieldSetting>& settings,
                                        Validator* validator, int& status) {
  if (validator == nullptr) {
    std::ifstream stream(options.input, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions compile_with = compile_options(options.common);
  compile_with.stage = options.stage;
  for (const FieldSetting& one : settings) compile_with.dynamic.push_back(one.name);
  const Compilation made = compile({options.input}, compile_with, *validator, sources, diagnostics);
  status = report(diagnostics);
  return write_package(made.package);
}

int preview(const PreviewOptions& options) {
  const auto size = read_picture_size(options.size);
  if (!size) refuse_picture_size(options.size);
  if (!size || !check_series(options.series)) return kBrokenUse;
  FrameOptions frame;
  frame.width = size->width;
  frame.height = size->height;
  std::vector<FieldSetting> settings;
  for (const std::string& text : options.settings) {
    const auto setting = read_field_setting(text);
    if (!setting) {
      fmt::print(stderr, "plugc: `--set {}` sets nothing; write DEF.field=VALUE, e.g. Glow.enabled=FALSE\n", text);
      return kBrokenUse;
    }
    settings.push_back(*setting);
  }
  frame.viewpoint = options.viewpoint;
  frame.samples = options.samples;
  frame.shadows = !options.no_shadows;
  const bool packed = is_package_file(options.input);
  if (packed && !options.common.shadows.empty()) return refuse_shadows_of_package();
  std::unique_ptr<Validator> validator;  // forks, so it is made before the drawing thread starts
  if (!packed) validator = std::make_unique<Validator>(make_validator(options.common));

  std::vector<std::uint8_t> bytes;  // outlives the drawing thread
  std::promise<Choice> choice;
  std::promise<Drawn> done;
  std::future<Drawn> picture = done.get_future();
  const auto drawing = std::async(std::launch::async, draw, options, frame, choice.get_future(), std::move(done));
  int status = kFine;
  bytes = package_bytes(options, settings, validator.get(), status);
  const PackageView view = open_package(bytes);
  std::uint32_t scene = 0;
  const bool found = view.package == nullptr || choose_effect(*view.package, options, scene, settings);
  choice.set_value({found ? view.package : nullptr, scene, settings});
  validator.reset();
  const Drawn drawn = picture.get();

  for (const std::string& message : drawn.messages) fmt::print(stderr, "{}\n", message);
  const std::string no_effect =
      fmt::format("there is no effect `{}`; `plugc inspect` lists those of a library", options.effect);
  const std::string& error = view.package == nullptr ? view.error : found ? drawn.error : no_effect;
  if (!error.empty()) {
    fmt::print(stderr, "plugc: {}: {}\n", options.input, error);
    return packed && view.package == nullptr ? kInputErrors : kBrokenUse;
  }
  const std::string output = picture_name(options.output, options.series, options.series.pictures() - 1);
  if (!write_picture(output, drawn.picture)) {
    fmt::print(stderr, "plugc: cannot write `{}`\n", output);
    return kBrokenUse;
  }
  if (options.statistics) {
    fmt::print("{} draw calls, {} programs, {} shadow passes with {} draw calls\n", drawn.statistics.draw_calls,
               drawn.statistics.programs_used, drawn.statistics.shadow_passes, drawn.statistics.shadow_draw_calls);
  }
  return status;
}

}  // namespace

void add_preview_command(CLI::App& app, int& status) {
  auto options = std::make_shared<PreviewOptions>();
  CLI::App* verb = app.add_subcommand("preview", "Draw a scene or a package into a PNG picture");
  verb->add_option("SCENE|PACKAGE", options->input, "An X3D scene or a glTF model, or a package that `plugc build` wrote")
      ->required()
      ->check(CLI::ExistingFile);
  verb->add_option("-o,--output", options->output, "The picture to write (.png)")->required();
  verb->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
  verb->add_option(
      "--viewpoint", options->viewpoint,
      "DEF name of a Viewpoint, or its number from 0 (default: the first; without any, a view of the whole scene)");
  verb->add_option("--on", options->stage, "What to try effects on when the file has no shapes: teapot, sphere, box, plane")
      ->check(CLI::IsMember({"teapot", "sphere", "box", "plane"}))
      ->capture_default_str();
  verb->add_option("--effect", options->effect, "The effect of a library to draw, by its name (default: the first)");
  verb->add_option("--samples", options->samples, "Samples a pixel; 4 smooths edges and costs time")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  verb->add_option("--set", options->settings,
                   "Draw another state: DEF.field=VALUE, e.g. Glow.enabled=FALSE; may be given several times. In a package the "
                   "field must have been built with --dynamic")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_option("--time", options->series.time, "Seconds since the scene was loaded")->capture_default_str();
  verb->add_option(
          "--frames", options->series.count,
          "Draw a series of that many pictures, with their numbers before the extension: out0000.png, out0001.png, ...")
      ->check(CLI::Range(1, 1000000));
  verb->add_option("--step", options->series.step, "Seconds from one picture of a series to the next")->capture_default_str();
  verb->add_flag("--no-shadows", options->no_shadows, "Draw everything lit, to see what shadows do");
  verb->add_flag("--statistics", options->statistics, "Print draw calls, programs and shadow passes");
  add_dynamic_option(*verb, options->common);
  add_optimize_option(*verb, options->common);
  add_shadows_option(*verb, options->common);
  add_common_options(*verb, options->common);
  add_jobs_option(*verb, options->common, "Programs that are validated at a time");
  verb->footer(
      "Draws on the CPU (OSMesa); no display is needed.\n\n"
      "Example: plugc preview scene.x3dv -o picture.png --size 800x450\n"
      "         plugc preview scene.x3dv -o film.png --frames 50 --step 0.04");
  verb->callback([options, &status] { status = preview(*options); });
}

}  // namespace plugc

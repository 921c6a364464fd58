// THE PIPELINE, one call a phase. Each phase is a function from plain data to plain data; what is wrong is in `diagnostics`.

#include "compile.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "base/clean_text.h"
#include "compile_library.h"
#include "document/read_document.h"
#include "document/read_gltf.h"
#include "document/write_document.h"
#include "lint/lint.h"
#include "prepare_scene.h"
#include "scene/library_effects.h"
#include "scene/library_stage.h"
#include "scene/node_graph.h"
#include "scene/stage.h"
#include "scene/type_document.h"
#include "validate/validate_states.h"

namespace plugc {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time of its life to a sum, in milliseconds.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& sum) : sum_(sum) {}
  ~PhaseTimer() { sum_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& sum_;
  Clock::time_point start_ = Clock::now();
};

std::optional<SourceId> read_scene_file(const std::filesystem::path& path, FileAccess& files, SourceSet& sources,
                                        Diagnostics& diagnostics) {
  FileContent content = files.read(path);
  if (content.status == FileStatus::ok) return add_clean_text(sources, path.string(), std::move(content.bytes), diagnostics);
  report_unreadable(content.status, path.string(), {}, diagnostics);
  return std::nullopt;
}

std::optional<Document> read_stage(std::string_view name, SourceSet& sources, Diagnostics& diagnostics) {
  if (name.empty()) return std::nullopt;
  return read_document(sources.add("stage.x3dv", stage_scene(name)), sources, diagnostics);
}

/// A graph with the scene that it means.
struct LoadedScene {
  NodeGraph graph;
  Scene scene;
  SourceId source;  ///< Not valid when the file cannot be read.
};

SceneOptions scene_options(const std::filesystem::path& path, const CompileOptions& options) {
  SceneOptions scene;
  scene.all_branches = options.for_lint;
  scene.dynamic = options.dynamic;
  scene.shadows = options.shadows;
  if (const auto found = options.shadow_choices.find(path); found != options.shadow_choices.end())
    scene.choices = found->second;
  return scene;
}

/// The scene of one file; with `stage`, what stands on that stage too.
LoadedScene load_scene(SourceId source, const std::filesystem::path& path, std::string_view stage,
                       const CompileOptions& options, FileAccess& files, SourceSet& sources, Diagnostics& diagnostics) {
  LoadedScene loaded;
  Document document = read_document(source, path, files, sources, diagnostics);
  // from here everything that was written has a place
  loaded.graph = build_graph(std::move(document), path, sources, files, diagnostics, read_stage(stage, sources, diagnostics));
  // from here every USE is resolved, every prototype expanded, every Inline loaded, every value typed
  loaded.scene = build_scene(loaded.graph, sources, files, scene_options(path, options), diagnostics);
  loaded.scene.name = path.filename().string();
  // from here shapes know their lights, textures, effects and shadow maps
  return loaded;
}

LoadedScene load_scene(const std::filesystem::path& path, const CompileOptions& options, FileAccess& files, SourceSet& sources,
                       Diagnostics& diagnostics) {
  const auto source = read_scene_file(path, files, sources, diagnostics);
  if (!source) return {};
  LoadedScene loaded = load_scene(*source, path, "", options, files, sources, diagnostics);
  loaded.source = *source;
  const bool has_effects = !loaded.scene.effects.empty() || !loaded.scene.screen_effects.empty();
  const bool needs_stage = !has_world_shapes(loaded.scene) && has_effects && !options.stage.empty();
  return needs_stage ? load_scene(*source, path, options.stage, options, files, sources, diagnostics) : std::move(loaded);
}

void add(const ValidationStatistics& validation, CompileStatistics& sum) {
  sum.compose += validation.compose_milliseconds;
  sum.validate += validation.validate_milliseconds;
  sum.compositions += validation.compositions;
  sum.rechecks += validation.rechecks;
}

/// What every verb does with a scene: from recipes to programs that are valid.
PreparedScene make_programs(LoadedScene loaded, PreparedFor purpose, const CompileOptions& options, FileAccess& files,
                            TemplateLibrary& templates, Validator& validator, Diagnostics& diagnostics,
                            CompileStatistics& statistics) {
  auto timer = std::make_unique<PhaseTimer>(statistics.prepare);
  if (const auto& pair = options.arrangement) arrange_pair(loaded.scene, pair->first, pair->second, pair->order);
  MeshCache meshes;
  PreparedScene prepared =
      prepare_scene(loaded.graph, std::move(loaded.scene), purpose, files, diagnostics, meshes, options.known_images);
  // from here geometry is triangles, images are pixels, effects are outlined, and every shape has its recipe
  timer.reset();
  ValidationStatistics validation;
  prepared.parts.programs = validate_states(prepared.recipes, compose_input(prepared, templates),
                                            {options.targets, options.optimize}, validator, diagnostics, validation);
  // from here no PLUG marker remains, and every program is valid
  add(validation, statistics);
  if (options.for_lint) lint_scene(prepared.parts.scene, prepared.effects, diagnostics);
  return prepared;
}

SceneParts compile_scene(LoadedScene loaded, const CompileOptions& options, FileAccess& files, Validator& validator,
                         SourceSet& sources, Diagnostics& diagnostics, CompileStatistics& statistics) {
  TemplateLibrary templates(sources);
  PreparedScene prepared =
      make_programs(std::move(loaded), PreparedFor::drawing, options, files, templates, validator, diagnostics, statistics);
  SceneParts& parts = prepared.parts;
  for (const ValidRecipe& program : parts.programs) {
    parts.program_names.push_back(to_text(program.used, parts.scene));
    if (options.measure)
      parts.costs.push_back(
          measure_costs(program.used, compose_input(prepared, templates), options.targets.front(), sources, validator));
  }
  // from here every program is named by what it holds
  return std::move(parts);
}

/// A file without shapes: each of its effects on the built-in stage.
std::vector<SceneParts> compile_library_file(SourceId source, const std::filesystem::path& path, const CompileOptions& options,
                                             FileAccess& files, Validator& validator, SourceSet& sources,
                                             Diagnostics& diagnostics, CompileStatistics& statistics) {
  Document document = read_document(source, path, files, sources, diagnostics);
  const SourceId stage = sources.add("library_stage.x3dv", library_stage_scene());
  const NodeGraph graph =
      build_graph(std::move(document), path, sources, files, diagnostics, read_document(stage, sources, diagnostics));
  ValidationStatistics validation;
  auto parts = compile_library(graph, sources, files, {options.targets, options.optimize}, options.shadows, validator,
                               diagnostics, validation);
  add(validation, statistics);
  return parts;
}

/// Screen effects beside the effects of a library: nothing of a library is drawn as a whole.
void report_left_out(const NodeGraph& graph, const std::vector<SceneScreenEffect>& effects, Diagnostics& diagnostics) {
  for (const SceneScreenEffect& effect : effects)
    diagnostics.report(DiagnosticId::not_drawn, graph[effect.node].type_span,
                       "a `ScreenEffect` among the effects of a library is left out; give it a file of its own");
}

/// One scene, or one for each effect of a library.
std::vector<SceneParts> compile_file(const std::filesystem::path& path, const CompileOptions& options, Validator& validator,
                                     SourceSet& sources, Diagnostics& diagnostics, Compilation& compilation) {
  CompileStatistics& statistics = compilation.statistics;
  DiskFiles files(options.root.empty() ? default_root(path) : options.root);
  auto timer = std::make_unique<PhaseTimer>(statistics.read);
  LoadedScene loaded = load_scene(path, options, files, sources, diagnostics);
  timer.reset();
  std::vector<SceneParts> parts;
  const bool is_library = loaded.source.valid() && !has_world_shapes(loaded.scene) && !library_effects(loaded.graph).empty();
  if (options.library && is_library) report_left_out(loaded.graph, loaded.scene.screen_effects, diagnostics);
  if (options.library && is_library)
    parts = compile_library_file(loaded.source, path, options, files, validator, sources, diagnostics, statistics);
  else
    parts.push_back(compile_scene(std::move(loaded), options, files, validator, sources, diagnostics, statistics));
  compilation.files_read.insert(files.files_read().begin(), files.files_read().end());
  return parts;
}

std::vector<std::string> known_dynamic(const std::vector<SceneParts>& parts) {
  std::vector<std::string> known;
  for (const SceneParts& part : parts)
    known.insert(known.end(), part.scene.known_dynamic.begin(), part.scene.known_dynamic.end());
  return known;
}

void report_unknown_dynamic(const std::vector<std::string>& names, const std::vector<std::string>& known,
                            Diagnostics& diagnostics) {
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) != known.end()) continue;
    diagnostics.report(DiagnosticId::dynamic_field, {},
                       fmt::format("no node is named as `--dynamic {}` says; write `DEF.field`", name));
  }
}

}  // namespace

Compilation compile(const std::vector<std::filesystem::path>& scenes, const CompileOptions& options, Validator& validator,
                    SourceSet& sources, Diagnostics& diagnostics) {
  Compilation compilation;
  std::vector<SceneParts> parts;
  for (const std::filesystem::path& path : scenes) {
    std::vector<SceneParts> made = compile_file(path, options, validator, sources, diagnostics, compilation);
    std::ranges::move(made, std::back_inserter(parts));
  }
  report_unknown_dynamic(options.dynamic, known_dynamic(parts), diagnostics);
  const PhaseTimer timer(compilation.statistics.assemble);
  AssembledPackage assembled = assemble_package(std::move(parts), sources, fmt::format("plugc {}", PLUGC_VERSION));
  compilation.package = std::move(assembled.package);
  compilation.costs = std::move(assembled.costs);
  return compilation;
}

void lint(const std::filesystem::path& scene, CompileOptions options, Validator& validator, SourceSet& sources,
          Diagnostics& diagnostics) {
  options.for_lint = true;
  DiskFiles files(options.root.empty() ? default_root(scene) : options.root);
  TemplateLibrary templates(sources);
  CompileStatistics statistics;
  LoadedScene loaded = load_scene(scene, options, files, sources, diagnostics);
  const PreparedScene checked =
      make_programs(std::move(loaded), PreparedFor::checking, options, files, templates, validator, diagnostics, statistics);
  report_unknown_dynamic(options.dynamic, checked.parts.scene.known_dynamic, diagnostics);
}

std::string dump_stage(const std::filesystem::path& scene, std::string_view stage, const CompileOptions& options,
                       SourceSet& sources, Diagnostics& diagnostics) {
  DiskFiles files(options.root.empty() ? default_root(scene) : options.root);
  if (stage == "document") {
    const auto source = read_scene_file(scene, files, sources, diagnostics);
    return source ? dump_document(read_document(*source, scene, files, sources, diagnostics), sources) : "";
  }
  LoadedScene loaded = load_scene(scene, options, files, sources, diagnostics);
  if (stage == "scene") return dump_graph(loaded.graph, sources) + dump_scene(loaded.scene);
  std::string text;
  if (stage != "recipes") return text;
  MeshCache meshes;
  const PreparedScene prepared =
      prepare_scene(loaded.graph, std::move(loaded.scene), PreparedFor::checking, files, diagnostics, meshes);
  for (std::size_t i = 0; i < prepared.recipes.size(); ++i)
    text += fmt::format("{} {}\n", i, to_text(prepared.recipes[i].recipe, prepared.parts.scene));
  return text;
}

std::vector<SceneEffectPair> effect_pairs(const std::filesystem::path& scene, const CompileOptions& options, SourceSet& sources,
                                          Diagnostics& diagnostics) {
  DiskFiles files(options.root.empty() ? default_root(scene) : options.root);
  LoadedScene loaded = load_scene(scene, options, files, sources, diagnostics);
  MeshCache meshes;
  const PreparedScene prepared =
      prepare_scene(loaded.graph, std::move(loaded.scene), PreparedFor::checking, files, diagnostics, meshes);
  const std::vector<SceneEffect>& effects = prepared.parts.scene.effects;
  std::vector<SceneEffectPair> pairs;
  for (EffectPair& pair : find_effect_pairs(prepared.parts.scene, prepared.effects)) {
    const SceneEffect& first = effects[static_cast<std::size_t>(pair.first)];
    const SceneEffect& second = effects[static_cast<std::size_t>(pair.second)];
    SceneEffectPair found{pair.first, pair.second, first.label, second.label, std::move(pair.plugs), {}};
    for (const SceneEffect* effect : {&first, &second}) {
      for (const ShaderField& field : effect->fields) {
        if (field.slot != kSceneNoSlot) found.slots.push_back(field.slot);
      }
    }
    pairs.push_back(std::move(found));
  }
  return pairs;
}

std::string write_scene(const std::filesystem::path& scene, Encoding as, const CompileOptions& options, SourceSet& sources,
                        Diagnostics& diagnostics) {
  DiskFiles files(options.root.empty() ? default_root(scene) : options.root);
  const auto source = read_scene_file(scene, files, sources, diagnostics);
  return source ? write_document(type_document(read_document(*source, scene, files, sources, diagnostics)), as) : "";
}

}  // namespace plugc

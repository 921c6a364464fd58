// The scene is compiled by one method after another, as the search asks for them: the choice of one light never needs
// another's. Pictures to search with are small; what the search finds is drawn once more in the size that was asked for.

#include "cli/choose_shadows.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "runtime/measure/shadow_cost.h"

namespace plugc {
namespace {

constexpr double kMostSearchPixels = 1e6;  // of all viewpoints together
constexpr double kMostFinalPixels = 16e6;
constexpr double kSearchScale = 0.5;  // of the sides that were asked for

/// What may be chosen. Left out is what never was the cheapest in the laboratory: what `sharp3` takes more than `pcf3` brings
/// more with a larger map, `poisson` reads more for less, maps of moments are blurred for more than a larger map costs.
constexpr ShadowMethod kChoices[] = {ShadowMethod::hard, ShadowMethod::bilinear, ShadowMethod::pcf2, ShadowMethod::pcf3,
                                     ShadowMethod::pcf4};

PackedShadowMethod packed(ShadowMethod method) {
  return static_cast<PackedShadowMethod>(method);
}

/// The scene on the GPU, by each method that is asked for.
class MethodScenes {
 public:
  MethodScenes(std::filesystem::path scene, CompileOptions options, Validator& validator, Studio& studio)
      : scene_(std::move(scene)), options_(std::move(options)), validator_(validator), studio_(studio) {
    options_.targets = {Target::glsl330};
    options_.measure = false;
  }

  /// What could be made of it, mistakes or not; null where it is a library.
  MeasuredScene* with(ShadowMethod method) {
    auto& made = scenes_[method];
    if (made == nullptr) made = compile_by(method);
    return made.get();
  }

 private:
  std::unique_ptr<MeasuredScene> compile_by(ShadowMethod method) {
    options_.shadows.method = method;
    SourceSet sources;
    Diagnostics diagnostics(sources);
    const Compilation made = compile({scene_}, options_, validator_, sources, diagnostics);
    if (made.package.scenes.size() != 1 || !made.package.effects.empty()) return nullptr;
    return load_measured_scene(studio_, write_package(made.package), {});
  }

  std::filesystem::path scene_;
  CompileOptions options_;
  Validator& validator_;
  Studio& studio_;
  std::map<ShadowMethod, std::unique_ptr<MeasuredScene>> scenes_;
};

/// All that is done for one scene.
class Chooser {
 public:
  Chooser(MethodScenes& scenes, Studio& studio, const CompileOptions& options, const ShadowErrorRequest& request)
      : scenes_(scenes), studio_(studio), options_(options), request_(request), base_method_(first_method()) {}

  std::vector<ChosenShadow> choose_all();

 private:
  ShadowMethod first_method() const { return request_.method_given ? options_.shadows.method : ShadowMethod::hard; }
  MeasuredScene& base() { return *scenes_.with(base_method_); }
  const PackedShadowMap& packed_map(std::uint32_t map) { return *base().loaded.packed->shadow_maps()->Get(map); }

  std::optional<ChosenShadow> choose(std::uint32_t map);
  std::vector<ShadowMethod> methods_for(const PackedShadowMap& map);
  ShadowTask task_for(const PackedShadowMap& map, const LightJudge& judge);
  void search(const LightJudge& judge, ChosenShadow& chosen);
  void trace_instead(const LightJudge& judge, ChosenShadow& chosen);
  double final_error(const LightJudge& judge, const ShadowConfiguration& configuration);

  MethodScenes& scenes_;
  Studio& studio_;
  const CompileOptions& options_;
  const ShadowErrorRequest& request_;
  ShadowMethod base_method_;
  JudgedScene judged_;
  std::vector<FrameOptions> search_frames_, final_frames_;
};

/// What an effect moves is not where a tracer thinks it is.
void drop_tracer_of_moving_casters(JudgedScene& judged) {
  const bool moves = std::ranges::any_of(judged.surfaces, [](const Surface& one) { return one.casts && one.may_move; });
  if (!moves || judged.tracer == nullptr) return;
  judged.tracer.reset();
  judged.why_not_traced = "an effect may move what casts";
}

std::vector<ChosenShadow> Chooser::choose_all() {
  std::vector<ChosenShadow> all;
  if (scenes_.with(base_method_) == nullptr) return all;
  const PackedScene& scene = *base().loaded.packed;
  judged_ = read_judged_scene(base());
  drop_tracer_of_moving_casters(judged_);
  const auto search_width = static_cast<std::uint32_t>(std::max(1.0, kSearchScale * request_.width));
  const auto search_height = static_cast<std::uint32_t>(std::max(1.0, kSearchScale * request_.height));
  search_frames_ = viewpoint_frames(scene, search_width, search_height, kMostSearchPixels);
  final_frames_ = viewpoint_frames(scene, request_.width, request_.height, kMostFinalPixels);
  for (std::uint32_t map = 0; map < scene.shadow_maps()->size(); ++map) {
    if (!has_shadow(base(), map)) continue;
    if (auto chosen = choose(map)) all.push_back(std::move(*chosen));
  }
  return all;
}

std::vector<ShadowMethod> Chooser::methods_for(const PackedShadowMap& map) {
  if (map.method_written() || request_.method_given) return {static_cast<ShadowMethod>(map.method())};
  std::vector<ShadowMethod> methods;
  for (const ShadowMethod method : kChoices) {
    const bool seen = map.author_visible() && method == ShadowMethod::hard;  // the nearest texel, where an author reads
    const bool made_for_it = !is_cube(*base().loaded.packed, map) || method_for_cube(method) == method;
    if (!seen && made_for_it) methods.push_back(method);
  }
  return methods;
}

ShadowTask Chooser::task_for(const PackedShadowMap& map, const LightJudge& judge) {
  ShadowTask task;
  task.budget = request_.budget;
  task.floor_of_texel = judge.floor_of_texel;
  task.receiver_pixels = judge.counted_share * request_.width * request_.height;
  if (map.size_written() || options_.shadows.size != 0) task.size = map.size();
  const double written_scale = base().loaded.slots.number(map.scale(), 0);
  task.faces = is_cube(*base().loaded.packed, map) ? 6 : 1;
  const std::uint32_t largest = largest_map_size(*base().loaded.packed, judge.map);
  for (const ShadowMethod method : methods_for(map)) {
    const double scale = map.scale_written() ? written_scale : automatic_slope_scale(method);
    task.candidates.push_back({packed(method), scale, largest});
  }
  return task;
}

double Chooser::final_error(const LightJudge& judge, const ShadowConfiguration& configuration) {
  MeasuredScene& scene = *scenes_.with(static_cast<ShadowMethod>(configuration.method));
  return drawn_error(studio_, scene, base(), judged_, final_frames_, judge, configuration);
}

void take(const ShadowTrial& trial, double error, ChosenShadow& chosen) {
  chosen.choice.method = static_cast<ShadowMethod>(trial.configuration.method);
  chosen.choice.size = trial.configuration.size;
  chosen.choice.scale = trial.configuration.scale;
  chosen.choice.error = error;
}

void Chooser::search(const LightJudge& judge, ChosenShadow& chosen) {
  ShadowSearch search(chosen.task);
  for (;;) {
    while (const auto next = search.next()) {
      MeasuredScene& scene = *scenes_.with(static_cast<ShadowMethod>(next->method));
      search.record(*next, measured_error(studio_, scene, judge, *next));
    }
    const ShadowTrial* const best = search.best() != nullptr ? search.best() : search.nearest();
    const double error = final_error(judge, best->configuration);
    take(*best, error, chosen);
    chosen.trials = search.trials();
    if (error <= request_.budget || search.best() == nullptr) return;
    search.correct(best->configuration, error);
  }
}

/// The last resort, as packages with it need Embree where they are drawn.
void Chooser::trace_instead(const LightJudge& judge, ChosenShadow& chosen) {
  const PackedShadowMap& map = packed_map(judge.map);
  if (judged_.tracer == nullptr || map.author_visible() || map.method_written() || request_.method_given) return;
  const MeasuredScene* const scene = scenes_.with(ShadowMethod::traced);  // the compiler may know why it cannot be traced
  if (scene == nullptr || scene->loaded.packed->shadow_maps()->Get(judge.map)->method() != PackedShadowMethod::traced) return;
  const ShadowConfiguration traced{PackedShadowMethod::traced, map.size(), 0};
  const double error = final_error(judge, traced);
  if (error >= chosen.choice.error) return;
  const ShadowTrial trial{traced, error, shadow_cost(traced.method, traced.size, chosen.task.receiver_pixels, 1)};
  chosen.trials.push_back(trial);
  take(trial, error, chosen);
}

std::optional<ChosenShadow> Chooser::choose(std::uint32_t map) {
  const bool traced = packed_map(map).method() == PackedShadowMethod::traced;
  if (traced && judged_.tracer == nullptr) return std::nullopt;  // it stays lit here, and nothing says what it should be
  const LightJudge judge = make_light_judge(studio_, base(), judged_, search_frames_, map);
  if (judge.views.empty()) return std::nullopt;
  ChosenShadow chosen;
  chosen.light = base().loaded.packed->lights()->Get(packed_map(map).light())->name()->str();
  chosen.choice.map = map;
  chosen.choice.budget = request_.budget;
  chosen.choice.views = static_cast<std::uint32_t>(judge.views.size());
  chosen.choice.traced_truth = judged_.tracer != nullptr;
  chosen.why_not_traced = judged_.why_not_traced;
  chosen.shadowed_share = judge.shadowed_share;
  chosen.task = task_for(packed_map(map), judge);
  search(judge, chosen);
  if (chosen.choice.error > request_.budget) trace_instead(judge, chosen);
  return chosen;
}

std::string name_of(const ShadowConfiguration& configuration) {
  const auto method = to_text(static_cast<ShadowMethod>(configuration.method));
  if (configuration.method == PackedShadowMethod::traced) return std::string(method);
  return fmt::format("{} {}", method, configuration.size);
}

}  // namespace

std::optional<double> read_percentage(std::string_view text) {
  double percent = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), percent, std::chars_format::fixed);
  const bool whole = end.ec == std::errc() && std::string_view(end.ptr, text.data() + text.size()) == "%";
  if (!whole || !(percent > 0) || !(percent < 100)) return std::nullopt;
  return percent / 100;
}

std::vector<ChosenShadow> choose_shadows(const std::filesystem::path& scene, const CompileOptions& options,
                                         const ShadowErrorRequest& request, Validator& validator, Studio& studio) {
  MethodScenes scenes(scene, options, validator, studio);
  return Chooser(scenes, studio, options, request).choose_all();
}

std::string explain(const ChosenShadow& chosen) {
  const ShadowChoice& choice = chosen.choice;
  const ShadowConfiguration taken{packed(choice.method), choice.size, choice.scale};
  const auto percent = [](double share) { return fmt::format("{:.3g} %", 100 * share); };
  std::string text = fmt::format("shadow of `{}`: {}, slope scale {:g}: {} of pixels wrong, {} allowed{}\n", chosen.light,
                                 name_of(taken), choice.scale, percent(choice.error), percent(choice.budget),
                                 choice.error > choice.budget ? ": NOT KEPT" : "");
  text +=
      fmt::format("  {} view{}, {:.0f} pixels each show it, {} of them dark; a hard map of 1024 texels has at least {} wrong\n",
                  choice.views, choice.views == 1 ? "" : "s", chosen.task.receiver_pixels, percent(chosen.shadowed_share),
                  percent(chosen.task.floor_of_texel / 1024));
  text += fmt::format("  measured against {}\n",
                      choice.traced_truth ? "traced shadows" : "the largest map: " + chosen.why_not_traced);
  for (const ShadowTrial& trial : chosen.trials) {
    text += fmt::format("  tried {}: {}, costs {:.1f}{}\n", name_of(trial.configuration), percent(trial.error), trial.cost,
                        trial.configuration == taken ? " <- taken" : "");
  }
  return text;
}

}  // namespace plugc

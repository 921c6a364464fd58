// What --shadow-error chooses, against the cheapest of all methods and sizes. Each scene is judged once; every method at every
// size is measured against that, and then each budget is given to the chooser, whose package is drawn and judged anew.

#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "cli/choose_shadows.h"
#include "runtime/measure/shadow_cost.h"
#include "shadows/compile_scene.h"
#include "shadows/experiments.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr double kBudgets[] = {0.0025, 0.005, 0.01, 0.02};

/// Every map of a scene by every method and size.
struct ExhaustiveTrials {
  std::unique_ptr<MeasuredScene> scene;  ///< By `hard`: what is judged points into it.
  JudgedScene judged;
  std::vector<LightJudge> lights;
  std::vector<std::vector<ShadowTrial>> trials;  ///< By light; costs are still to be filled in.
};

/// Four an octave, as multiples of what the chooser may take.
std::vector<std::uint32_t> sizes_to_try(const PackedShadowMap& map, std::uint32_t largest) {
  if (map.size_written()) return {map.size()};
  std::vector<std::uint32_t> sizes;
  for (double size = kSmallestSize; size <= largest; size *= std::pow(2.0, 0.25)) {
    const auto rounded = static_cast<std::uint32_t>(std::lround(size / kSizeStep)) * kSizeStep;
    if (sizes.empty() || sizes.back() != rounded) sizes.push_back(rounded);
  }
  return sizes;
}

void try_method(Lab& lab, const fs::path& scene, const std::string& method, ExhaustiveTrials& all) {
  std::string error;
  const std::vector<std::uint8_t> bytes = compile_scene(scene, method, lab.validator, error);
  if (bytes.empty()) return;
  const auto loaded = load_measured_scene(lab.studio, bytes, {});
  for (std::size_t i = 0; i < all.lights.size(); ++i) {
    const PackedShadowMap& map = *loaded->loaded.packed->shadow_maps()->Get(all.lights[i].map);
    for (const std::uint32_t size : sizes_to_try(map, largest_map_size(*loaded->loaded.packed, all.lights[i].map))) {
      const double scale = loaded->loaded.slots.number(map.scale(), 0);
      const ShadowConfiguration configuration{map.method(), size, scale};
      all.trials[i].push_back({configuration, measured_error(lab.studio, *loaded, all.lights[i], configuration), 0});
    }
  }
}

/// Nothing where the scene cannot be judged.
ExhaustiveTrials try_everything(Lab& lab, const fs::path& scene) {
  ExhaustiveTrials all;
  std::string error;
  const std::vector<std::uint8_t> bytes = compile_scene(scene, "hard", lab.validator, error);
  if (bytes.empty()) return all;
  all.scene = load_measured_scene(lab.studio, bytes, {});
  MeasuredScene* const loaded = all.scene.get();
  all.judged = read_judged_scene(*loaded);
  const auto frames = judged_frames(*loaded->package.package, lab.quick);
  for (std::uint32_t map = 0; map < loaded->loaded.shadow_maps.size(); ++map) {
    if (!has_shadow(*loaded, map)) continue;
    LightJudge light = make_light_judge(lab.studio, *loaded, all.judged, frames, map);
    if (!light.views.empty()) all.lights.push_back(std::move(light));
  }
  all.trials.resize(all.lights.size());
  for (const std::string& method : lab.methods) {
    if (method != "traced") try_method(lab, scene, method, all);
  }
  return all;
}

/// The cheapest within the budget; costs nothing where there is none.
ShadowTrial cheapest(const std::vector<ShadowTrial>& trials, double budget, const ShadowTask& task) {
  ShadowTrial best;
  for (ShadowTrial trial : trials) {
    trial.cost = shadow_cost(trial.configuration.method, trial.configuration.size, task.receiver_pixels, task.faces);
    if (trial.error <= budget && (best.cost == 0 || trial.cost < best.cost)) best = trial;
  }
  return best;
}

std::string method_name(PackedShadowMethod method) {
  return std::string(to_text(static_cast<ShadowMethod>(method)));
}

/// The error that the package has which is built with the choice.
double built_error(Lab& lab, const fs::path& scene, const ChosenShadow& chosen, const ExhaustiveTrials& all,
                   const LightJudge& light) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions options;
  options.shadow_choices[scene] = {chosen.choice};
  const Compilation made = compile({scene}, options, lab.validator, sources, diagnostics);
  const auto built = load_measured_scene(lab.studio, write_package(made.package), {});
  const PackedShadowMap& map = *built->loaded.packed->shadow_maps()->Get(light.map);
  const ShadowConfiguration configuration{map.method(), map.size(), built->loaded.slots.number(map.scale(), 0)};
  const auto frames = viewpoint_frames(*built->loaded.packed, 1280, 720, 16e6);
  return drawn_error(lab.studio, *built, *all.scene, all.judged, frames, light, configuration);
}

void evaluate(Lab& lab, const fs::path& scene, double budget, const ExhaustiveTrials& all, std::ofstream& file) {
  const ShadowErrorRequest request{budget, 1280, 720, false};
  const std::vector<ChosenShadow> chosen = choose_shadows(scene, {}, request, lab.validator, lab.studio);
  for (const ChosenShadow& one : chosen) {
    for (std::size_t i = 0; i < all.lights.size(); ++i) {
      if (all.lights[i].map != one.choice.map) continue;
      const ShadowTrial best = cheapest(all.trials[i], budget, one.task);
      const double cost = shadow_cost(static_cast<PackedShadowMethod>(one.choice.method), one.choice.size,
                                      one.task.receiver_pixels, one.task.faces);
      file << csv_line({scene.stem().string(), one.light, std::string(to_text(one.choice.method)),
                        best.cost > 0 ? method_name(best.configuration.method) : "none"},
                       {budget, double(one.choice.size), one.choice.error, built_error(lab, scene, one, all, all.lights[i]),
                        cost, double(best.configuration.size), best.cost, double(one.trials.size()), one.task.floor_of_texel});
      file.flush();
    }
  }
}

}  // namespace

void evaluate_budgets(Lab& lab) {
  std::ofstream file(lab.output / "budget.csv");
  file << "scene,light,method,cheapest_method,budget,size,error,built_error,cost,cheapest_size,cheapest_cost,trials,floor_of_"
          "texel\n";
  std::ofstream everything(lab.output / "everything.csv");
  everything << "scene,method,size,scale,error,floor\n";
  for (const fs::path& scene : lab.scenes) {
    const ExhaustiveTrials all = try_everything(lab, scene);
    for (std::size_t i = 0; i < all.lights.size(); ++i) {
      for (const ShadowTrial& trial : all.trials[i]) {
        const ShadowConfiguration& c = trial.configuration;
        everything << csv_line({scene.stem().string(), method_name(c.method)},
                               {double(c.size), c.scale, trial.error, all.lights[i].floor_of_texel / c.size});
      }
    }
    everything.flush();
    for (const double budget : kBudgets) evaluate(lab, scene, budget, all, file);
  }
}

}  // namespace plugc

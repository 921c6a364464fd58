// Two kinds of shape are alike to an effect when its functions are called at the same plugs in the same stages, as often. So
// each kind is composed once for a look at the calls, and of those that are alike the first is kept; only what is kept is
// validated and packed.

#include "compile_library.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "prepare_scene.h"
#include "scene/library_effects.h"
#include "scene/library_stage.h"

namespace plugc {
namespace {

constexpr std::size_t kKindCount = kStageKinds.size();

/// The kind of the stage's shape; nothing for the floor.
std::optional<std::size_t> kind_of(const Scene& scene, const SceneShape& shape) {
  if (shape.transform < 0) return std::nullopt;
  const SceneTransform& transform = scene.transforms[static_cast<std::size_t>(shape.transform)];
  if (transform.switch_slot == kSceneNoSlot) return std::nullopt;
  return static_cast<std::size_t>(transform.choice) % kKindCount;
}

/// The first shape of each kind.
std::vector<std::size_t> first_shapes(const Scene& scene) {
  std::vector<std::size_t> shapes(kKindCount, 0);
  for (std::size_t i = scene.shapes.size(); i-- > 0;) {
    if (const auto kind = kind_of(scene, scene.shapes[i])) shapes[*kind] = i;
  }
  return shapes;
}

class LibraryScene {
 public:
  LibraryScene(PreparedScene& prepared, SourceSet& sources) : prepared_(prepared), templates_(sources), sources_(sources) {}

  void choose_kinds(const Diagnostics& diagnostics);
  void drop_other_kinds();
  void validate(const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                ValidationStatistics& statistics);
  void describe();

 private:
  SceneParts& parts() { return prepared_.parts; }
  ComposeInput input() { return compose_input(prepared_, templates_); }
  int program_of(std::size_t kind) { return parts().shapes[first_shapes(parts().scene)[kind]].variants.front().program; }

  PreparedScene& prepared_;
  TemplateLibrary templates_;
  SourceSet& sources_;
  std::vector<std::size_t> kept_;  // kinds
};

/// The one plug that is called at another moment under the other shading, in the same stage.
bool is_main_texture(const CalledPlug& call) {
  return call.plug == "main_texture_apply" || call.plug == "texture_apply";
}

/// Where nothing is called at all, one kind stands for all.
void LibraryScene::choose_kinds(const Diagnostics& diagnostics) {
  Diagnostics unheard(diagnostics.sources());
  std::set<std::vector<CalledPlug>> known;
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    const Recipe& recipe = prepared_.recipes[static_cast<std::size_t>(program_of(kind))].recipe;
    std::vector<CalledPlug> calls = compose(recipe, input(), Target::glsl330, unheard).calls;
    if (std::ranges::any_of(calls, is_main_texture))
      calls.push_back({kStageKinds[kind].gouraud ? "after lighting" : "before it", ShaderStage::fragment});
    if (!calls.empty() && known.insert(std::move(calls)).second) kept_.push_back(kind);
  }
  if (kept_.empty()) kept_.push_back(0);
}

/// Takes the shapes of other kinds out of the scene, and the recipes that nobody is left to use.
void LibraryScene::drop_other_kinds() {
  std::vector<StateRecipe> recipes;
  std::map<int, int> numbers;
  const auto renumber = [&](int& number) {
    if (number < 0) return;
    const auto [found, added] = numbers.try_emplace(number, static_cast<int>(recipes.size()));
    if (added) recipes.push_back(prepared_.recipes[static_cast<std::size_t>(number)]);
    number = found->second;
  };
  for (std::size_t i = 0; i < parts().shapes.size(); ++i) {
    ShapePlan& plan = parts().shapes[i];
    const auto kind = kind_of(parts().scene, parts().scene.shapes[i]);
    if (kind && std::ranges::find(kept_, *kind) == kept_.end()) plan = ShapePlan();
    for (PlannedVariant& variant : plan.variants) {
      renumber(variant.program);
      renumber(variant.depth_program);
      renumber(variant.point_depth_program);
    }
  }
  for (MapPlan& plan : parts().maps) {
    renumber(plan.moments_program);
    renumber(plan.blur_program);
  }
  prepared_.recipes = std::move(recipes);
}

/// Of a plug that some kind lacks nothing is said, as long as another has it; and a mistake of all kinds is said once.
void LibraryScene::validate(const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                            ValidationStatistics& statistics) {
  Diagnostics heard(diagnostics.sources());
  std::vector<Recipe> recipes;
  for (const StateRecipe& one : prepared_.recipes) recipes.push_back(one.recipe);
  parts().programs = validate_recipes(recipes, input(), options, validator, heard, statistics);
  std::set<std::string, std::less<>> filled;
  for (const ValidRecipe& program : parts().programs) {
    parts().program_names.push_back(to_text(program.used, parts().scene));
    for (const TargetProgram& target : program.targets)
      filled.insert(target.composed.plugs_filled.begin(), target.composed.plugs_filled.end());
  }
  std::set<std::tuple<DiagnosticId, std::uint32_t, std::string_view>> told;
  for (const Diagnostic& said : heard.all()) {
    const bool is_absence = said.id == DiagnosticId::effect_plug_absent;
    if (is_absence && filled.contains(plug_name(sources_.text(said.span)))) continue;
    // the same mistake in two programs may be marked up to different ends
    if (told.emplace(said.id, said.span.begin, said.message).second)
      diagnostics.report(said.id, said.span, said.message, said.related);
  }
}

void add_plug_names(const EffectCode& code, std::set<std::string>& offers) {
  for (const EffectCode::Part& part : code.parts) {
    for (const CodeUnit* unit : {part.in_vertex.get(), part.in_geometry.get(), part.in_fragment.get()}) {
      if (unit == nullptr) continue;
      for (const MarkerOutline& marker : unit->outline.markers) {
        if (marker.kind == MarkerKind::plug) offers.emplace(marker.name);
      }
    }
  }
}

void LibraryScene::describe() {
  const SceneEffect& effect = parts().scene.effects.front();
  LibraryEntry entry;
  entry.name = effect.label;
  entry.span = effect.span;
  entry.needs = prepared_.effects.front().plugs;
  std::set<std::string> offers;
  add_plug_names(prepared_.effects.front(), offers);
  entry.offers.assign(offers.begin(), offers.end());
  for (const ShaderField& field : effect.fields) {
    if (field.slot != kSceneNoSlot) entry.fields.push_back({std::string(field.name), field.slot});
  }
  for (const std::size_t kind : kept_) entry.variants.push_back({std::string(kStageKinds[kind].name), kind, program_of(kind)});
  parts().library = std::move(entry);
}

}  // namespace

std::vector<SceneParts> compile_library(const NodeGraph& graph, SourceSet& sources, FileAccess& files,
                                        const ProgramOptions& options, const ShadowDefaults& shadows, Validator& validator,
                                        Diagnostics& diagnostics, ValidationStatistics& statistics) {
  std::vector<SceneParts> all;
  MeshCache meshes;
  for (const NodeId effect : library_effects(graph)) {
    SceneOptions alone;
    alone.shadows = shadows;
    alone.alone = effect;
    alone.dynamic = {std::string(kLibraryStage) + ".whichChoice"};
    Scene scene = build_scene(graph, sources, files, alone, diagnostics);
    if (scene.effects.empty()) continue;  // in another language: reported
    scene.name = scene.effects.front().label;
    PreparedScene prepared = prepare_scene(graph, std::move(scene), PreparedFor::library, files, diagnostics, meshes);
    LibraryScene library(prepared, sources);
    library.choose_kinds(diagnostics);
    library.drop_other_kinds();
    library.validate(options, validator, diagnostics, statistics);
    library.describe();
    all.push_back(std::move(prepared.parts));
  }
  return all;
}

}  // namespace plugc

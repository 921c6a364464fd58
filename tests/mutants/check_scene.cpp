// The phases of compile.cpp, as the recipes that came to be used are no part of a package.

#include "mutants/check_scene.h"

#include "base/clean_text.h"
#include "document/read_document.h"
#include "document/read_gltf.h"
#include "prepare_scene.h"
#include "scene/stage.h"
#include "validate/validate_states.h"

namespace plugc::mutants {
namespace {

/// None where the program is missing.
Authors authors_in(const std::vector<ValidRecipe>& programs, int program) {
  Authors authors;
  if (program < 0 || programs[static_cast<std::size_t>(program)].targets.empty()) return authors;
  const Recipe& recipe = programs[static_cast<std::size_t>(program)].used;
  for (const int effect : all_effects(recipe)) authors.insert({false, effect});
  if (recipe.shader >= 0) authors.insert({true, recipe.shader});
  return authors;
}

/// With the stage under it where `staged`.
void read_scene(const EffectScene& scene, bool staged, FileAccess& files, CheckedScene& checked) {
  SourceSet& sources = *checked.sources;
  Diagnostics& diagnostics = *checked.diagnostics;
  FileContent content = files.read(scene.path);
  const SourceId source = add_clean_text(sources, scene.path.string(), std::move(content.bytes), diagnostics);
  std::optional<Document> stage;
  if (staged) stage = read_document(sources.add("stage.x3dv", stage_scene("teapot")), sources, diagnostics);
  Document document = read_document(source, scene.path, files, sources, diagnostics);
  checked.graph =
      std::make_unique<NodeGraph>(build_graph(std::move(document), scene.path, sources, files, diagnostics, std::move(stage)));
  checked.scene = build_scene(*checked.graph, sources, files, {true}, diagnostics);
}

void note_needs(const std::vector<ValidRecipe>& programs, CheckedScene& checked) {
  for (const ValidRecipe& program : programs) {
    for (const TargetProgram& target : program.targets) {
      for (const EffectNeed& need : target.composed.needs)
        checked.needs.insert({Author{false, need.effect}, Author{need.of_shader, need.provider}});
    }
  }
}

CheckedScene start_anew() {
  CheckedScene checked;
  checked.sources = std::make_unique<SourceSet>();
  checked.diagnostics = std::make_unique<Diagnostics>(*checked.sources);
  return checked;
}

}  // namespace

Authors CheckedScene::authors() const {
  Authors authors;
  for (std::size_t i = 0; i < scene.effects.size(); ++i) authors.insert({false, static_cast<int>(i)});
  for (std::size_t i = 0; i < scene.shaders.size(); ++i) authors.insert({true, static_cast<int>(i)});
  return authors;
}

CheckedScene check_scene(const EffectScene& scene, FileAccess& files, Validator& validator) {
  CheckedScene checked = start_anew();
  read_scene(scene, false, files, checked);
  if (checked.scene.shapes.empty()) {
    checked = start_anew();
    read_scene(scene, true, files, checked);
  }
  MeshCache meshes;
  PreparedScene prepared =
      prepare_scene(*checked.graph, std::move(checked.scene), PreparedFor::checking, files, *checked.diagnostics, meshes);
  TemplateLibrary templates(*checked.sources);
  const ComposeInput input = compose_input(prepared, templates);
  ValidationStatistics statistics;
  const std::vector<ValidRecipe> programs =
      validate_states(prepared.recipes, input, {{Target::glsl330}}, validator, *checked.diagnostics, statistics);
  note_needs(programs, checked);
  for (const ShapePlan& shape : prepared.parts.shapes) {
    for (const PlannedVariant& variant : shape.variants) checked.drawn.push_back(authors_in(programs, variant.program));
  }
  checked.scene = std::move(prepared.parts.scene);
  return checked;
}

}  // namespace plugc::mutants

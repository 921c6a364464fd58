// The phases of compile.cpp from the document to the composed texts; effects that composing finds at fault are left out, as
// the validating room does it.

#include "oracle/observe.h"

#include <fstream>
#include <iterator>

#include "document/read_document.h"
#include "image/write_png.h"
#include "oracle/program_model.h"
#include "prepare_scene.h"
#include "support/compile_text.h"
#include "validate/candidate.h"

namespace plugc::oracle {
namespace {

std::string write_white_png(const SceneFolder& folder) {
  const std::string path = folder.path() / "white.png";
  const std::uint8_t white[4] = {255, 255, 255, 255};
  write_png(path, 1, 1, white, true);
  return path;
}

const std::string& white_png() {
  static const std::string bytes = [] {
    const SceneFolder folder;
    std::ifstream stream(write_white_png(folder), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }();
  return bytes;
}

ComposedProgram compose_without_faulty(const Recipe& recipe, const ComposeInput& input, Diagnostics& diagnostics) {
  ValidationStatistics statistics;
  CandidateChecker checker(input, process_validator(), statistics);
  ProgramCandidate candidate;
  candidate.recipe = recipe;
  checker.compose_candidate(candidate, diagnostics);
  return std::move(candidate.composed);
}

std::set<std::string> messages_of(const Diagnostics& diagnostics, SourceId scene) {
  std::set<std::string> messages;
  for (const Diagnostic& said : diagnostics.all()) {
    const bool placed = said.span.source == scene;
    const std::uint32_t line = placed ? diagnostics.sources().position(scene, said.span.begin).line : 0;
    say(messages, static_cast<int>(line), diagnostic_kind(said.id).code);
  }
  return messages;
}

}  // namespace

Outcome observe_outcome(const std::string& text) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  MemoryFiles files;
  files.files["white.png"] = white_png();
  const SourceId source = sources.add("scene.x3dv", text);
  const NodeGraph graph = build_graph(read_document(source, sources, diagnostics), "scene.x3dv", sources, files, diagnostics);
  MeshCache meshes;
  const PreparedScene prepared = prepare_scene(graph, build_scene(graph, sources, files, {}, diagnostics),
                                               PreparedFor::checking, files, diagnostics, meshes);
  TemplateLibrary templates(sources);
  const ComposeInput input = compose_input(prepared, templates);
  std::vector<ProgramTrace> traces;
  for (const StateRecipe& one : prepared.recipes) {
    traces.push_back(trace_of(compose_without_faulty(one.recipe, input, diagnostics), prepared.parts.scene));
  }
  Outcome outcome;
  for (const ShapePlan& shape : prepared.parts.shapes)
    outcome.programs.push_back(traces[static_cast<std::size_t>(shape.variants.front().program)]);
  outcome.said = messages_of(diagnostics, source);
  return outcome;
}

std::set<std::string> observe_messages(const std::string& scene) {
  const SceneFolder folder;
  write_white_png(folder);
  const Compiled compiled = compile_file(folder.write("scene.x3dv", scene));
  return messages_of(*compiled.diagnostics, SourceId{0});
}

}  // namespace plugc::oracle

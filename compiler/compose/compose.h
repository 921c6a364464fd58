#pragma once
// Recipe in, program text out: the pieces of code that a recipe asks for are placed, plugs are resolved into calls, and
// all is joined into one text a stage whose every byte leads back to its author.

#include <compare>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compose/code_unit.h"
#include "compose/recipe.h"
#include "compose/templates.h"
#include "glsl/stage.h"
#include "scene/scene.h"

namespace plugc {

/// What composing reads. One for a whole scene; the template library remembers what it has cut.
struct ComposeInput {
  const Scene& scene;
  const std::vector<EffectCode>& effects;  ///< By index of Scene::effects.
  const std::vector<EffectCode>& shaders;  ///< By index of Scene::shaders.
  TemplateLibrary& templates;
};

/// A uniform that an author's field feeds.
struct FieldUniform {
  std::string name;  ///< In the composed text.
  std::string type;  ///< GLSL type as declared.
  int owner = -1;    ///< Into Scene::effects, or Scene::shaders when `of_shader`.
  bool of_shader = false;
  int field = -1;                    ///< Into its fields; -1: no field feeds it.
  Span span;                         ///< Of the uniform's name.
  std::vector<double> initial = {};  ///< What it holds where no field feeds it; empty: zeros, or what only its text says.
};

/// A uniform `bool` that says whether an effect's or a light's code runs.
struct SwitchUniform {
  std::string name;  ///< `plugc_on_0`
  bool of_light = false;
  int index = -1;  ///< Into Scene::effects, or the number of a light of the recipe.
};

/// What an effect takes from another author of its shape. Without a function or varying its code is not valid; without a plug
/// its function is not called. Either way it has to go where its provider goes.
enum class NeedKind : std::uint8_t { function, varying, geometry_shader, plug };
struct EffectNeed {
  int effect = -1;         ///< Into Scene::effects.
  int provider = -1;       ///< Into Scene::effects, or Scene::shaders when `of_shader`.
  bool of_shader = false;  ///< A ComposedShader provides it.
  NeedKind kind = NeedKind::function;
  std::string name;  ///< Of the function, varying or plug.
  auto operator<=>(const EffectNeed&) const = default;
};

/// A call of an author's plug function.
struct CalledPlug {
  std::string_view plug;  ///< In the code that composing has read.
  ShaderStage stage = ShaderStage::vertex;
  auto operator<=>(const CalledPlug&) const = default;
};

struct ComposedStage {
  ShaderStage stage = ShaderStage::vertex;
  MappedText text;
};

struct ComposedProgram {
  std::vector<ComposedStage> stages;
  std::vector<FieldUniform> fields;
  std::vector<SwitchUniform> switches;
  std::vector<CalledPlug> calls;          ///< Sorted.
  std::vector<std::string> plugs_filled;  ///< Plugs that effects filled, sorted.
  std::vector<std::string> plugs_empty;   ///< The other plugs that the program offers, sorted.
  bool moves_vertices = false;            ///< Some effect moves vertices, so that the mesh's bounds say nothing.
  std::set<EffectNeed> needs;
  std::vector<int> faulty_effects;  ///< Effects that cannot stay in (reported); compose again without them.
  bool faulty_shader = false;       ///< The ComposedShader cannot be used (reported).
};

/// Composes for one target. Mistakes of the authors are reported; the same mistake is said once (see Diagnostics). A program
/// with something at fault may have no stages.
ComposedProgram compose(const Recipe& recipe, const ComposeInput& input, Target target, Diagnostics& diagnostics);

/// What a program is without its ComposedShader, as messages say it.
std::string_view without_shader(const Recipe& recipe);

/// The recipe without an effect, wherever it stands.
Recipe without_effect(Recipe recipe, int effect);
/// The recipe with these effects only.
Recipe with_effects(Recipe recipe, const std::set<int>& effects);
/// Every effect of a recipe, each once, in call order.
std::vector<int> all_effects(const Recipe& recipe);

}  // namespace plugc

#pragma once
// Rules that valid input may still break. Each rule is one file; the list of them is in lint.cpp.

#include <vector>

#include "base/diagnostics.h"
#include "compose/code_unit.h"
#include "scene/scene.h"

namespace plugc {

/// What a rule sees: one effect and its outlined code.
struct LintSubject {
  const SceneEffect& effect;
  const EffectCode& code;
};

using LintRule = void (*)(const LintSubject& subject, Diagnostics& diagnostics);

/// Uniforms that no line of their part reads.
void lint_unused_uniforms(const LintSubject& subject, Diagnostics& diagnostics);
/// Effects that fill no plug and define no function that another effect could call.
void lint_effects_without_plugs(const LintSubject& subject, Diagnostics& diagnostics);

/// Runs every rule over every effect. `codes` by index of Scene::effects.
void lint_scene(const Scene& scene, const std::vector<EffectCode>& codes, Diagnostics& diagnostics);

}  // namespace plugc

#include "lint/lint.h"

namespace plugc {
namespace {

constexpr LintRule kRules[] = {lint_unused_uniforms, lint_effects_without_plugs};

}  // namespace

void lint_scene(const Scene& scene, const std::vector<EffectCode>& codes, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.effects.size(); ++i) {
    for (const LintRule rule : kRules) rule({scene.effects[i], codes[i]}, diagnostics);
  }
  if (scene.effects.empty() && scene.screen_effects.empty()) {
    diagnostics.report(DiagnosticId::lint_no_effects, {}, "`" + scene.name + "` holds no effects");
  }
}

}  // namespace plugc

// An effect is of use when it fills a plug, or when it defines a function that others may call.

#include <algorithm>

#include <fmt/format.h>

#include "lint/lint.h"

namespace plugc {

void lint_effects_without_plugs(const LintSubject& subject, Diagnostics& diagnostics) {
  const bool of_use = std::any_of(subject.code.parts.begin(), subject.code.parts.end(), [](const EffectCode::Part& part) {
    const CodeUnit& unit = part.in_vertex ? *part.in_vertex : part.in_fragment ? *part.in_fragment : *part.in_geometry;
    const auto& functions = unit.outline.functions;
    return std::any_of(functions.begin(), functions.end(),
                       [](const FunctionOutline& function) { return function.is_definition(); });
  });
  if (of_use || subject.effect.parts.empty()) return;
  diagnostics.report(DiagnosticId::effect_no_plugs, subject.effect.span,
                     fmt::format("effect `{}` defines no function, so it changes nothing", subject.effect.label));
}

}  // namespace plugc

// A uniform counts as read when its name stands anywhere else in its part.

#include <algorithm>

#include <fmt/format.h>

#include "lint/lint.h"

namespace plugc {
namespace {

bool is_read(const CodeUnit& unit, const GlobalOutline& uniform) {
  return std::any_of(unit.tokens.tokens.begin(), unit.tokens.tokens.end(), [&](const Token& token) {
    const bool itself = token.begin == uniform.name_begin;
    if (token.kind == TokenKind::directive) return unit.at(token).find(uniform.name) != std::string_view::npos;
    return !itself && token.kind == TokenKind::identifier && unit.at(token) == uniform.name;
  });
}

void check_unit(const CodeUnit* unit, Diagnostics& diagnostics) {
  if (unit == nullptr) return;
  for (const GlobalOutline& global : unit->outline.globals) {
    if (global.storage != Storage::uniform || is_read(*unit, global)) continue;
    const auto end = global.name_begin + static_cast<std::uint32_t>(global.name.size());
    diagnostics.report(DiagnosticId::lint_unused_uniform, unit->span(global.name_begin, end),
                       fmt::format("uniform `{}` is never read in this part", global.name));
  }
}

}  // namespace

void lint_unused_uniforms(const LintSubject& subject, Diagnostics& diagnostics) {
  for (const EffectCode::Part& part : subject.code.parts) {
    check_unit(part.in_vertex.get(), diagnostics);
    check_unit(part.in_fragment.get(), diagnostics);
    check_unit(part.in_geometry.get(), diagnostics);
  }
}

}  // namespace plugc

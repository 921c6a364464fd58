#include "validate/fault_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace plugc {
namespace {

const SceneEffect& effect_of(const Scene& scene, int index) {
  return scene.effects[static_cast<std::size_t>(index)];
}

/// `the function \`noise\``
std::string to_text(const EffectNeed& need) {
  constexpr std::string_view kKinds[] = {"function", "varying", "geometry shader", "plug"};
  const std::string_view kind = kKinds[static_cast<std::size_t>(need.kind)];
  return need.name.empty() ? fmt::format("the {}", kind) : fmt::format("the {} `{}`", kind, need.name);
}

bool lies_in_any(const Span& span, const std::vector<const SceneEffect*>& authors) {
  return std::any_of(authors.begin(), authors.end(), [&](const SceneEffect* author) { return lies_in(span, *author); });
}

}  // namespace

bool lies_in(const Span& span, const SceneEffect& author) {
  return span.valid() && std::any_of(author.parts.begin(), author.parts.end(), [&](const ShaderSource& part) {
           if (part.text.empty()) return false;
           const Span first = part.text.locate(0, part.text.size());
           const Span last = part.text.locate(part.text.size() - 1, part.text.size());
           return first.valid() && span.source == first.source && first.begin <= span.begin &&
                  span.begin <= std::max(first.end, last.end);
         });
}

void report_messages(const std::vector<ShaderMessage>& messages, const std::vector<const SceneEffect*>& authors,
                     const Span& culprit, Diagnostics& diagnostics) {
  const bool any_inside = std::any_of(messages.begin(), messages.end(),
                                      [&](const ShaderMessage& message) { return lies_in_any(message.span, authors); });
  for (const ShaderMessage& message : messages) {
    if (lies_in_any(message.span, authors)) {
      diagnostics.report(DiagnosticId::shader_invalid, message.span, message.text);
    } else if (!any_inside) {
      const bool has_place = !culprit.valid() && message.span.valid();
      diagnostics.report(DiagnosticId::shader_invalid, has_place ? message.span : culprit,
                         fmt::format("{} (in the composed {} stage)", message.text, to_text(message.stage)));
    }
  }
}

void report_left_out(const std::vector<int>& failing, int left_out, std::string_view where, const Scene& scene,
                     Diagnostics& diagnostics) {
  const SceneEffect& gone = effect_of(scene, left_out);
  if (failing.size() == 1) {
    diagnostics.report(DiagnosticId::effect_left_out, gone.span,
                       fmt::format("effect `{}` is left out{}: the program is not valid with it", gone.label, where));
    return;
  }
  std::vector<RelatedPlace> related;
  std::string names;
  for (const int index : failing) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", effect_of(scene, index).label);
    if (index != left_out) related.push_back({effect_of(scene, index).span, "together with this effect"});
  }
  diagnostics.report(DiagnosticId::effect_left_out, gone.span,
                     fmt::format("effect `{}` is left out{}: the effects {} fail together, and it is the last of them",
                                 gone.label, where, names),
                     std::move(related));
}

void report_doubts(const EffectCode& code, Diagnostics& diagnostics) {
  for (const CodeDoubt& doubt : code.doubts) diagnostics.report(DiagnosticId::shader_syntax, doubt.span, doubt.message);
}

void report_lost_need(const EffectNeed& need, const Scene& scene, Diagnostics& diagnostics) {
  const SceneEffect& gone = effect_of(scene, need.effect);
  const SceneEffect& provider =
      need.of_shader ? scene.shaders[static_cast<std::size_t>(need.provider)] : effect_of(scene, need.provider);
  diagnostics.report(DiagnosticId::effect_left_out_too, gone.span,
                     fmt::format("effect `{}` is left out too: it needs {} of `{}`", gone.label, to_text(need), provider.label),
                     {{provider.span, "which is left out"}});
}

}  // namespace plugc

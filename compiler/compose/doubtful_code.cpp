// A function or marker in code that cannot be taken apart is not in its outline. Where another effect misses it, its name among
// the tokens of that code tells why.

#include <algorithm>

#include <fmt/format.h>

#include "compose/placed_unit.h"

namespace plugc {
namespace {

const CodeUnit* unit_of(const EffectCode::Part& part, ShaderStage stage) {
  switch (stage) {
    case ShaderStage::vertex: return part.in_vertex.get();
    case ShaderStage::geometry: return part.in_geometry.get();
    case ShaderStage::fragment: return part.in_fragment.get();
  }
  return nullptr;
}

Span find_name(const CodeUnit& code, std::string_view name) {
  if (name.empty()) return code.span(0, 1);
  for (const Token& token : code.tokens.tokens) {
    if (token.kind == TokenKind::identifier && code.at(token) == name) return code.span(token.begin, token.end);
  }
  for (const MarkerOutline& marker : code.outline.markers) {
    if (marker.name == name) return code.span(marker.begin, marker.end);
  }
  return {};
}

Span find_name(const EffectCode& code, ShaderStage stage, std::string_view name) {
  if (!code.broken && code.doubts.empty()) return {};
  for (const EffectCode::Part& part : code.parts) {
    const CodeUnit* unit = unit_of(part, stage);
    const Span found = unit == nullptr ? Span{} : find_name(*unit, name);
    if (found.valid()) return found;
  }
  return {};
}

}  // namespace

std::vector<RelatedPlace> doubtful_places(const ComposeInput& input, ShaderStage stage, std::string_view name) {
  for (const std::string_view wanted : {name, std::string_view()}) {
    for (const std::vector<EffectCode>* codes : {&input.effects, &input.shaders}) {
      for (const EffectCode& code : *codes) {
        const Span found = find_name(code, stage, wanted);
        if (found.valid()) return {{found, "is it meant to be here? this code is not understood"}};
      }
    }
  }
  return {};
}

}  // namespace plugc

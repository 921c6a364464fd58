#pragma once
// Scenes made by hand: effects from texts, recipes from fields, and what composing makes of them.

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "compose/check_fields.h"
#include "compose/compose.h"

namespace plugc {

class ComposeTest : public testing::Test {
 protected:
  using Parts = std::vector<std::pair<PartStage, std::string>>;

  /// Each part is a source of its own: `e0.0`, `e0.1`, ...
  int add(std::vector<SceneEffect>& authors, std::vector<EffectCode>& codes, std::string_view name, const Parts& parts) {
    SceneEffect effect;
    effect.label = std::string(name) + std::to_string(authors.size());
    effect.span = {sources_.add(effect.label, "Effect"), 0, 6};
    for (const auto& [stage, text] : parts) {
      const SourceId id = sources_.add(effect.label + "." + std::to_string(effect.parts.size()), text);
      const Span span{id, 0, static_cast<std::uint32_t>(text.size())};
      effect.parts.push_back({stage, MappedText(sources_, span), span, NodeId{next_node_++}});
    }
    codes.push_back(make_effect_code(effect, diagnostics_));
    authors.push_back(std::move(effect));
    return static_cast<int>(authors.size()) - 1;
  }
  int effect(const Parts& parts) { return add(scene_.effects, effects_, "e", parts); }
  int fragment(std::string text) { return effect({{PartStage::fragment, std::move(text)}}); }
  int vertex(std::string text) { return effect({{PartStage::vertex, std::move(text)}}); }
  int shader(std::string vertex_text, std::string fragment_text) {
    return add(scene_.shaders, shaders_, "s",
               {{PartStage::vertex, std::move(vertex_text)}, {PartStage::fragment, std::move(fragment_text)}});
  }

  /// An unlit shape with these effects.
  static Recipe unlit(std::vector<int> effects) {
    Recipe recipe;
    recipe.effects = std::move(effects);
    return recipe;
  }
  static Recipe lit(std::vector<int> effects, std::vector<LightRecipe> lights = {LightRecipe{}}) {
    Recipe recipe = unlit(std::move(effects));
    recipe.lit = recipe.normals = true;
    recipe.lights = std::move(lights);
    return recipe;
  }

  const ComposedProgram& compose_all(const Recipe& recipe, Target target = Target::glsl330) {
    program_ = compose(recipe, input(), target, diagnostics_);
    return program_;
  }
  ComposeInput input() { return {scene_, effects_, shaders_, templates_}; }
  const MappedText& stage(ShaderStage stage) const {
    for (const ComposedStage& each : program_.stages) {
      if (each.stage == stage) return each.text;
    }
    return program_.stages.front().text;
  }
  std::string fragment_text(const Recipe& recipe, Target target = Target::glsl330) {
    compose_all(recipe, target);
    return std::string(stage(ShaderStage::fragment).text());
  }
  std::string vertex_text(const Recipe& recipe, Target target = Target::glsl330) {
    compose_all(recipe, target);
    return std::string(stage(ShaderStage::vertex).text());
  }
  /// `place code: message`, a line each.
  std::string said() const {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics_.all()) {
      const Position at =
          diagnostic.span.valid() ? sources_.position(diagnostic.span.source, diagnostic.span.begin) : Position{};
      const std::string place = diagnostic.span.valid() ? std::string(sources_.name(diagnostic.span.source)) : "-";
      text += place + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + " " +
              std::string(diagnostic_kind(diagnostic.id).code) + ": " + diagnostic.message + "\n";
    }
    return text;
  }

  SourceSet sources_;
  Diagnostics diagnostics_{sources_};
  Scene scene_;
  std::vector<EffectCode> effects_, shaders_;
  TemplateLibrary templates_{sources_};
  ComposedProgram program_;
  std::uint32_t next_node_ = 1;
};

/// How often `part` stands in `text`.
inline std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// The lines of `text` that contain `part`, without their indentation.
inline std::string lines_with(std::string_view text, std::string_view part) {
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.find(part) != std::string_view::npos) lines += std::string(line) + "\n";
    begin = end + 1;
  }
  return lines;
}

/// The text behind the last piece of the renderer: what the last `lines` lines say.
inline std::string last_lines(std::string_view text, std::size_t lines) {
  std::size_t at = text.size();
  for (std::size_t i = 0; i <= lines && at != std::string_view::npos && at > 0; ++i) at = text.rfind('\n', at - 1);
  return std::string(text.substr(at == std::string_view::npos ? 0 : at + 1));
}

}  // namespace plugc

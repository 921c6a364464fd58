#pragma once
// A scene put through the compiler up to its valid programs, with all that mutants are judged by.

#include <compare>
#include <memory>
#include <set>
#include <vector>

#include "base/diagnostics.h"
#include "mutants/effect_scenes.h"
#include "scene/node_graph.h"
#include "scene/scene.h"
#include "validate/validate.h"

namespace plugc::mutants {

/// Who wrote shader code: an Effect, or a ComposedShader.
struct Author {
  bool is_shader = false;
  int index = -1;  ///< Into Scene::effects or Scene::shaders.
  auto operator<=>(const Author&) const = default;
};
using Authors = std::set<Author>;

struct CheckedScene {
  std::unique_ptr<SourceSet> sources;
  std::unique_ptr<Diagnostics> diagnostics;
  std::unique_ptr<NodeGraph> graph;  ///< What `scene` points into.
  Scene scene;
  std::set<std::pair<Author, Author>> needs;  ///< Who takes a function, a varying or a plug of whom.
  std::vector<Authors> drawn;  ///< By shape and state: whose code its program holds; empty where it has no program.

  const SceneEffect& node(const Author& author) const {
    return (author.is_shader ? scene.shaders : scene.effects)[static_cast<std::size_t>(author.index)];
  }
  Authors authors() const;
};

/// As `plugc lint` reads it: disabled effects and branches that are not drawn count, and effects without shapes get the stage.
CheckedScene check_scene(const EffectScene& scene, FileAccess& files, Validator& validator);

}  // namespace plugc::mutants

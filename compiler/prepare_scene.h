#pragma once
// The middle of the pipeline: a scene's geometry as triangles, its textures as pixels, its effects outlined, and the recipe
// of every shape. Each thing that shapes share is made once.

#include <map>
#include <memory>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "compose/code_unit.h"
#include "compose/compose.h"
#include "compose/recipe.h"
#include "compose/shape_states.h"
#include "image/load_images.h"
#include "mesh/mesh_cache.h"
#include "package/assemble_package.h"
#include "scene/scene.h"

namespace plugc {

/// What is known of a scene before its programs are composed.
struct PreparedScene {
  SceneParts parts;                          ///< Without programs.
  std::vector<EffectCode> effects, shaders;  ///< By index of the scene's lists.
  std::vector<StateRecipe> recipes;          ///< Each once; `parts.shapes` index it.
};

/// What composing sees of it.
inline ComposeInput compose_input(const PreparedScene& prepared, TemplateLibrary& templates) {
  return {prepared.parts.scene, prepared.effects, prepared.shaders, templates};
}

/// What a scene is prepared for. What is said of it does not depend on that.
enum class PreparedFor : std::uint8_t {
  drawing,
  checking,  ///< Images have no pixels.
  library,   ///< As for drawing, but each shape stands for its kind: it keeps shadows that could never fall on it.
};

/// `meshes`: those that several scenes of one graph share.
PreparedScene prepare_scene(const NodeGraph& graph, Scene scene, PreparedFor purpose, FileAccess& files,
                            Diagnostics& diagnostics, MeshCache& meshes, KnownImages* images = nullptr);

}  // namespace plugc

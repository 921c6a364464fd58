#pragma once
// From what the other rooms made to the package: the last step of a compilation.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compose/shape_states.h"
#include "image/image.h"
#include "mesh/mesh.h"
#include "package/package_file.h"
#include "scene/scene.h"
#include "validate/measure_costs.h"
#include "validate/validate_recipes.h"

namespace plugc {

/// What a shape is drawn with in some of its states. Into SceneParts::programs.
struct PlannedVariant {
  int program = -1;
  int depth_program = -1;        ///< -1: casts no shadow from a directional or spot light.
  int point_depth_program = -1;  ///< -1: casts none from a point light.
};

/// How a shape is drawn: what the recipe does not say.
struct ShapePlan {
  std::shared_ptr<const Mesh> mesh;      ///< Null: the shape is not drawn. Shapes with one geometry share it.
  std::vector<PlannedVariant> variants;  ///< At least one where there is a mesh.
  std::vector<ShapeSwitch> switches;     ///< What decides among them.
  std::vector<std::uint8_t> states;      ///< By the switches that are on, as bits: into `variants`.
  bool blended = false;
};

/// The programs of a shadow map that keeps moments; -1 for one that does not.
struct MapPlan {
  int moments_program = -1, blur_program = -1;
};

/// An effect of a library, whose scene is it alone on the built-in stage.
struct LibraryEntry {
  /// A program for a kind of shape.
  struct Variant {
    std::string kind;
    std::size_t choice = 0;  ///< Of the stage's Switch, for the first geometry.
    int program = -1;        ///< Into SceneParts::programs.
  };
  struct Field {
    std::string name;
    std::uint32_t slot = kSceneNoSlot;
  };
  std::string name;
  Span span;
  std::vector<std::string> needs, offers;  ///< Plugs that it fills, and that its own code has markers for.
  std::vector<Field> fields;
  std::vector<Variant> variants;
};

/// One scene, ready to be packed.
struct SceneParts {
  Scene scene;
  std::vector<std::shared_ptr<const Image>> images;  ///< By texture of the scene.
  std::vector<ShapePlan> shapes;                     ///< By shape of the scene.
  std::vector<MapPlan> maps;                         ///< By shadow map of the scene.
  bool blended_shapes_cast = false;                  ///< As in shadow volumes; in shadow maps they cast nothing.
  std::vector<int> screen_programs;                  ///< By screen effect of the scene.
  std::vector<ValidRecipe> programs;
  std::vector<std::string> program_names;  ///< By program: its recipe as text.
  std::optional<LibraryEntry> library;
  std::vector<ProgramCosts> costs;  ///< By program, when they were asked for.
};

struct AssembledPackage {
  PackageT package;
  std::vector<ProgramCosts> costs;  ///< By program of the package.
};

/// Programs, meshes and images that are equal byte for byte are stored once, whichever scene they come from.
AssembledPackage assemble_package(std::vector<SceneParts> scenes, const SourceSet& sources, std::string generator);

}  // namespace plugc

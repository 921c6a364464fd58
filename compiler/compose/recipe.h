#pragma once
// What a shape needs of its program, and nothing else: two shapes with equal recipes share a program without composing it
// twice. Colours, positions and the like are no part of it; whether a term can matter at all is.

#include <array>
#include <compare>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "compose/code_unit.h"
#include "scene/scene.h"

namespace plugc {

struct LightRecipe {
  LightKind kind = LightKind::directional;
  bool ambient = false;  ///< The light's and the material's ambient colours may both differ from black.
  bool attenuation = false;
  bool radius = false;
  bool beam_width = false;
  bool shadow = false;
  ShadowMethod shadow_method = kDefaultShadowMethod;  ///< Of a shadow.
  bool shadow_intensity = false;                      ///< Something else than full shadow.
  bool off = false;                                   ///< Keeps its number and has no code.
  bool guarded = false;                               ///< Its code stands under a switch of the program.
  std::vector<int> effects;                           ///< Into Scene::effects.
  auto operator<=>(const LightRecipe&) const = default;
};

struct TextureRecipe {
  TextureRole role = TextureRole::main;
  TextureKind kind = TextureKind::image_2d;
  TextureCombination combination;
  CoordGenerator generator = CoordGenerator::none;
  bool matrix = false;
  bool projective = false;  ///< q may differ from 1: the picture is looked up at s/q and t/q.
  std::vector<int> effects;
  auto operator<=>(const TextureRecipe&) const = default;
};

/// What a shape is drawn as.
enum class Primitive : std::uint8_t { none, points, lines, triangles };

/// A pass over the texels of a shadow map that keeps moments: from depths to moments, blurred along rows, and then along
/// columns.
enum class MapPass : std::uint8_t { none, vsm_moments, evsm_moments, msm_moments, blur };

/// The pass of a ScreenEffect over the picture: what its shader may look up there.
enum class ScreenPass : std::uint8_t { none, color, color_and_depth };

struct Recipe {
  bool depth_pass = false;      ///< The program of a shadow pass; what is wrong is said of the shape's own program.
  bool depth_only = false;      ///< Of one in which no fragment is discarded.
  bool of_point_light = false;  ///< Of one whose depth is the distance to a point light.
  bool cut_near = false;        ///< Of such a one: what is nearer than `projectionNear` is left out.
  MapPass map_pass = MapPass::none;
  ScreenPass screen_pass = ScreenPass::none;  ///< Without a shader: the picture stays as it is.
  bool gouraud = false;
  bool lit = false;
  bool physical = false;  ///< Lit as a PhysicalMaterial; its light is added up linearly and encoded for the screen at the end.
  bool normals = false;   ///< The mesh has normals and something reads them.
  bool two_sided = false;
  bool color_per_vertex = false;
  bool alpha_test = false;
  bool ambient = false, specular = false, emissive = false;
  bool vertex_eye = false;  ///< Lighting or an effect reads the eye-space position per fragment.
  FogKind fog = FogKind::none;
  bool fog_coord = false;                 ///< The mesh says how far each vertex lies in the fog.
  Primitive primitive = Primitive::none;  ///< Where a geometry shader takes it; else no program depends on it.
  int shader = -1;                        ///< A ComposedShader in place of the base shader.
  std::vector<LightRecipe> lights;        ///< Number N of a light is its place here.
  std::vector<TextureRecipe> textures;    ///< Number N of a texture is its place here.
  std::vector<int> effects;               ///< Of the Appearance, then of the groups.
  std::vector<int> guarded;       ///< Those, anywhere in the recipe, whose calls stand under a switch of the program. Sorted.
  bool back_material = false;     ///< Back faces have a material of their own, with the same terms.
  bool alpha_cutoff = false;      ///< The alpha test's bound may differ from 0.5.
  std::uint32_t clip_planes = 0;  ///< How many.
  bool point_size = false;
  int line_type = 1;
  bool filled = true;      ///< False: of faces nothing but hatches is drawn.
  int hatch = 0;           ///< Style of the hatches; 0: none.
  bool fog_plane = false;  ///< The fog lies in layers.
  auto operator<=>(const Recipe&) const = default;
};

/// What the recipe must know of a shape beyond the scene: its mesh and its images.
struct ShapeFacts {
  bool has_normals = true;
  bool has_colors = false;
  bool solid = true;
  bool alpha_test = false;       ///< Some texture's alpha is all or nothing, and the shape is not blended.
  std::vector<bool> projective;  ///< By texture of the shape: some vertex has a q other than 1.
  Primitive primitive = Primitive::triangles;
  bool has_fog_coords = false;
  bool has_tangents = false;
  bool shader_has_geometry = false;  ///< Its ComposedShader has a geometry shader.
};

/// What of a shape can be switched while it is drawn, in one of its states (shape_states.h).
struct SwitchedParts {
  std::set<int> effects_off = {}, lights_off = {};          ///< Into Scene::effects and Scene::lights.
  std::set<int> effects_guarded = {}, lights_guarded = {};  ///< On or off as the program's own switches say.
};

/// `codes` holds the outlined effects of the scene, by index.
Recipe make_recipe(const Scene& scene, const SceneShape& shape, const ShapeFacts& facts, const std::vector<EffectCode>& codes,
                   const SwitchedParts& switched = {});
/// The recipe of a caster's depth pass: of its effects only those that move vertices or change primitives, and, where the
/// alpha of fragments is tested or an effect discards some, what decides about them.
Recipe make_depth_recipe(const Recipe& recipe, const std::vector<EffectCode>& codes, bool of_point_light = false);

/// The recipe of a screen effect's program.
Recipe make_screen_recipe(const SceneScreenEffect& effect);

/// The recipes of a map of that method, in the order in which they are drawn.
std::array<Recipe, 2> make_map_recipes(ShadowMethod method);

/// A mode of MultiTexture as a word of a recipe: X3D's name in small letters.
std::string_view to_text(TextureMode mode);

/// One line: `phong lit specular; light directional ambient; texture modulate; effects Fresnel`.
std::string to_text(const Recipe& recipe, const Scene& scene);

}  // namespace plugc

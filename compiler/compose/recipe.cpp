// A term enters the recipe when its value can differ from what makes it vanish: a slot that a ROUTE writes can take any
// value, any other slot keeps the one it has; and a plug that some effect fills makes its term matter too.

#include "compose/recipe.h"

#include <algorithm>

namespace plugc {
namespace {

class RecipeMaker {
 public:
  RecipeMaker(const Scene& scene, const SceneShape& shape, const ShapeFacts& facts, const std::vector<EffectCode>& codes,
              const SwitchedParts& switched)
      : scene_(scene),
        shape_(shape),
        facts_(facts),
        codes_(codes),
        switched_(switched),
        material_(material_of(scene, shape.material)) {
    if (has_back_material()) back_ = material_of(scene, shape.back_material);
  }

  Recipe make();

 private:
  static SceneMaterial material_of(const Scene& scene, int material) {
    return material < 0 ? SceneMaterial() : scene.materials[static_cast<std::size_t>(material)];
  }
  bool has_back_material() const {
    return shape_.back_material >= 0 && !facts_.solid && facts_.primitive == Primitive::triangles && shape_.shader < 0;
  }
  /// Whether the parameter of the material, or of that of the back faces, may differ from `value`.
  bool may_differ(std::uint32_t SceneMaterial::*parameter, double value) const {
    return may_differ(material_.*parameter, value) || may_differ(back_.*parameter, value);
  }

  const Slot* slot(std::uint32_t index) const { return index == kSceneNoSlot ? nullptr : &scene_.slots[index]; }
  /// Whether the slot may hold something else than `value` in some component.
  bool may_differ(std::uint32_t index, double value) const {
    const Slot* found = slot(index);
    if (found == nullptr) return false;
    return found->routed || std::any_of(found->values.begin(), found->values.end(), [&](double v) { return v != value; });
  }
  bool is_off(int light) const { return switched_.lights_off.contains(light); }
  /// Those of the list that are not switched off.
  std::vector<int> switched_on(const std::vector<int>& effects) const {
    std::vector<int> on;
    std::ranges::copy_if(effects, std::back_inserter(on), [&](int e) { return !switched_.effects_off.contains(e); });
    return on;
  }
  bool any_effect(auto predicate) const;
  bool any_fills(std::string_view plug) const {
    return any_effect([&](const EffectCode& code) { return code.fills(plug); });
  }
  bool has_geometry_shader() const {
    return facts_.shader_has_geometry || any_effect([](const EffectCode& code) { return code.has_geometry_main; });
  }
  bool has_effects() const {
    return any_effect([](const EffectCode& code) { return !code.parts.empty(); });
  }

  bool generates_coordinates() const {
    return std::ranges::any_of(shape_.textures, [](const TextureUse& use) { return use.generator != CoordGenerator::none; });
  }

  /// Whether the material's ambient colour may be other than black.
  bool has_ambient() const {
    const auto is_ambient = [&](const SceneMaterial& m) { return may_differ(m.ambient, 0) && may_differ(m.ambient_color, 0); };
    return is_ambient(material_) || is_ambient(back_) || any_fills("material_ambient");
  }
  /// A matrix may give q another value.
  bool may_project(const SceneTextureTransform& transform) const {
    const Slot* matrix = slot(transform.matrix);
    if (matrix == nullptr) return false;
    const std::vector<double>& m = matrix->values;
    return matrix->routed || m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1;
  }
  LightRecipe light(int index) const;
  TextureRecipe texture(std::size_t number, const Recipe& recipe) const;
  bool is_projective(std::size_t number) const;
  bool is_read(TextureRole role, const Recipe& recipe) const;
  bool needs_vertex_eye(const Recipe& recipe) const;
  void take_style(Recipe& recipe) const;

  const Scene& scene_;
  const SceneShape& shape_;
  const ShapeFacts& facts_;
  const std::vector<EffectCode>& codes_;
  const SwitchedParts& switched_;
  SceneMaterial material_;
  SceneMaterial back_;  // no slots where it is the same
};

bool RecipeMaker::any_effect(auto predicate) const {
  const auto any_of_list = [&](const std::vector<int>& effects) {
    return std::any_of(effects.begin(), effects.end(), [&](int e) {
      return !switched_.effects_off.contains(e) && predicate(codes_[static_cast<std::size_t>(e)]);
    });
  };
  return any_of_list(shape_.effects) ||
         std::any_of(shape_.lights.begin(), shape_.lights.end(),
                     [&](int light) {
                       return !is_off(light) && any_of_list(scene_.lights[static_cast<std::size_t>(light)].effects);
                     }) ||
         std::any_of(shape_.textures.begin(), shape_.textures.end(), [&](const TextureUse& use) {
           return any_of_list(scene_.textures[static_cast<std::size_t>(use.texture)].effects);
         });
}

LightRecipe RecipeMaker::light(int index) const {
  const SceneLight& light = scene_.lights[static_cast<std::size_t>(index)];
  LightRecipe recipe;
  if (is_off(index)) {
    recipe.off = true;
    return recipe;
  }
  recipe.guarded = switched_.lights_guarded.contains(index);
  recipe.kind = light.kind;
  recipe.ambient = (may_differ(light.ambient_intensity, 0) && has_ambient()) || any_fills("material_light_ambient");
  if (const Slot* attenuation = slot(light.attenuation)) {
    recipe.attenuation = attenuation->routed || attenuation->values != std::vector<double>{1, 0, 0};
  }
  if (const Slot* radius = slot(light.radius)) recipe.radius = radius->routed || radius->values[0] >= 0;
  if (const Slot* beam = slot(light.beam_width)) {
    const Slot* cut_off = slot(light.cut_off_angle);
    recipe.beam_width = beam->routed || cut_off->routed || beam->values[0] < cut_off->values[0];
  }
  const auto received = std::ranges::find(shape_.receives, index, &ReceivedShadow::light);
  recipe.shadow = received != shape_.receives.end();
  if (recipe.shadow) recipe.shadow_method = scene_.shadow_maps[static_cast<std::size_t>(received->shadow_map)].method;
  recipe.shadow_intensity = recipe.shadow && may_differ(light.shadow_intensity, 1);
  recipe.effects = switched_on(light.effects);
  return recipe;
}

/// Whether the texture's parameter can matter at all.
bool RecipeMaker::is_read(TextureRole role, const Recipe& recipe) const {
  switch (role) {
    case TextureRole::main: return true;
    case TextureRole::ambient: return recipe.ambient;
    case TextureRole::specular:
    case TextureRole::shininess: return recipe.specular;
    case TextureRole::emissive: return recipe.emissive;
    case TextureRole::occlusion: return recipe.lit;
    case TextureRole::metallic_roughness: return recipe.physical;
    case TextureRole::normal: return recipe.lit && facts_.has_tangents;
    case TextureRole::unused: break;
  }
  return false;
}

/// Whether q may differ from 1 where a picture is looked up.
bool RecipeMaker::is_projective(std::size_t number) const {
  const TextureUse& use = shape_.textures[number];
  if (scene_.textures[static_cast<std::size_t>(use.texture)].kind != TextureKind::image_2d) return false;
  const bool by_matrix = use.transform >= 0 && may_project(scene_.texture_transforms[static_cast<std::size_t>(use.transform)]);
  const bool by_mesh = use.generator == CoordGenerator::none && number < facts_.projective.size() && facts_.projective[number];
  return by_matrix || by_mesh || use.generator == CoordGenerator::projection || use.generator == CoordGenerator::mirror_plane;
}

TextureRecipe RecipeMaker::texture(std::size_t number, const Recipe& recipe) const {
  const TextureUse& use = shape_.textures[number];
  const SceneTexture& texture = scene_.textures[static_cast<std::size_t>(use.texture)];
  const bool has_its_kind = use.role == TextureRole::main || texture.kind == TextureKind::image_2d;
  TextureRecipe made;
  made.role = has_its_kind && is_read(use.role, recipe) ? use.role : TextureRole::unused;
  if (made.role == TextureRole::unused) return made;
  made.kind = texture.kind;
  made.combination = use.combination;
  const bool projected = use.generator == CoordGenerator::mirror_plane;  // by another matrix: the code is one
  made.generator = projected ? CoordGenerator::projection : use.generator;
  made.matrix = use.transform >= 0;
  made.projective = is_projective(number);
  made.effects = switched_on(texture.effects);
  return made;
}

bool RecipeMaker::needs_vertex_eye(const Recipe& recipe) const {
  const bool by_lights = !recipe.gouraud && recipe.lit &&
                         (recipe.specular || (recipe.physical && !recipe.lights.empty()) ||
                          std::any_of(recipe.lights.begin(), recipe.lights.end(),
                                      [](const LightRecipe& light) { return light.kind != LightKind::directional; }));
  constexpr std::string_view kReaders[] = {"fragment_eye_space", "lighting_apply", "material_light_diffuse", "add_light",
                                           "add_light_contribution"};
  const bool by_plugs = !recipe.gouraud && std::any_of(std::begin(kReaders), std::end(kReaders),
                                                       [&](std::string_view plug) { return any_fills(plug); });
  return by_lights || by_plugs || any_effect([](const EffectCode& code) { return code.uses("castle_vertex_eye"); });
}

/// What of the shape's style its primitives show. Behind a geometry shader there are others, of which nothing is known.
void RecipeMaker::take_style(Recipe& recipe) const {
  const SceneStyle& style = shape_.style;
  recipe.alpha_cutoff = recipe.alpha_test && may_differ(shape_.alpha_cutoff, 0.5);
  recipe.clip_planes = static_cast<std::uint32_t>(shape_.clip_planes.size());
  if (has_geometry_shader()) return;
  if (facts_.primitive == Primitive::points) recipe.point_size = style.point_size != kSceneNoSlot && recipe.shader < 0;
  if (facts_.primitive == Primitive::lines) recipe.line_type = style.line_type;
  if (facts_.primitive != Primitive::triangles) return;
  recipe.filled = style.filled;
  recipe.hatch = style.hatch;
}

Recipe RecipeMaker::make() {
  Recipe recipe;
  recipe.shader = shape_.shader;
  recipe.effects = switched_on(shape_.effects);
  recipe.lit = material_.lighting != Lighting::unlit && facts_.has_normals && shape_.shading != Shading::wireframe;
  recipe.physical = recipe.lit && material_.lighting == Lighting::physical && shape_.shader < 0;
  const bool has_further_textures =
      std::ranges::any_of(shape_.textures, [](const TextureUse& use) { return use.role != TextureRole::main; });
  recipe.back_material = has_back_material();
  const bool per_fragment =
      !shape_.receives.empty() || shape_.shader >= 0 || recipe.physical || has_further_textures || recipe.back_material;
  recipe.gouraud = shape_.shading == Shading::gouraud && !per_fragment;
  if (recipe.lit || recipe.shader >= 0) {
    for (const int index : shape_.lights) recipe.lights.push_back(light(index));
  }
  // an author's code may light the shape itself
  const bool has_light = has_effects() || recipe.shader >= 0 || !std::ranges::all_of(recipe.lights, &LightRecipe::off);
  recipe.normals = facts_.has_normals && (has_light || generates_coordinates());
  recipe.two_sided = !facts_.solid && recipe.normals;
  recipe.color_per_vertex = facts_.has_colors;
  recipe.alpha_test = facts_.alpha_test;
  const bool shines = (may_differ(&SceneMaterial::specular, 0) && may_differ(&SceneMaterial::shininess, -1)) ||
                      any_fills("material_specular") || any_fills("material_light_specular");
  const bool phong = recipe.lit && !recipe.physical;
  recipe.specular = phong && has_light && shines;
  recipe.emissive = recipe.lit && (may_differ(&SceneMaterial::emissive, 0) || any_fills("material_emissive"));
  recipe.ambient = phong && (has_ambient() || any_fills("material_light_ambient"));
  for (std::size_t i = 0; i < shape_.textures.size(); ++i) recipe.textures.push_back(texture(i, recipe));
  if (shape_.fog >= 0) {
    const SceneFog& fog = scene_.fogs[static_cast<std::size_t>(shape_.fog)];
    recipe.fog = fog.kind;
    recipe.fog_plane = fog.volumetric && !facts_.has_fog_coords;
  }
  recipe.fog_coord = facts_.has_fog_coords;
  recipe.vertex_eye = needs_vertex_eye(recipe);
  if (has_geometry_shader()) recipe.primitive = facts_.primitive;
  take_style(recipe);
  recipe.guarded.assign(switched_.effects_guarded.begin(), switched_.effects_guarded.end());
  while (!recipe.lights.empty() && recipe.lights.back().off) recipe.lights.pop_back();  // nobody is numbered behind them
  return recipe;
}

}  // namespace

Recipe make_recipe(const Scene& scene, const SceneShape& shape, const ShapeFacts& facts, const std::vector<EffectCode>& codes,
                   const SwitchedParts& switched) {
  return RecipeMaker(scene, shape, facts, codes, switched).make();
}

namespace {

/// Whether some fragment may not be drawn because of the effect.
bool decides_fragments(const EffectCode& code, bool alpha_is_tested) {
  constexpr std::string_view kAlphaPlugs[] = {"texture_coord_shift", "texture_color",   "main_texture_apply", "texture_apply",
                                              "lighting_apply",      "fragment_modify", "fog_apply"};
  return code.discards ||
         (alpha_is_tested && std::ranges::any_of(kAlphaPlugs, [&](std::string_view plug) { return code.fills(plug); }));
}

/// The effects of a recipe's textures and of its shape: in a depth pass all act on the shape.
std::vector<int> caster_effects(const Recipe& recipe) {
  std::vector<int> effects;
  for (const TextureRecipe& texture : recipe.textures)
    effects.insert(effects.end(), texture.effects.begin(), texture.effects.end());
  effects.insert(effects.end(), recipe.effects.begin(), recipe.effects.end());
  return effects;
}

/// A caster whose fragments are all drawn: only what moves them counts.
void take_movers(const Recipe& recipe, const std::vector<EffectCode>& codes, bool has_geometry, Recipe& depth) {
  const std::vector<int> effects = caster_effects(recipe);
  const bool moves = has_geometry || std::ranges::any_of(effects, [&](int effect) {
                       return codes[static_cast<std::size_t>(effect)].moves_vertices;
                     });
  for (const int effect : effects) {  // those that move nothing may still define what the movers call
    const auto& parts = codes[static_cast<std::size_t>(effect)].parts;
    const bool of_use = std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
      return part.stage == PartStage::vertex || (has_geometry && part.stage == PartStage::geometry);
    });
    if (moves && of_use) depth.effects.push_back(effect);
  }
  depth.normals = recipe.normals && !depth.effects.empty();
  depth.depth_only = true;
}

/// A caster with holes: its textures and effects without any light, for colours are not seen. Where no effect decides, those
/// of the shape that only colour are left out.
void take_deciders(const Recipe& recipe, const std::vector<EffectCode>& codes, bool has_geometry, Recipe& depth) {
  const bool by_effects = std::ranges::any_of(caster_effects(recipe), [&](int effect) {
    return decides_fragments(codes[static_cast<std::size_t>(effect)], recipe.alpha_test);
  });
  if (by_effects)
    depth.effects = recipe.effects;
  else
    take_movers(recipe, codes, has_geometry, depth);
  depth.depth_only = false;
  depth.gouraud = recipe.gouraud;
  depth.normals = recipe.normals && !depth.effects.empty();  // the renderer's own alpha test looks at none
  depth.two_sided = recipe.two_sided && depth.normals;
  depth.color_per_vertex = recipe.color_per_vertex;
  depth.alpha_test = recipe.alpha_test;
  depth.alpha_cutoff = recipe.alpha_cutoff;
  depth.vertex_eye = recipe.vertex_eye && by_effects;
  depth.textures = recipe.textures;
  for (TextureRecipe& texture : depth.textures) {
    if (texture.role != TextureRole::main) texture = TextureRecipe{.role = TextureRole::unused};
    if (!by_effects) texture.effects.clear();
  }
}

}  // namespace

Recipe make_depth_recipe(const Recipe& recipe, const std::vector<EffectCode>& codes, bool of_point_light) {
  Recipe depth;
  depth.depth_pass = true;
  const auto code = [&](int effect) -> const EffectCode& { return codes[static_cast<std::size_t>(effect)]; };
  const bool has_geometry =
      std::any_of(recipe.effects.begin(), recipe.effects.end(), [&](int effect) { return code(effect).has_geometry_main; });
  const bool has_holes =
      recipe.shader < 0 &&
      (recipe.alpha_test || std::ranges::any_of(caster_effects(recipe), [&](int effect) { return code(effect).discards; }));
  has_holes ? take_deciders(recipe, codes, has_geometry, depth) : take_movers(recipe, codes, has_geometry, depth);
  const std::vector<int> taken = caster_effects(depth);
  std::ranges::copy_if(recipe.guarded, std::back_inserter(depth.guarded),
                       [&](int effect) { return std::ranges::find(taken, effect) != taken.end(); });
  depth.of_point_light = of_point_light;
  depth.clip_planes = recipe.clip_planes;
  depth.vertex_eye = depth.vertex_eye || of_point_light;
  if (has_geometry) depth.primitive = recipe.primitive;
  return depth;
}

Recipe make_screen_recipe(const SceneScreenEffect& effect) {
  Recipe recipe;
  recipe.screen_pass = effect.needs_depth ? ScreenPass::color_and_depth : ScreenPass::color;
  recipe.shader = effect.shader;
  return recipe;
}

std::array<Recipe, 2> make_map_recipes(ShadowMethod method) {
  Recipe moments, blur;
  moments.map_pass = method == ShadowMethod::vsm    ? MapPass::vsm_moments
                     : method == ShadowMethod::evsm ? MapPass::evsm_moments
                                                    : MapPass::msm_moments;
  blur.map_pass = MapPass::blur;
  return {moments, blur};
}

}  // namespace plugc

// Scene by scene: first the shared things (programs, images, meshes), each looked up by content, then the scene's own lists,
// which map one to one, then its shapes with their bindings.

#include "package/assemble_package.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "compose/castle_names.h"
#include "package/assemble_events.h"
#include "package/pack_attributes.h"
#include "package/pack_geometry.h"
#include "package/pack_offscreen.h"
#include "package/pack_program.h"
#include "package/pack_style.h"
#include "package/pack_transforms.h"

namespace plugc {
namespace {

constexpr std::uint32_t kNothing = UINT32_MAX;

class Assembler {
 public:
  Assembler(const SourceSet& sources, std::string generator) : sources_(sources, package_.sources) {
    package_.generator = std::move(generator);
  }
  void add_scene(SceneParts& parts);
  AssembledPackage take() { return {std::move(package_), std::move(costs_)}; }

 private:
  std::uint32_t add_program(const SceneParts& parts, std::size_t index);
  std::uint32_t add_image(const std::shared_ptr<const Image>& image);
  std::uint32_t add_texture(const SceneTexture& texture, const std::shared_ptr<const Image>& image);
  std::map<const Mesh*, std::uint32_t> add_meshes(const SceneParts& parts);
  std::uint32_t add_mesh(const Mesh& mesh, std::uint32_t units);
  std::unique_ptr<PackedEffectT> pack_effect(const LibraryEntry& entry, const std::vector<std::uint32_t>& programs);

  PackageT package_;
  std::vector<ProgramCosts> costs_;
  SourceList sources_;
  std::map<std::string, std::uint32_t> programs_;               // by content
  std::unordered_multimap<std::size_t, std::uint32_t> meshes_;  // by the hash of their content
  std::map<const Image*, std::uint32_t> images_;
  std::unordered_multimap<std::size_t, std::uint32_t> images_by_hash_;  // of their pixels
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> textures_;     // by image, wrapping and filters
};

std::uint32_t Assembler::add_program(const SceneParts& parts, std::size_t index) {
  const ValidRecipe& recipe = parts.programs[index];
  const bool keeps_picture = recipe.used.screen_pass != ScreenPass::none && recipe.used.shader < 0;
  if (recipe.targets.empty() || keeps_picture) return kNothing;
  const auto [found, added] =
      programs_.try_emplace(program_content(recipe), static_cast<std::uint32_t>(package_.programs.size()));
  if (!added) return found->second;
  package_.programs.push_back(pack_program(recipe, parts.program_names[index], sources_));
  if (index < parts.costs.size()) costs_.push_back(parts.costs[index]);
  return found->second;
}

template <typename T>
std::size_t hash_of(const std::vector<T>& list) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

bool are_equal(const PackedImageT& packed, const Image& image) {
  return packed.width == image.width && packed.height == image.height && packed.depth == image.depth &&
         packed.channels == image.channels && packed.pixels == image.pixels;
}

std::uint32_t Assembler::add_image(const std::shared_ptr<const Image>& image) {
  const auto [known, added] = images_.try_emplace(image.get(), static_cast<std::uint32_t>(package_.images.size()));
  if (!added) return known->second;
  const std::size_t hash = hash_of(image->pixels);
  const auto [first, last] = images_by_hash_.equal_range(hash);
  const auto same =
      std::find_if(first, last, [&](const auto& entry) { return are_equal(*package_.images[entry.second], *image); });
  if (same != last) return known->second = same->second;
  images_by_hash_.emplace(hash, known->second);
  package_.images.push_back(pack_image(*image));
  return known->second;
}

std::uint32_t Assembler::add_texture(const SceneTexture& texture, const std::shared_ptr<const Image>& image) {
  if (image == nullptr) return kNothing;
  auto packed = std::make_unique<PackedTextureT>();
  packed->image = add_image(image);
  packed->wrap_s = static_cast<PackedWrap>(texture.wrap_s);
  packed->wrap_t = static_cast<PackedWrap>(texture.wrap_t);
  packed->minification = static_cast<PackedFilter>(texture.minification);
  packed->magnification = static_cast<PackedFilter>(texture.magnification);
  packed->wrap_r = static_cast<PackedWrap>(texture.wrap_r);
  int settings = 0;
  for (const int setting :
       {static_cast<int>(texture.wrap_s), static_cast<int>(texture.wrap_t), static_cast<int>(texture.wrap_r),
        static_cast<int>(texture.minification), static_cast<int>(texture.magnification)})
    settings = settings * 4 + setting;
  const auto [found, added] =
      textures_.try_emplace({packed->image, settings}, static_cast<std::uint32_t>(package_.textures.size()));
  if (added) package_.textures.push_back(std::move(packed));
  return found->second;
}

/// Sets of texture coordinates that the program reads.
std::uint32_t coordinate_units(const ValidRecipe& program) {
  std::uint32_t units = 0;
  for (const TargetProgram& target : program.targets) {
    for (const ReflectedVariable& attribute : target.program.attributes()) {
      if (!attribute.name.starts_with("castle_MultiTexCoord")) continue;
      const int unit = find_castle_name(attribute.name).value_or(CastleName{}).number;
      units = std::max(units, static_cast<std::uint32_t>(unit + 1));
    }
  }
  return units;
}

bool are_equal(const PackedMeshT& a, const PackedMeshT& b) {
  const auto streams_equal = [](const PackedStream& x, const PackedStream& y) {
    return std::tuple(x.semantic(), x.unit(), x.components(), x.offset()) ==
           std::tuple(y.semantic(), y.unit(), y.components(), y.offset());
  };
  return a.topology == b.topology && a.stride == b.stride && std::ranges::equal(a.streams, b.streams, streams_equal) &&
         a.vertices == b.vertices && a.indices == b.indices && are_equal(a.attributes, b.attributes);
}

std::uint32_t Assembler::add_mesh(const Mesh& mesh, std::uint32_t units) {
  auto packed = pack_mesh(mesh, units);
  const std::size_t hash = hash_of(packed->vertices) ^ hash_of(packed->indices);
  const auto [first, last] = meshes_.equal_range(hash);
  for (auto known = first; known != last; ++known) {
    if (are_equal(*package_.meshes[known->second], *packed)) return known->second;
  }
  const auto index = static_cast<std::uint32_t>(package_.meshes.size());
  meshes_.emplace(hash, index);
  package_.meshes.push_back(std::move(packed));
  return index;
}

std::map<const Mesh*, std::uint32_t> Assembler::add_meshes(const SceneParts& parts) {
  std::map<const Mesh*, std::uint32_t> units;
  for (const ShapePlan& plan : parts.shapes) {
    if (plan.mesh == nullptr) continue;
    std::uint32_t& needed = units[plan.mesh.get()];
    for (const PlannedVariant& variant : plan.variants)
      needed = std::max(needed, coordinate_units(parts.programs[static_cast<std::size_t>(variant.program)]));
  }
  std::map<const Mesh*, std::uint32_t> indices;
  for (const ShapePlan& plan : parts.shapes) {  // in the order of the shapes, so that the bytes do not depend on addresses
    if (!units.contains(plan.mesh.get()) || indices.contains(plan.mesh.get())) continue;
    indices[plan.mesh.get()] = add_mesh(*plan.mesh, units[plan.mesh.get()]);
  }
  return indices;
}

void pack_slots(const Scene& scene, PackedSceneT& packed) {
  for (std::size_t i = 0; i < scene.slots.size(); ++i) {
    const Slot& slot = scene.slots[i];
    packed.slots.emplace_back(static_cast<std::uint32_t>(packed.slot_values.size()), slot.count,
                              static_cast<PackedValueType>(slot.type));
    packed.slot_values.insert(packed.slot_values.end(), slot.values.begin(), slot.values.end());
    if (slot.name.empty()) continue;
    auto name = std::make_unique<PackedSlotNameT>();
    name->slot = static_cast<std::uint32_t>(i);
    name->name = slot.name;
    name->dynamic = slot.dynamic;
    packed.slot_names.push_back(std::move(name));
  }
}

std::unique_ptr<PackedLightT> pack_light(const SceneLight& light) {
  auto packed = std::make_unique<PackedLightT>();
  packed->kind = static_cast<PackedLightKind>(light.kind);
  packed->headlight = light.headlight;
  packed->transform = light.transform;
  packed->on = light.on;
  packed->color = light.color;
  packed->intensity = light.intensity;
  packed->ambient_intensity = light.ambient_intensity;
  packed->location = light.location;
  packed->direction = light.direction;
  packed->attenuation = light.attenuation;
  packed->radius = light.radius;
  packed->cut_off_angle = light.cut_off_angle;
  packed->beam_width = light.beam_width;
  packed->shadow_intensity = light.shadow_intensity;
  packed->name = light.label;
  return packed;
}

std::unique_ptr<PackedShadowMapT> pack_shadow_map(const SceneShadowMap& map) {
  auto packed = std::make_unique<PackedShadowMapT>();
  packed->light = static_cast<std::uint32_t>(map.light);
  packed->size = map.size;
  packed->update = static_cast<PackedShadowUpdate>(map.update);
  packed->method = static_cast<PackedShadowMethod>(map.method);
  packed->method_written = map.method_written;
  packed->size_written = map.size_written;
  if (const auto& choice = map.choice) {
    packed->choice = std::make_unique<PackedShadowChoiceT>();
    packed->choice->budget = choice->budget;
    packed->choice->error = choice->error;
    packed->choice->views = choice->views;
    packed->choice->traced_truth = choice->traced_truth;
  }
  packed->scale_written = map.scale_written;
  packed->bias_written = map.bias_written;
  packed->scale = map.scale;
  packed->bias = map.bias;
  packed->near = map.near;
  packed->far = map.far;
  packed->up = map.up;
  packed->angle = map.angle;
  packed->rectangle = map.rectangle;
  packed->location = map.location;
  packed->author_visible = map.author_visible;
  packed->other_light = map.other_light;
  return packed;
}

std::unique_ptr<PackedViewpointT> pack_viewpoint(const SceneViewpoint& viewpoint) {
  auto packed = std::make_unique<PackedViewpointT>();
  packed->name = viewpoint.name;
  packed->description = viewpoint.description;
  packed->transform = viewpoint.transform;
  packed->orthographic = viewpoint.orthographic;
  packed->position = viewpoint.position;
  packed->orientation = viewpoint.orientation;
  packed->field_of_view = viewpoint.field_of_view;
  return packed;
}

/// Whether the shape's vertices lie where its mesh says.
bool has_known_bounds(const Recipe& recipe, const ValidRecipe& program) {
  const bool has_geometry = std::ranges::any_of(program.targets, [](const TargetProgram& target) {
    const auto& stages = target.program.stages();
    return std::ranges::find(stages, ShaderStage::geometry, &StageText::stage) != stages.end();
  });
  if (has_geometry) return false;
  const bool moves_vertices =
      std::ranges::any_of(program.targets, [](const TargetProgram& target) { return target.composed.moves_vertices; });
  return recipe.shader < 0 && !moves_vertices;
}

/// Where the programs and textures of a scene lie in the package.
struct Packed {
  const std::vector<std::uint32_t>& programs;  // by recipe of the scene; kNothing: none is valid
  const std::vector<std::uint32_t>& textures;
};

PackedVariantT pack_variant(const SceneParts& parts, const PlannedVariant& planned, const BindingContext& context,
                            const Packed& packed) {
  PackedVariantT variant;
  variant.program = packed.programs[static_cast<std::size_t>(planned.program)];
  variant.bindings = pack_bindings(parts.programs[static_cast<std::size_t>(planned.program)], context);
  const auto pack_depth = [&](int recipe, std::int32_t& program, std::vector<PackedBinding>& bindings) {
    if (recipe < 0 || packed.programs[static_cast<std::size_t>(recipe)] == kNothing) return;
    program = static_cast<std::int32_t>(packed.programs[static_cast<std::size_t>(recipe)]);
    bindings = pack_bindings(parts.programs[static_cast<std::size_t>(recipe)], context);
  };
  pack_depth(planned.depth_program, variant.depth_program, variant.depth_bindings);
  pack_depth(planned.point_depth_program, variant.point_depth_program, variant.point_depth_bindings);
  return variant;
}

/// What turns a map's depths into blurred moments.
void pack_map_programs(const SceneParts& parts, std::size_t map, const Packed& where, PackedShadowMapT& packed) {
  const MapPlan plan = map < parts.maps.size() ? parts.maps[map] : MapPlan();
  if (plan.moments_program < 0) return;
  const SceneShape none;
  const BindingContext context{parts.scene, none, where.textures, static_cast<int>(map)};
  const auto pack = [&](int program, std::int32_t& index, std::vector<PackedBinding>& bindings) {
    index = static_cast<std::int32_t>(where.programs[static_cast<std::size_t>(program)]);
    bindings = pack_bindings(parts.programs[static_cast<std::size_t>(program)], context);
  };
  pack(plan.moments_program, packed.moments_program, packed.moments_bindings);
  pack(plan.blur_program, packed.blur_program, packed.blur_bindings);
}

bool are_equal(const std::vector<PackedBinding>& a, const std::vector<PackedBinding>& b) {
  return std::ranges::equal(a, b, [](const PackedBinding& x, const PackedBinding& y) {
    return std::tuple(x.uniform(), x.a(), x.b(), x.scale(), x.source()) ==
           std::tuple(y.uniform(), y.a(), y.b(), y.scale(), y.source());
  });
}

bool are_equal(const PackedVariantT& a, const PackedVariantT& b) {
  return a.program == b.program && a.depth_program == b.depth_program && a.point_depth_program == b.point_depth_program &&
         are_equal(a.bindings, b.bindings) && are_equal(a.depth_bindings, b.depth_bindings) &&
         are_equal(a.point_depth_bindings, b.point_depth_bindings);
}

PackedSwitch pack_switch(const Scene& scene, const ShapeSwitch& one) {
  if (one.of_light) return {static_cast<std::uint32_t>(one.index), PackedSwitchKind::light};
  return {scene.effects[static_cast<std::size_t>(one.index)].enabled, PackedSwitchKind::slot};
}

/// The shape's programs, each once, and which it is drawn with in which state. A state whose program is not valid, even with
/// no effect in it, has the first that is.
void pack_variants(const SceneParts& parts, std::size_t index, const Packed& where, PackedShapeT& packed) {
  const ShapePlan& plan = parts.shapes[index];
  const BindingContext context{parts.scene, parts.scene.shapes[index], where.textures};
  std::vector<PackedVariantT> variants;
  std::vector<std::uint8_t> numbers;  // by planned variant
  for (const PlannedVariant& planned : plan.variants) {
    const bool valid = where.programs[static_cast<std::size_t>(planned.program)] != kNothing;
    std::size_t number = 0;
    if (valid) {
      PackedVariantT variant = pack_variant(parts, planned, context, where);
      const auto same = std::ranges::find_if(variants, [&](const PackedVariantT& known) { return are_equal(known, variant); });
      number = static_cast<std::size_t>(same - variants.begin());
      if (number == variants.size()) variants.push_back(std::move(variant));
    }
    numbers.push_back(static_cast<std::uint8_t>(number));
  }
  packed.program = variants.front().program;
  packed.bindings = std::move(variants.front().bindings);
  packed.depth_program = variants.front().depth_program;
  packed.depth_bindings = std::move(variants.front().depth_bindings);
  packed.point_depth_program = variants.front().point_depth_program;
  packed.point_depth_bindings = std::move(variants.front().point_depth_bindings);
  if (variants.size() == 1) return;
  for (const ShapeSwitch& one : plan.switches) packed.switches.push_back(pack_switch(parts.scene, one));
  for (const std::uint8_t state : plan.states) packed.states.push_back(numbers[state]);
  for (std::size_t i = 1; i < variants.size(); ++i)
    packed.variants.push_back(std::make_unique<PackedVariantT>(std::move(variants[i])));
}

bool all_bounds_known(const SceneParts& parts, const ShapePlan& plan) {
  return std::ranges::all_of(plan.variants, [&](const PlannedVariant& variant) {
    const ValidRecipe& program = parts.programs[static_cast<std::size_t>(variant.program)];
    return program.targets.empty() || has_known_bounds(program.used, program);
  });
}

/// Sets of texture coordinates that some program of the shape reads.
std::uint32_t units_read(const SceneParts& parts, const ShapePlan& plan) {
  std::uint32_t units = 0;
  for (const PlannedVariant& variant : plan.variants)
    units = std::max(units, coordinate_units(parts.programs[static_cast<std::size_t>(variant.program)]));
  return units;
}

std::unique_ptr<PackedShapeT> pack_shape(const SceneParts& parts, std::size_t index, std::uint32_t mesh, const Packed& where) {
  const SceneShape& shape = parts.scene.shapes[index];
  const ShapePlan& plan = parts.shapes[index];
  auto packed = std::make_unique<PackedShapeT>();
  packed->name = shape.name;
  packed->transform = shape.transform;
  packed->mesh = mesh;
  pack_variants(parts, index, where, *packed);
  packed->cull_back = plan.mesh->solid;
  packed->front_cw = !plan.mesh->ccw;
  packed->own_scene_of = shape.own_scene_of;
  packed->wireframe = shape.shading == Shading::wireframe;
  packed->blended = plan.blended;
  packed->blend_source = static_cast<PackedBlendFactor>(shape.blend.source);
  packed->blend_destination = static_cast<PackedBlendFactor>(shape.blend.destination);
  packed->bounds_known = all_bounds_known(parts, plan);
  if (!packed->bounds_known && shape.bounds) {
    packed->bounds_known = true;  // an author's word is believed
    packed->bounds_min = std::make_unique<PackedVec3>(shape.bounds->min.x, shape.bounds->min.y, shape.bounds->min.z);
    packed->bounds_max = std::make_unique<PackedVec3>(shape.bounds->max.x, shape.bounds->max.y, shape.bounds->max.z);
  }
  const Recipe& recipe = parts.programs[static_cast<std::size_t>(plan.variants.front().program)].used;
  pack_style(shape, recipe.point_size, *packed);
  packed->layer = shape.part == ScenePart::world ? PackedLayer::world : PackedLayer::backdrop;
  packed->projected_coords = pack_projected_coords({parts.scene, shape, where.textures}, units_read(parts, plan));
  for (const ReceivedShadow& shadow : shape.receives) packed->receives.push_back(static_cast<std::uint32_t>(shadow.shadow_map));
  return packed;
}

std::unique_ptr<PackedEffectT> Assembler::pack_effect(const LibraryEntry& entry, const std::vector<std::uint32_t>& programs) {
  auto packed = std::make_unique<PackedEffectT>();
  packed->name = entry.name;
  packed->origin = std::make_unique<PackedLineOrigin>(sources_.origin(entry.span));
  packed->scene = static_cast<std::uint32_t>(package_.scenes.size());
  packed->needs = entry.needs;
  packed->offers = entry.offers;
  for (const LibraryEntry::Field& field : entry.fields) {
    packed->fields.push_back(std::make_unique<PackedEffectFieldT>());
    packed->fields.back()->name = field.name;
    packed->fields.back()->slot = field.slot;
  }
  for (const LibraryEntry::Variant& variant : entry.variants) {
    const std::uint32_t program = programs[static_cast<std::size_t>(variant.program)];
    if (program == kNothing) continue;
    packed->kinds.push_back(std::make_unique<PackedEffectKindT>());
    packed->kinds.back()->name = variant.kind;
    packed->kinds.back()->choice = static_cast<std::uint32_t>(variant.choice);
    packed->kinds.back()->program = program;
  }
  return packed;
}

void Assembler::add_scene(SceneParts& parts) {
  const Scene& scene = parts.scene;
  auto packed = std::make_unique<PackedSceneT>();
  packed->name = scene.name;
  packed->background_color = scene.background_color;
  packed->bound_viewpoint = scene.bound_viewpoint;
  pack_slots(scene, *packed);
  pack_transforms(scene, *packed);
  pack_clip_planes(scene, *packed);
  pack_events(scene, *packed);
  for (const SceneLight& light : scene.lights) packed->lights.push_back(pack_light(light));
  for (const SceneViewpoint& viewpoint : scene.viewpoints) packed->viewpoints.push_back(pack_viewpoint(viewpoint));
  for (const SceneProjector& projector : scene.projectors) packed->projectors.push_back(pack_viewpoint(projector.viewpoint));

  std::vector<std::uint32_t> programs;
  for (std::size_t i = 0; i < parts.programs.size(); ++i) programs.push_back(add_program(parts, i));
  std::vector<std::uint32_t> textures;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) textures.push_back(add_texture(scene.textures[i], parts.images[i]));
  for (std::size_t i = 0; i < scene.shadow_maps.size(); ++i) {
    packed->shadow_maps.push_back(pack_shadow_map(scene.shadow_maps[i]));
    pack_map_programs(parts, i, {programs, textures}, *packed->shadow_maps.back());
  }
  pack_rendered_textures(scene, *packed);
  pack_screen_effects(parts, programs, textures, *packed);
  const auto meshes = add_meshes(parts);
  for (std::size_t i = 0; i < parts.shapes.size(); ++i) {
    const ShapePlan& plan = parts.shapes[i];
    const bool drawn = std::ranges::any_of(plan.variants, [&](const PlannedVariant& variant) {
      return programs[static_cast<std::size_t>(variant.program)] != kNothing;
    });
    if (drawn) packed->shapes.push_back(pack_shape(parts, i, meshes.at(plan.mesh.get()), {programs, textures}));
  }
  if (parts.library) package_.effects.push_back(pack_effect(*parts.library, programs));
  package_.scenes.push_back(std::move(packed));
}

}  // namespace

AssembledPackage assemble_package(std::vector<SceneParts> scenes, const SourceSet& sources, std::string generator) {
  Assembler assembler(sources, std::move(generator));
  for (SceneParts& scene : scenes) assembler.add_scene(scene);
  return assembler.take();
}

}  // namespace plugc

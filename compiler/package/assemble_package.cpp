// Scene by scene: first the shared things (programs, images, meshes), each looked up by content, then the scene's own lists,
// which map one to one, then its shapes with their bindings.

#include "package/assemble_package.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "package/assemble_events.h"
#include "package/pack_attributes.h"
#include "package/pack_fog.h"
#include "package/pack_geometry.h"
#include "package/pack_live_meshes.h"
#include "package/pack_offscreen.h"
#include "package/pack_program.h"
#include "package/pack_scene_lists.h"
#include "package/pack_shape.h"
#include "package/pack_style.h"
#include "package/pack_texture.h"
#include "package/pack_transforms.h"

namespace plugc {
namespace {

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
  /// By image, wrapping and filters, border.
  std::map<std::tuple<std::uint32_t, int, std::array<double, 4>>, std::uint32_t> textures_;
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
  packed->border = pack_border(texture);
  int settings = 0;
  for (const int setting :
       {static_cast<int>(texture.wrap_s), static_cast<int>(texture.wrap_t), static_cast<int>(texture.wrap_r),
        static_cast<int>(texture.minification), static_cast<int>(texture.magnification)})
    settings = settings * 4 + setting;
  const auto border = packed->border == nullptr ? std::array<double, 4>() : texture.border_color;
  const auto [found, added] =
      textures_.try_emplace({packed->image, settings, border}, static_cast<std::uint32_t>(package_.textures.size()));
  if (added) package_.textures.push_back(std::move(packed));
  return found->second;
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
  if (mesh.live != nullptr) {  // what is equal now will not stay so
    package_.meshes.push_back(std::move(packed));
    return static_cast<std::uint32_t>(package_.meshes.size() - 1);
  }
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
  packed->bound_viewpoint_now = scene.bound_viewpoint_now;
  packed->bound_background = scene.bound_background;
  packed->visibility_limit = scene.visibility_limit;
  pack_slots(scene, *packed);
  pack_transforms(scene, *packed);
  pack_clip_planes(scene, *packed);
  const std::vector<std::uint32_t> fog_planes = pack_fog_planes(scene, *packed);
  pack_events(scene, sources_, *packed);
  for (const SceneLight& light : scene.lights) packed->lights.push_back(pack_light(light));
  for (const SceneViewpoint& viewpoint : scene.viewpoints) packed->viewpoints.push_back(pack_viewpoint(viewpoint));
  for (const SceneProjector& projector : scene.projectors) packed->projectors.push_back(pack_viewpoint(projector.viewpoint));

  std::vector<std::uint32_t> programs;
  for (std::size_t i = 0; i < parts.programs.size(); ++i) programs.push_back(add_program(parts, i));
  std::vector<std::uint32_t> textures;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) textures.push_back(add_texture(scene.textures[i], parts.images[i]));
  MirrorWindows mirrors;
  const Packed where{programs, textures, fog_planes, mirrors};
  for (std::size_t i = 0; i < scene.shadow_maps.size(); ++i) {
    packed->shadow_maps.push_back(pack_shadow_map(scene.shadow_maps[i]));
    pack_map_programs(parts, i, where, *packed->shadow_maps.back());
  }
  pack_rendered_textures(scene, *packed);
  pack_screen_effects(parts, where, *packed);
  const auto meshes = add_meshes(parts);
  for (std::size_t i = 0; i < parts.shapes.size(); ++i) {
    const ShapePlan& plan = parts.shapes[i];
    const bool drawn = std::ranges::any_of(plan.variants, [&](const PlannedVariant& variant) {
      return programs[static_cast<std::size_t>(variant.program)] != kNothing;
    });
    if (drawn) packed->shapes.push_back(pack_shape(parts, i, meshes.at(plan.mesh.get()), where));
  }
  pack_live_meshes(parts, meshes, *packed);
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

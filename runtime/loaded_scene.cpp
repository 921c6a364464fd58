#include "runtime/loaded_scene.h"

namespace plugc {
namespace {

/// What must not wait for the first frame: programs (their messages belong to loading) and geometry.
void upload(LoadedScene& scene, Messages& messages) {
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) {
    const PackedShape& shape = scene.shape(i);
    scene.resources.mesh(shape.mesh());
    for (std::uint32_t variant = 0; variant <= shape.variants()->size(); ++variant) {
      const ShapePrograms use = shape_programs(shape, static_cast<std::uint8_t>(variant));
      scene.programs.get(use.program, messages);
      for (const std::int32_t depth : {use.depth_program, use.point_depth_program})
        if (depth >= 0) scene.programs.get(static_cast<std::uint32_t>(depth), messages);
    }
  }
  for (const PackedShadowMap* map : *scene.packed->shadow_maps()) {
    for (const std::int32_t program : {map->moments_program(), map->blur_program()}) {
      if (program >= 0) scene.programs.get(static_cast<std::uint32_t>(program), messages);
    }
  }
  if (scene.packed->screen_effects() == nullptr) return;
  for (const PackedScreenEffect* effect : *scene.packed->screen_effects()) scene.programs.get(effect->program(), messages);
}

}  // namespace

LoadedScene load_scene(const gl::Functions& functions, const Package& package, const PackedScene& packed, Messages& messages) {
  BindingReaders readers = find_binding_readers(packed);
  LoadedScene scene{&package,
                    &packed,
                    Slots(packed),
                    {},
                    0,
                    ProgramPool(functions, package),
                    ResourcePool(functions, package),
                    make_shadow_maps(functions, packed, std::move(readers.of_map), messages)};
  scene.events = make_event_graph(packed);
  scene.live_meshes = make_live_meshes(package, packed);
  scene.rendered_textures = make_rendered_textures(functions, packed, readers, messages);
  upload(scene, messages);
  return scene;
}

}  // namespace plugc

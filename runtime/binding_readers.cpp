// A reader's bindings are visited together, so that one that is found again is the last of its list.

#include "runtime/binding_readers.h"

namespace plugc {
namespace {

using Bindings = flatbuffers::Vector<const PackedBinding*>;

template <typename T>
void add_once(std::vector<T>& list, const T& reader) {
  if (list.empty() || list.back() != reader) list.push_back(reader);
}

void note(const Bindings& bindings, const MapReader& reader, BindingReaders& readers) {
  for (const PackedBinding* binding : bindings) {
    if (reads_map(*binding)) add_once(readers.of_map[binding->a()], reader);
    if (binding->source() == PackedSource::rendered_texture) add_once(readers.of_texture[binding->a()], reader.shape);
  }
}

std::uint32_t texture_count(const PackedScene& scene) {
  return scene.rendered_textures() == nullptr ? 0 : scene.rendered_textures()->size();
}

void note_screen_effects(const PackedScene& scene, BindingReaders& readers) {
  if (scene.screen_effects() == nullptr) return;
  for (const PackedScreenEffect* effect : *scene.screen_effects()) {
    for (const PackedBinding* binding : *effect->bindings())
      if (binding->source() == PackedSource::rendered_texture) readers.on_screen[binding->a()] = true;
  }
}

}  // namespace

bool reads_map(const PackedBinding& binding) {
  return binding.source() == PackedSource::shadow_map || binding.source() == PackedSource::shadow_map_greater ||
         binding.source() == PackedSource::shadow_moments || binding.source() == PackedSource::projector_matrix;
}

BindingReaders find_binding_readers(const PackedScene& scene) {
  BindingReaders readers{std::vector<std::vector<MapReader>>(scene.shadow_maps()->size()),
                         std::vector<std::vector<std::uint32_t>>(texture_count(scene)),
                         std::vector<bool>(texture_count(scene))};
  for (std::uint32_t i = 0; i < scene.shapes()->size(); ++i) {
    const PackedShape& shape = *scene.shapes()->Get(i);
    for (std::uint32_t variant = 0; variant <= shape.variants()->size(); ++variant) {
      const MapReader reader{i, static_cast<std::uint8_t>(variant)};
      note(*shape_programs(shape, reader.variant).bindings, reader, readers);
      if (shape.projected_coords() != nullptr) note(*shape.projected_coords(), reader, readers);
    }
  }
  note_screen_effects(scene, readers);
  return readers;
}

}  // namespace plugc

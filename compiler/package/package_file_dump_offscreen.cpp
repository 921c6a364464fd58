// The views of a dump beside the picture's: rendered textures, and effects on the whole picture.

#include "package/package_file_dump.h"

namespace plugc {

void dump_rendered_texture(Text& text, const PackedRenderedTexture& texture, std::size_t index) {
  line(text, "  rendered texture {}: {} {} x {}, update {}, viewpoint {}{}{}, background color slot {}", index,
       EnumNamePackedRenderedKind(texture.kind()), texture.width(), texture.height(),
       EnumNamePackedShadowUpdate(texture.update()), texture.viewpoint(), texture.own_scene() ? ", own scene" : "",
       texture.own_backdrop() ? ", own backdrop" : "", slot(texture.background_color()));
  if (texture.in_mirror()) line(text, "    in a mirror, distance from shape {}", slot(texture.distance_from_shape()));
  line(text, "    wraps {} {}, filters {} {}{}", EnumNamePackedWrap(texture.wrap_s()), EnumNamePackedWrap(texture.wrap_t()),
       EnumNamePackedFilter(texture.minification()), EnumNamePackedFilter(texture.magnification()), border(texture.border()));
  const auto dump_slots = [&](const char* word, const flatbuffers::Vector<std::uint32_t>* list) {
    if (list != nullptr && list->size() != 0) line(text, "    {} slots{}", word, slots(*list));
  };
  dump_slots("rendering", texture.rendering_slots());
  dump_slots("viewing", texture.viewing_slots());
  dump_slots("projection", texture.projection_slots());
  for (flatbuffers::uoffset_t i = 0; texture.loans() != nullptr && i < texture.loans()->size(); ++i)
    line(text, "    slot {} holds slot {} meanwhile", texture.loans()->Get(i)->to(), texture.loans()->Get(i)->from());
}

void dump_screen_effect(Text& text, const Package& package, const PackedScreenEffect& effect, std::size_t index) {
  line(text, "  screen effect {} {}: program {}, enabled slot {}, transform {}{}", index, quoted(*effect.name()),
       effect.program(), slot(effect.enabled()), effect.transform(), effect.needs_depth() ? ", needs depth" : "");
  dump_bindings(text, *effect.bindings(), *package.programs()->Get(effect.program()));
}

}  // namespace plugc

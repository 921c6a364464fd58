// A shape of a dump: how it is drawn, and by which programs in which state.

#include "package/package_file_dump.h"

namespace plugc {

void dump_bindings(Text& text, const flatbuffers::Vector<const PackedBinding*>& bindings, const PackedProgram& program) {
  for (const auto* binding : bindings) {
    line(text, "      {} = {} a {} b {} scale {}", program.uniforms()->Get(binding->uniform())->name()->string_view(),
         EnumNamePackedSource(binding->source()), slot(binding->a()), slot(binding->b()), binding->scale());
  }
}

namespace {

void dump_style(Text& text, const PackedShape& shape) {
  if (shape.line_width() != kNoSlot) line(text, "    line width slot {}", shape.line_width());
  if (shape.alpha_cutoff() != kNoSlot) line(text, "    alpha cutoff slot {}", shape.alpha_cutoff());
  if (shape.sized_points()) line(text, "    its program sizes points");
  if (shape.blend_color() != kNoSlot)
    line(text, "    blend color slot {}, transparency slot {}", shape.blend_color(), slot(shape.blend_transparency()));
}

void dump_programs(Text& text, const Package& package, const ShapePrograms& use) {
  const auto& programs = *package.programs();
  line(text, "    bindings");
  dump_bindings(text, *use.bindings, *programs.Get(use.program));
  if (use.depth_program >= 0) {
    line(text, "    depth program {}", use.depth_program);
    dump_bindings(text, *use.depth_bindings, *programs.Get(static_cast<std::uint32_t>(use.depth_program)));
  }
  if (use.point_depth_program >= 0) {
    line(text, "    point depth program {}", use.point_depth_program);
    dump_bindings(text, *use.point_depth_bindings, *programs.Get(static_cast<std::uint32_t>(use.point_depth_program)));
  }
}

void dump_states(Text& text, const Package& package, const PackedShape& shape) {
  for (const PackedSwitch* one : *shape.switches())
    line(text, "    switch {} {}", EnumNamePackedSwitchKind(one->kind()), one->index());
  const auto& states = *shape.states();
  if (states.size() != 0) line(text, "    variants by state {}", fmt::join(states.data(), states.data() + states.size(), " "));
  for (flatbuffers::uoffset_t i = 0; i < shape.variants()->size(); ++i) {
    const ShapePrograms use = shape_programs(shape, static_cast<std::uint8_t>(i + 1));
    line(text, "    variant {}: program {}", i + 1, use.program);
    dump_programs(text, package, use);
  }
}

}  // namespace

void dump_shape(Text& text, const Package& package, const PackedShape& shape, std::size_t index) {
  line(text, "  shape {} {}: transform {}, mesh {}, program {}", index, quoted(*shape.name()), shape.transform(), shape.mesh(),
       shape.program());
  if (shape.background() >= 0) line(text, "    while background {} is bound", shape.background());
  line(text, "    {}{}{}{}{}{}", shape.layer() == PackedLayer::backdrop ? "backdrop, " : "",
       shape.cull_back() ? "culls backs" : "two-sided", shape.front_cw() ? ", clockwise" : "",
       shape.wireframe() ? ", wireframe" : "",
       shape.bounds_min() != nullptr ? ", bounds written"
       : shape.bounds_known()        ? ""
                                     : ", bounds unknown",
       shape.own_scene_of() < 0 ? "" : fmt::format(", in the scene of rendered texture {}", shape.own_scene_of()));
  if (shape.blended()) {
    line(text, "    blends {} {}", EnumNamePackedBlendFactor(shape.blend_source()),
         EnumNamePackedBlendFactor(shape.blend_destination()));
  }
  dump_style(text, shape);
  if (const PackedWindow* mirror = shape.mirror())
    line(text, "    mirror from {}, sides {} and {}", vec3(mirror->corner()), vec3(mirror->right()), vec3(mirror->up()));
  const auto& maps = *shape.receives();
  if (maps.size() != 0) line(text, "    receives shadow maps {}", fmt::join(maps.data(), maps.data() + maps.size(), " "));
  dump_programs(text, package, shape_programs(shape, 0));
  dump_states(text, package, shape);
}

}  // namespace plugc

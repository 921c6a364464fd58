// One line a fact, in the order of the schema, indented by what holds it. Everything that decides what is drawn is written
// out; texts, vertices and pixels are told by their size and hash, so that a dump stays a page that people compare.
// Numbers are written in the shortest form that reads back to the same value, so equal packages give equal text.

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "base/clean_text.h"
#include "package/package_file.h"

namespace plugc {
namespace {

using Text = fmt::memory_buffer;

template <typename... Args>
void line(Text& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  text.push_back('\n');
}

/// In backticks, and on one line.
std::string quoted(const flatbuffers::String& string) {
  return fmt::format("`{}`", printable(string.string_view()));
}

std::string quoted(const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>& list) {
  std::string result;
  for (const auto* string : list) result.append(" ").append(quoted(*string));
  return result.empty() ? " none" : result;
}

template <typename Range>
std::string sized(const Range& data, std::string_view unit) {
  const std::size_t bytes = data.size() * sizeof(*data.data());
  return fmt::format("{} {}, hash {:016x}", data.size(), unit, XXH3_64bits(data.data(), bytes));
}

/// A type's name in the schema has a final `_` where C++ has that word already.
std::string_view word(const char* enumerator_name) {
  std::string_view name = enumerator_name;
  if (name.ends_with('_')) name.remove_suffix(1);
  return name;
}

std::string slot(std::uint32_t index) {
  return index == kNoSlot ? "-" : std::to_string(index);
}

std::string vec3(const PackedVec3& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

// ---- programs ----

void dump_stage(Text& text, const PackedStage& stage) {
  const std::string_view source = stage.text()->string_view();
  line(text, "      {}: {} lines, {}", EnumNamePackedStageKind(stage.kind()), std::ranges::count(source, '\n'),
       sized(source, "bytes"));
  const auto& words = *stage.spirv();
  if (words.size() != 0) line(text, "        spirv: {}", sized(words, "words"));
}

/// `, location 3`, or nothing where there is none.
std::string number(std::string_view title, std::int32_t value) {
  return value < 0 ? "" : fmt::format(", {} {}", title, value);
}

/// ` in essl300 spirv`, or nothing where every target of the program reads the uniform.
std::string some_targets(const PackedUniform& uniform, const PackedProgram& program) {
  std::string names;
  bool all = true;
  for (const auto* target : *program.targets()) {
    const bool reads = (uniform.targets() >> static_cast<unsigned>(target->target()) & 1U) != 0;
    if (reads) names.append(" ").append(EnumNamePackedTarget(target->target()));
    all = all && reads;
  }
  return all ? "" : " in" + names;
}

void dump_program(Text& text, const PackedProgram& program, std::size_t index) {
  line(text, "program {} {}", index, quoted(*program.name()));
  line(text, "  recipe {}", quoted(*program.recipe()));
  for (const auto* target : *program.targets()) {
    line(text, "  target {}", EnumNamePackedTarget(target->target()));
    for (const auto* stage : *target->stages()) dump_stage(text, *stage);
  }
  for (const auto* uniform : *program.uniforms()) {
    const std::string array = uniform->count() == 1 ? "" : fmt::format("[{}]", uniform->count());
    const auto& initial = *uniform->initial();
    const std::string starts =
        initial.size() == 0 ? "" : fmt::format(" = {}", fmt::join(initial.data(), initial.data() + initial.size(), " "));
    line(text, "  uniform {} {}{}{}{}{}{}", word(EnumNamePackedUniformType(uniform->type())), uniform->name()->string_view(),
         array, some_targets(*uniform, program), number("location", uniform->location()), number("binding", uniform->binding()),
         starts);
  }
  for (const auto* attribute : *program.attributes()) {
    line(text, "  attribute {}: {} {}{}", attribute->name()->string_view(), EnumNamePackedSemantic(attribute->semantic()),
         attribute->unit(), number("location", attribute->location()));
  }
  line(text, "  plugs filled:{}", quoted(*program.plugs_filled()));
  line(text, "  plugs empty:{}", quoted(*program.plugs_empty()));
}

// ---- geometry and pixels ----

void dump_mesh(Text& text, const PackedMesh& mesh, std::size_t index) {
  line(text, "mesh {}: {}, {} vertices of {} bytes, {} indices", index, EnumNamePackedTopology(mesh.topology()),
       mesh.vertex_count(), mesh.stride(), mesh.indices()->size());
  for (const auto* stream : *mesh.streams()) {
    line(text, "  stream {} {}: {} floats at {}", EnumNamePackedSemantic(stream->semantic()), stream->unit(),
         stream->components(), stream->offset());
  }
  for (flatbuffers::uoffset_t i = 0; mesh.attributes() != nullptr && i < mesh.attributes()->size(); ++i) {
    const PackedMeshAttribute& attribute = *mesh.attributes()->Get(i);
    line(text, "  attribute {}: {} x {} floats at {}", quoted(*attribute.name()), attribute.columns(), attribute.components(),
         attribute.offset());
  }
  line(text, "  bounds {} to {}", vec3(*mesh.bounds_min()), vec3(*mesh.bounds_max()));
  line(text, "  vertices: {}", sized(*mesh.vertices(), "bytes"));
  line(text, "  indices: {}", sized(*mesh.indices(), "numbers"));
}

void dump_image(Text& text, const PackedImage& image, std::size_t index) {
  line(text, "image {}: {} x {} x {}, {} channels, {}", index, image.width(), image.height(), image.depth(), image.channels(),
       sized(*image.pixels(), "bytes"));
}

std::string border(const PackedBorder* color) {
  if (color == nullptr) return "";
  return fmt::format(", border {:g} {:g} {:g} {:g}", color->red(), color->green(), color->blue(), color->alpha());
}

void dump_texture(Text& text, const PackedTexture& texture, std::size_t index) {
  line(text, "texture {}: image {}, wrap {} {} {}, filter {} {}{}", index, texture.image(),
       EnumNamePackedWrap(texture.wrap_s()), EnumNamePackedWrap(texture.wrap_t()), EnumNamePackedWrap(texture.wrap_r()),
       EnumNamePackedFilter(texture.minification()), EnumNamePackedFilter(texture.magnification()), border(texture.border()));
}

// ---- scenes ----

void dump_slot(Text& text, const PackedScene& scene, std::size_t index) {
  const PackedSlot& packed = *scene.slots()->Get(static_cast<std::uint32_t>(index));
  const double* first = scene.slot_values()->data() + packed.first();
  const std::size_t numbers = std::size_t{packed.count()} * component_count(packed.type());
  line(text, "  slot {}: {}[{}] {}", index, word(EnumNamePackedValueType(packed.type())), packed.count(),
       fmt::join(first, first + numbers, " "));
}

void dump_slots(Text& text, const PackedScene& scene) {
  for (std::size_t i = 0; i < scene.slots()->size(); ++i) dump_slot(text, scene, i);
  for (const auto* name : *scene.slot_names())
    line(text, "  slot {} is {}{}", name->slot(), quoted(*name->name()), name->dynamic() ? ", the host may change it" : "");
}

void dump_transform(Text& text, const PackedTransform& transform, std::size_t index) {
  line(text, "  transform {}: parent {}, slots: translation {}, rotation {}, scale {}, scale orientation {}, center {}", index,
       transform.parent(), slot(transform.translation()), slot(transform.rotation()), slot(transform.scale()),
       slot(transform.scale_orientation()), slot(transform.center()));
  if (transform.switch_slot() != kNoSlot) line(text, "    while slot {} is {}", transform.switch_slot(), transform.choice());
}

void dump_billboards(Text& text, const PackedScene& scene) {
  if (scene.billboards() == nullptr) return;
  for (const PackedBillboard* one : *scene.billboards())
    line(text, "  transform {} turns to the viewer about slot {}", one->transform(), one->axis());
}

void dump_clip_planes(Text& text, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; scene.clip_planes() != nullptr && i < scene.clip_planes()->size(); ++i) {
    const PackedClipPlane& plane = *scene.clip_planes()->Get(i);
    line(text, "  clip plane {}: transform {}, slots: plane {}, enabled {}", i, plane.transform(), plane.plane(),
         plane.enabled());
  }
}

void dump_fog_planes(Text& text, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; scene.fog_planes() != nullptr && i < scene.fog_planes()->size(); ++i) {
    const PackedFogPlane& plane = *scene.fog_planes()->Get(i);
    line(text, "  fog plane {}: transform {}, slots: direction {}, start {}", i, plane.transform(), plane.direction(),
         plane.start());
  }
}

void dump_style(Text& text, const PackedShape& shape) {
  if (shape.line_width() != kNoSlot) line(text, "    line width slot {}", shape.line_width());
  if (shape.alpha_cutoff() != kNoSlot) line(text, "    alpha cutoff slot {}", shape.alpha_cutoff());
  if (shape.sized_points()) line(text, "    its program sizes points");
  if (shape.blend_color() != kNoSlot)
    line(text, "    blend color slot {}, transparency slot {}", shape.blend_color(), slot(shape.blend_transparency()));
}

void dump_lod_levels(Text& text, const PackedScene& scene) {
  if (scene.lod_levels() == nullptr) return;
  for (const PackedLodLevel* one : *scene.lod_levels())
    line(text, "  transform {} is shown from {:g} to {:g} away from slot {}", one->transform(), one->from(), one->to(),
         one->center());
}

void dump_light(Text& text, const PackedLight& light, std::size_t index) {
  line(text, "  light {} {}: {}{}, transform {}", index, quoted(*light.name()), EnumNamePackedLightKind(light.kind()),
       light.headlight() ? " headlight" : "", light.transform());
  line(text, "    slots: on {}, color {}, intensity {}, ambient intensity {}, location {}, direction {}", slot(light.on()),
       slot(light.color()), slot(light.intensity()), slot(light.ambient_intensity()), slot(light.location()),
       slot(light.direction()));
  line(text, "    slots: attenuation {}, radius {}, cut off angle {}, beam width {}, shadow intensity {}",
       slot(light.attenuation()), slot(light.radius()), slot(light.cut_off_angle()), slot(light.beam_width()),
       slot(light.shadow_intensity()));
}

void dump_bindings(Text& text, const flatbuffers::Vector<const PackedBinding*>& bindings, const PackedProgram& program) {
  for (const auto* binding : bindings) {
    line(text, "      {} = {} a {} b {} scale {}", program.uniforms()->Get(binding->uniform())->name()->string_view(),
         EnumNamePackedSource(binding->source()), slot(binding->a()), slot(binding->b()), binding->scale());
  }
}

void dump_shadow_map(Text& text, const Package& package, const PackedShadowMap& map, std::size_t index) {
  line(text, "  shadow map {}: light {}, size {}, update {}, method {}{}{}{}", index, map.light(), map.size(),
       EnumNamePackedShadowUpdate(map.update()), EnumNamePackedShadowMethod(map.method()),
       map.scale_written() ? ", scale written" : "", map.bias_written() ? ", bias written" : "",
       map.author_visible() ? ", seen by authors" : "");
  line(text, "    slots: scale {}, bias {}, near {}, far {}, up {}, angle {}, rectangle {}, location {}", slot(map.scale()),
       slot(map.bias()), slot(map.near()), slot(map.far()), slot(map.up()), slot(map.angle()), slot(map.rectangle()),
       slot(map.location()));
  if (const PackedShadowChoice* choice = map.choice()) {
    line(text, "    chosen for at most {:.3g} % of wrong pixels: {:.3g} % in {} view{}, against {}", 100 * choice->budget(),
         100 * choice->error(), choice->views(), choice->views() == 1 ? "" : "s",
         choice->traced_truth() ? "traced shadows" : "the largest map");
  }
  if (map.moments_program() < 0) return;
  line(text, "    moments program {}", map.moments_program());
  dump_bindings(text, *map.moments_bindings(), *package.programs()->Get(static_cast<std::uint32_t>(map.moments_program())));
  line(text, "    blur program {}", map.blur_program());
  dump_bindings(text, *map.blur_bindings(), *package.programs()->Get(static_cast<std::uint32_t>(map.blur_program())));
}

void dump_texture_transform(Text& text, const PackedTextureTransform& transform, std::size_t index) {
  line(text, "  texture transform {}: slots: translation {}, rotation {}, scale {}, center {}", index,
       slot(transform.translation()), slot(transform.rotation()), slot(transform.scale()), slot(transform.center()));
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

void dump_viewpoint(Text& text, const char* word, const PackedViewpoint& viewpoint, std::size_t index) {
  line(text, "  {} {} {} {}: transform {}{}", word, index, quoted(*viewpoint.name()), quoted(*viewpoint.description()),
       viewpoint.transform(),
       viewpoint.orthographic()        ? ", orthographic"
       : viewpoint.field_is_vertical() ? ", by its height"
                                       : "");
  line(text, "    slots: position {}, orientation {}, field of view {}", slot(viewpoint.position()),
       slot(viewpoint.orientation()), slot(viewpoint.field_of_view()));
  if (viewpoint.direction() != kNoSlot || viewpoint.up() != kNoSlot)
    line(text, "    slots: direction {}, up {}", slot(viewpoint.direction()), slot(viewpoint.up()));
}

std::string slots(const flatbuffers::Vector<std::uint32_t>& list) {
  std::string text;
  for (const std::uint32_t index : list) text.append(" ").append(slot(index));
  return text;
}

/// Without lines, which are others in each encoding of a scene.
void dump_script(Text& text, const PackedScript& script) {
  for (flatbuffers::uoffset_t i = 0; i < script.variables()->size(); ++i) {
    const PackedScriptVariable& variable = *script.variables()->Get(i);
    const double* const first = script.values()->data() + variable.first();
    line(text, "    variable {}, field {}: {}", i, variable.field(), fmt::join(first, first + variable.count(), " "));
  }
  for (const PackedScriptFunction* function : *script.functions())
    line(text, "    function of field {}: steps {} to {}, value {}, time {}", function->field(), function->begin(),
         function->end(), slot(function->value()), slot(function->time()));
  for (flatbuffers::uoffset_t i = 0; i < script.steps()->size(); ++i) {
    const PackedScriptStep& step = *script.steps()->Get(i);
    line(text, "    step {}: {} {}", i, EnumNamePackedScriptOp(step.op()), step.operand());
  }
}

void dump_events(Text& text, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; scene.event_nodes() != nullptr && i < scene.event_nodes()->size(); ++i) {
    const PackedEventNode& node = *scene.event_nodes()->Get(i);
    line(text, "  event node {} {}:{} ->{}{}", i, EnumNamePackedEventKind(node.kind()), slots(*node.inputs()),
         slots(*node.outputs()), node.subject() < 0 ? "" : fmt::format(", subject {}", node.subject()));
    if (node.script() != nullptr) dump_script(text, *node.script());
  }
  if (scene.routes() == nullptr) return;
  for (const PackedRoute* route : *scene.routes()) line(text, "  route slot {} to slot {}", route->from(), route->to());
}

void dump_live_mesh(Text& text, const PackedLiveMesh& live) {
  line(text, "  live mesh {}{}", live.mesh(), live.normals() == nullptr ? "" : ", normals are made");
  for (const PackedVertexFeed* feed : *live.feeds()) {
    line(text, "    {} {} from slot {}, {} numbers each, elements: {}", EnumNamePackedSemantic(feed->semantic()), feed->unit(),
         feed->slot(), feed->width(), sized(*feed->elements(), "numbers"));
  }
  if (const PackedMadeNormals* made = live.normals())
    line(text, "    {} faces{}, least cosine {:g}, corners: {}", made->face_ends()->size(),
         made->clockwise() ? ", clockwise" : "", made->least_cosine(), sized(*made->corners(), "numbers"));
  for (flatbuffers::uoffset_t i = 0; live.box_coords() != nullptr && i < live.box_coords()->size(); ++i)
    line(text, "    coordinates {} lie over the box: {}", live.box_coords()->Get(i)->unit(),
         EnumNamePackedBoxLayout(live.box_coords()->Get(i)->layout()));
  if (live.tangent_unit() >= 0) line(text, "    tangents run along coordinates {}", live.tangent_unit());
}

/// What is bound now, where that changes.
void dump_bindings_now(Text& text, const PackedScene& scene) {
  if (scene.bound_viewpoint_now() != kNoSlot) line(text, "  slot {} is the bound viewpoint", scene.bound_viewpoint_now());
  if (scene.bound_background() != kNoSlot) line(text, "  slot {} is the bound background", scene.bound_background());
}

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

template <typename List, typename Function>
void each(const List& list, Function function) {
  for (flatbuffers::uoffset_t i = 0; i < list.size(); ++i) function(*list.Get(i), i);
}

void dump_scene(Text& text, const Package& package, const PackedScene& scene, std::size_t index) {
  line(text, "scene {} {}: background color slot {}", index, quoted(*scene.name()), slot(scene.background_color()));
  if (scene.visibility_limit() != kNoSlot) line(text, "  visibility limit slot {}", scene.visibility_limit());
  dump_slots(text, scene);
  each(*scene.transforms(), [&](const PackedTransform& transform, std::size_t i) { dump_transform(text, transform, i); });
  dump_billboards(text, scene);
  dump_clip_planes(text, scene);
  dump_fog_planes(text, scene);
  dump_lod_levels(text, scene);
  each(*scene.lights(), [&](const PackedLight& light, std::size_t i) { dump_light(text, light, i); });
  each(*scene.shadow_maps(), [&](const PackedShadowMap& map, std::size_t i) { dump_shadow_map(text, package, map, i); });
  each(*scene.texture_transforms(),
       [&](const PackedTextureTransform& transform, std::size_t i) { dump_texture_transform(text, transform, i); });
  each(*scene.shapes(), [&](const PackedShape& shape, std::size_t i) { dump_shape(text, package, shape, i); });
  each(*scene.viewpoints(),
       [&](const PackedViewpoint& viewpoint, std::size_t i) { dump_viewpoint(text, "viewpoint", viewpoint, i); });
  if (scene.viewpoints()->size() != 0 && scene.bound_viewpoint() != 0)
    line(text, "  bound viewpoint {}", scene.bound_viewpoint());
  each(*scene.projectors(),
       [&](const PackedViewpoint& viewpoint, std::size_t i) { dump_viewpoint(text, "projector", viewpoint, i); });
  dump_bindings_now(text, scene);
  dump_events(text, scene);
  if (scene.live_meshes() != nullptr)
    each(*scene.live_meshes(), [&](const PackedLiveMesh& live, std::size_t) { dump_live_mesh(text, live); });
  if (scene.rendered_textures() != nullptr)
    each(*scene.rendered_textures(),
         [&](const PackedRenderedTexture& texture, std::size_t i) { dump_rendered_texture(text, texture, i); });
  if (scene.screen_effects() != nullptr)
    each(*scene.screen_effects(),
         [&](const PackedScreenEffect& effect, std::size_t i) { dump_screen_effect(text, package, effect, i); });
}

void dump_effect(Text& text, const PackedEffect& effect, std::size_t index) {
  line(text, "effect {} {}: scene {}, source {} line {}", index, quoted(*effect.name()), effect.scene(),
       effect.origin()->source(), effect.origin()->line());
  line(text, "  needs:{}", quoted(*effect.needs()));
  line(text, "  offers:{}", quoted(*effect.offers()));
  for (const auto* field : *effect.fields()) line(text, "  field {}: slot {}", quoted(*field->name()), field->slot());
  for (const auto* kind : *effect.kinds())
    line(text, "  kind {}: choice {}, program {}", quoted(*kind->name()), kind->choice(), kind->program());
}

}  // namespace

std::string dump_package(const Package& package) {
  Text text;
  line(text, "package by {}", quoted(*package.generator()));
  each(*package.sources(),
       [&](const flatbuffers::String& name, std::size_t i) { line(text, "source {} {}", i, quoted(name)); });
  each(*package.programs(), [&](const PackedProgram& program, std::size_t i) { dump_program(text, program, i); });
  each(*package.meshes(), [&](const PackedMesh& mesh, std::size_t i) { dump_mesh(text, mesh, i); });
  each(*package.images(), [&](const PackedImage& image, std::size_t i) { dump_image(text, image, i); });
  each(*package.textures(), [&](const PackedTexture& texture, std::size_t i) { dump_texture(text, texture, i); });
  each(*package.scenes(), [&](const PackedScene& scene, std::size_t i) { dump_scene(text, package, scene, i); });
  each(*package.effects(), [&](const PackedEffect& effect, std::size_t i) { dump_effect(text, effect, i); });
  return fmt::to_string(text);
}

}  // namespace plugc

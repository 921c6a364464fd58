// One line a fact, in the order of the schema, indented by what holds it. Everything that decides what is drawn is written
// out; texts, vertices and pixels are told by their size and hash, so that a dump stays a page that people compare.
// Numbers are written in the shortest form that reads back to the same value, so equal packages give equal text.

#include "package/package_file_dump.h"

#include <algorithm>

namespace plugc {
namespace {

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

void dump_texture(Text& text, const PackedTexture& texture, std::size_t index) {
  line(text, "texture {}: image {}, wrap {} {} {}, filter {} {}{}", index, texture.image(),
       EnumNamePackedWrap(texture.wrap_s()), EnumNamePackedWrap(texture.wrap_t()), EnumNamePackedWrap(texture.wrap_r()),
       EnumNamePackedFilter(texture.minification()), EnumNamePackedFilter(texture.magnification()), border(texture.border()));
}

// ---- effects ----

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

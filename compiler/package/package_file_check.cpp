// Follows every index of a package that has passed FlatBuffers' verifier, list by list, and stops at the first that leads
// nowhere. The verifier guarantees that every offset is good and every required list there, but knows nothing of what the
// numbers mean.

#include "package/package_file_check.h"

namespace plugc {

std::string to_text(const Place& place) {
  const std::string here = fmt::format("{} {}", place.word, place.index);
  return place.outer == nullptr ? here : to_text(*place.outer) + ", " + here;
}

namespace {

bool check_effect(PackageCheck& check, const PackedEffect& effect, const Place& place) {
  const auto& scenes = *check.package.scenes();
  if (!check.require_index(place, "scene", effect.scene(), scenes.size())) return false;
  SceneCheck scene{check, *scenes.Get(effect.scene())};
  return check.charge(place, *effect.name()) && check_origin(check, *effect.origin(), place) &&
         check.each(
             &place, "field", *effect.fields(),
             [&](const PackedEffectField* field, const Place& at) { return scene.present_slot(at, "it", field->slot(), 1); }) &&
         check.each(&place, "kind", *effect.kinds(), [&](const PackedEffectKind* kind, const Place& at) {
           return check.require_index(at, "program", kind->program(), check.package.programs()->size());
         });
}

}  // namespace

std::string check_package(const Package& package, std::size_t buffer_size) {
  PackageCheck check{package, buffer_size, {}};
  check.each(nullptr, "program", *package.programs(),
             [&](const PackedProgram* program, const Place& at) { return check_program(check, *program, at); }) &&
      check.each(nullptr, "mesh", *package.meshes(),
                 [&](const PackedMesh* mesh, const Place& at) { return check_mesh(check, *mesh, at); }) &&
      check.each(nullptr, "image", *package.images(),
                 [&](const PackedImage* image, const Place& at) { return check_image(check, *image, at); }) &&
      check.each(nullptr, "texture", *package.textures(),
                 [&](const PackedTexture* texture, const Place& at) { return check_texture(check, *texture, at); }) &&
      check.each(nullptr, "scene", *package.scenes(),
                 [&](const PackedScene* scene, const Place& at) { return check_scene(check, *scene, at); }) &&
      check.each(nullptr, "effect", *package.effects(),
                 [&](const PackedEffect* effect, const Place& at) { return check_effect(check, *effect, at); });
  return check.error;
}

}  // namespace plugc

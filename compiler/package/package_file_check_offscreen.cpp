// Textures that the scene renders, and its screen effects.

#include "base/rendered_limits.h"
#include "package/package_file_check.h"

namespace plugc {
namespace {

constexpr std::uint32_t kMatrixNumbers = 16;

bool check_sides(PackageCheck& check, const PackedRenderedTexture& texture, const Place& place) {
  const bool cube = texture.kind() == PackedRenderedKind::cube;
  const std::uint32_t largest = cube ? kMaxRenderedCubeSide : kMaxRenderedSide;
  const auto fits = [&](std::uint32_t side) { return side >= 1 && side <= largest; };
  const bool good = fits(texture.width()) && fits(texture.height()) && (!cube || texture.width() == texture.height());
  return good || check.fail(place, fmt::format("its size {} x {} is out of range", texture.width(), texture.height()));
}

bool check_slots(SceneCheck& scene, const char* word, const flatbuffers::Vector<std::uint32_t>* slots, std::uint32_t numbers,
                 const Place& place) {
  return slots == nullptr || scene.check.each(&place, word, *slots, [&](std::uint32_t slot, const Place& at) {
    return scene.present_slot(at, "it", slot, numbers);
  });
}

/// All together lend no more numbers than the scene has, as none is lent to twice.
bool check_loans(SceneCheck& scene, const PackedRenderedTexture& texture, const Place& place) {
  std::uint64_t left = scene.scene.slot_values()->size();
  return texture.loans() == nullptr ||
         scene.check.each(&place, "loan", *texture.loans(), [&](const PackedRoute* loan, const Place& at) {
           if (!scene.same_size(at, loan->from(), loan->to())) return false;
           const std::uint64_t size = scene.slot_size(loan->to());
           if (size > left) return scene.check.fail(at, "more is lent than there is");
           left -= size;
           return true;
         });
}

bool check_rendered_texture(SceneCheck& scene, const PackedRenderedTexture& texture, const Place& place) {
  PackageCheck& check = scene.check;
  if (!is_enumerator(texture.kind())) return check.fail(place, "its kind is unknown");
  if (!is_enumerator(texture.update())) return check.fail(place, "its update mode is unknown");
  if (!is_enumerator(texture.wrap_s()) || !is_enumerator(texture.wrap_t()))
    return check.fail(place, "its wrap mode is unknown");
  if (!is_enumerator(texture.minification()) || texture.magnification() > PackedFilter::linear)
    return check.fail(place, "its filter is unknown");
  if (!is_index_or_none(texture.viewpoint(), scene.scene.projectors()->size()))
    return check.fail(place, fmt::format("viewpoint {} does not exist", texture.viewpoint()));
  return check_sides(check, texture, place) && scene.slot(place, "background color", texture.background_color(), 3) &&
         scene.slot(place, "distance from shape", texture.distance_from_shape(), 1) &&
         check_slots(scene, "rendering slot", texture.rendering_slots(), 1, place) &&
         check_slots(scene, "viewing slot", texture.viewing_slots(), kMatrixNumbers, place) &&
         check_slots(scene, "projection slot", texture.projection_slots(), kMatrixNumbers, place) &&
         check_loans(scene, texture, place);
}

bool check_screen_effect(SceneCheck& scene, const PackedScreenEffect& effect, const Place& place) {
  PackageCheck& check = scene.check;
  const Drawn drawn = effect.needs_depth() ? Drawn::screen_effect_with_depth : Drawn::screen_effect;
  return check.charge(place, *effect.name()) &&
         check.require_index(place, "program", effect.program(), check.package.programs()->size()) &&
         check_bindings(scene, drawn, "binding", *effect.bindings(), static_cast<std::int32_t>(effect.program()), place) &&
         scene.slot(place, "enabled", effect.enabled(), 1) && scene.transform(place, effect.transform());
}

}  // namespace

bool check_offscreen(SceneCheck& scene, const Place& place) {
  const auto* textures = scene.scene.rendered_textures();
  const auto* effects = scene.scene.screen_effects();
  return (textures == nullptr || scene.check.each(&place, "rendered texture", *textures,
                                                  [&](const PackedRenderedTexture* texture, const Place& at) {
                                                    return check_rendered_texture(scene, *texture, at);
                                                  })) &&
         (effects == nullptr ||
          scene.check.each(&place, "screen effect", *effects, [&](const PackedScreenEffect* effect, const Place& at) {
            return check_screen_effect(scene, *effect, at);
          }));
}

}  // namespace plugc

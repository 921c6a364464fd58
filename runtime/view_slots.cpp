#include "runtime/view_slots.h"

#include <array>
#include <ranges>
#include <span>

#include <glm/gtc/type_ptr.hpp>

namespace plugc {
namespace {

using SlotList = flatbuffers::Vector<std::uint32_t>;

void set_all(Slots& slots, const SlotList* list, std::span<const double> values) {
  if (list == nullptr) return;
  for (const std::uint32_t slot : *list) slots.set(slot, values);
}

void set_rendering(Slots& slots, const PackedRenderedTexture& texture, bool rendering) {
  const std::array<double, 1> value = {rendering ? 1.0 : 0.0};
  set_all(slots, texture.rendering_slots(), value);
}

std::span<const double> numbers(const glm::dmat4& matrix) {
  return {glm::value_ptr(matrix), 16};
}

std::vector<double> copy(std::span<const double> values) {
  return {values.begin(), values.end()};
}

}  // namespace

LentSlots begin_view(Slots& slots, const PackedRenderedTexture& texture) {
  set_rendering(slots, texture, true);
  LentSlots lent;
  if (texture.loans() == nullptr) return lent;
  for (const PackedRoute* loan : *texture.loans()) {
    lent.emplace_back(loan->to(), copy(slots.values(loan->to())));
    slots.set(loan->to(), copy(slots.values(loan->from())));
  }
  return lent;
}

void tell_view(Slots& slots, const PackedRenderedTexture& texture, const View& camera) {
  set_all(slots, texture.viewing_slots(), numbers(camera.world_to_eye));
  set_all(slots, texture.projection_slots(), numbers(camera.projection));
}

void end_view(Slots& slots, const PackedRenderedTexture& texture, const LentSlots& lent) {
  for (const auto& [slot, values] : lent | std::views::reverse) slots.set(slot, values);
  set_rendering(slots, texture, false);
}

}  // namespace plugc

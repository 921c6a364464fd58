// A copy of the package's slot values, changed in place.

#include "runtime/events.h"

#include <algorithm>
#include <cstring>

namespace plugc {
Slots::Slots(const PackedScene& scene)
    : slots_(scene.slots()),
      values_(scene.slot_values()->begin(), scene.slot_values()->end()),
      changed_at_(scene.slots()->size(), revision_) {}

std::span<const double> Slots::values(std::uint32_t slot) const {
  if (slot == kNoSlot || slots_ == nullptr || slot >= slots_->size()) return {};
  if (watching_) watched_[slot] = true;
  const PackedSlot& packed = *slots_->Get(slot);
  return std::span(values_).subspan(packed.first(), std::size_t{component_count(packed.type())} * packed.count());
}

std::size_t Slots::element_size(std::uint32_t slot) const {
  return values(slot).empty() ? 0 : component_count(slots_->Get(slot)->type());
}

double Slots::component(std::uint32_t slot, std::size_t index, double fallback) const {
  const std::span<const double> all = values(slot);
  return index < all.size() ? all[index] : fallback;
}

glm::dvec3 Slots::vector3(std::uint32_t slot, const glm::dvec3& fallback) const {
  return {component(slot, 0, fallback.x), component(slot, 1, fallback.y), component(slot, 2, fallback.z)};
}

glm::dvec4 Slots::vector4(std::uint32_t slot, const glm::dvec4& fallback) const {
  return {vector3(slot, fallback), component(slot, 3, fallback.w)};
}

bool Slots::set(std::uint32_t slot, std::span<const double> changed) {
  const std::span<const double> old = values(slot);
  if (old.empty() || old.size() != changed.size()) return false;
  if (std::memcmp(old.data(), changed.data(), old.size_bytes()) == 0) return true;
  std::copy(changed.begin(), changed.end(), values_.begin() + slots_->Get(slot)->first());
  changed_at_[slot] = ++revision_;
  if (!watched_.empty() && watched_[slot]) ++watched_revision_;
  return true;
}

void Slots::set_watching(bool on) {
  watching_ = on;
  if (slots_ != nullptr) watched_.resize(slots_->size(), false);
}

void Slots::restore(const PackedScene& scene) {
  values_.assign(scene.slot_values()->begin(), scene.slot_values()->end());
  ++revision_;
  ++watched_revision_;
  std::ranges::fill(changed_at_, revision_);
}

}  // namespace plugc

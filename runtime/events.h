#pragma once
// The values that may change while a scene is drawn. A slot is read with the default that its field has in X3D, which
// applies where a package names no slot.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "package/package_file.h"

namespace plugc {

class Slots {
 public:
  Slots() = default;
  explicit Slots(const PackedScene& scene);

  double number(std::uint32_t slot, double fallback) const { return component(slot, 0, fallback); }
  bool boolean(std::uint32_t slot, bool fallback) const { return number(slot, fallback ? 1.0 : 0.0) != 0.0; }
  glm::dvec3 vector3(std::uint32_t slot, const glm::dvec3& fallback) const;
  glm::dvec4 vector4(std::uint32_t slot, const glm::dvec4& fallback) const;

  std::span<const double> values(std::uint32_t slot) const;
  /// Numbers of one element.
  std::size_t element_size(std::uint32_t slot) const;

  /// False when there is no such slot, or it holds another number of values. The same bits are no change: so NaN, which equals
  /// nothing, is none either.
  bool set(std::uint32_t slot, std::span<const double> values);

  /// All values as the package has them.
  void restore(const PackedScene& scene);

  /// Grows whenever a value changes: what was computed at an older revision may be out of date.
  std::uint64_t revision() const { return revision_; }
  /// The revision that the slot's last change made; of a slot that there is.
  std::uint64_t changed_at(std::uint32_t slot) const { return changed_at_[slot]; }

  /// While it is on, what is read is noted: from then on a change of such a slot makes watched_revision() grow, too.
  void set_watching(bool on);
  std::uint64_t watched_revision() const { return watched_revision_; }

 private:
  double component(std::uint32_t slot, std::size_t index, double fallback) const;

  const flatbuffers::Vector<const PackedSlot*>* slots_ = nullptr;
  std::vector<double> values_;
  std::uint64_t revision_ = 1, watched_revision_ = 1;
  std::vector<std::uint64_t> changed_at_;  // by slot
  bool watching_ = false;
  mutable std::vector<bool> watched_;  // by slot; as long as there are slots once something has been watched
};

}  // namespace plugc

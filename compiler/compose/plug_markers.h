#pragma once
// The plug markers of a composition, by stage and name, and which of them a plug function reaches. Internal to the compose
// room.

#include <span>
#include <vector>

#include "compose/placed_unit.h"

namespace plugc {

struct MarkerPlace {
  ShaderStage stage = ShaderStage::vertex;
  std::string_view plug;
  std::size_t unit = 0;    ///< Into Composition::units.
  std::size_t marker = 0;  ///< Into its markers.
};

class PlugMarkers {
 public:
  /// The list of units must not change while this lives.
  explicit PlugMarkers(const Composition& composition);

  /// By stage, then by name, then in text order.
  std::span<const MarkerPlace> all() const { return places_; }
  /// A light's or texture's function looks at its own light or texture first, then at the shape (thesis 9.1.1); a marker in an
  /// effect serves what comes later, any other marker serves all.
  std::vector<MarkerPlace> reached_by(std::size_t unit, const PlugFunction& function) const;
  /// A marker of the name, in the stage or out of it; null when there is none.
  const MarkerPlace* find(std::string_view plug, ShaderStage stage, bool in_stage) const;

  const MarkerOutline& outline(const MarkerPlace& place) const {
    return c_.units[place.unit].code->outline.markers[place.marker];
  }
  Span span(const MarkerPlace& place) const {
    return c_.units[place.unit].code->span(outline(place).begin, outline(place).end);
  }

 private:
  std::vector<MarkerPlace> find_reached(std::size_t unit, const PlugFunction& function, bool own_scope) const;

  const Composition& c_;
  std::vector<MarkerPlace> places_;
};

}  // namespace plugc

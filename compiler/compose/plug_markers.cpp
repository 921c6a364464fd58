// One sorted list, so that a thousand effects cost a thousand times one.

#include "compose/plug_markers.h"

#include <algorithm>
#include <tuple>

namespace plugc {
namespace {

bool is_offered(const MarkerOutline& marker) {
  const bool in_function = marker.enclosing_function != UINT32_MAX;
  return marker.kind == MarkerKind::plug && in_function;
}

bool comes_before(const MarkerPlace& a, const MarkerPlace& b) {
  return std::tie(a.stage, a.plug, a.unit, a.marker) < std::tie(b.stage, b.plug, b.unit, b.marker);
}

}  // namespace

PlugMarkers::PlugMarkers(const Composition& composition) : c_(composition) {
  for (std::size_t u = 0; u < c_.units.size(); ++u) {
    const auto& markers = c_.units[u].code->outline.markers;
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (is_offered(markers[m])) places_.push_back({c_.units[u].stage, markers[m].name, u, m});
    }
  }
  std::ranges::sort(places_, comes_before);
}

std::vector<MarkerPlace> PlugMarkers::find_reached(std::size_t index, const PlugFunction& function, bool own_scope) const {
  const PlacedUnit& unit = c_.units[index];
  const bool limited = unit.scope.kind != ScopeKind::shape;
  std::vector<MarkerPlace> found;
  auto place = std::ranges::lower_bound(places_, MarkerPlace{unit.stage, function.plug, 0, 0}, comes_before);
  for (; place != places_.end() && place->stage == unit.stage && place->plug == function.plug; ++place) {
    const PlacedUnit& other = c_.units[place->unit];
    const bool of_effect = c_.owners[other.owner].kind == OwnerKind::effect;
    const bool in_itself = place->unit == index && outline(*place).enclosing_function == function.function;
    if (in_itself || other.dropped || (of_effect && place->unit >= index)) continue;
    if (!limited && other.offers_to_scope_alone) continue;
    if (limited && other.scope != (own_scope ? unit.scope : PlugScope())) continue;
    found.push_back(*place);
  }
  return found;
}

std::vector<MarkerPlace> PlugMarkers::reached_by(std::size_t unit, const PlugFunction& function) const {
  std::vector<MarkerPlace> found = find_reached(unit, function, true);
  const bool limited = c_.units[unit].scope.kind != ScopeKind::shape;
  return found.empty() && limited ? find_reached(unit, function, false) : found;
}

const MarkerPlace* PlugMarkers::find(std::string_view plug, ShaderStage stage, bool in_stage) const {
  const auto found = std::ranges::find_if(
      places_, [&](const MarkerPlace& place) { return place.plug == plug && (place.stage == stage) == in_stage; });
  return found == places_.end() ? nullptr : &*found;
}

}  // namespace plugc

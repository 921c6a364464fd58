#pragma once
// What is said of plug functions that do not suit their plugs. Internal to the compose room.

#include <span>

#include "compose/plug_markers.h"

namespace plugc {

/// What can be said of an author's function without looking at each marker; false where it cannot be called. A marker of the
/// templates, or none, goes by the table of plugs.
bool is_sound_plug(Composition& composition, const PlacedUnit& unit, const PlugFunction& function,
                   std::span<const MarkerPlace> markers);
/// A function that its marker's arguments do not fit.
void report_misfit(Composition& composition, const PlacedUnit& unit, const PlugFunction& function, const PlugMarkers& markers,
                   const MarkerPlace& place);
/// A function that reached no marker: tells a name that nobody offers from one that this shape merely has not.
void report_unreached(Composition& composition, const PlacedUnit& unit, const PlugFunction& function,
                      const PlugMarkers& markers);
/// Reports at the function's name.
void report_at_plug(Composition& composition, DiagnosticId id, const PlacedUnit& unit, const PlugFunction& function,
                    std::string message, std::vector<RelatedPlace> related = {});

}  // namespace plugc

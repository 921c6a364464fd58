#pragma once
// One placed unit as text: markers have become calls, prototypes stand in front, repeated declarations are gone, names are
// final. Internal to the compose room.

#include <string>
#include <unordered_map>

#include "compose/placed_unit.h"

namespace plugc {

/// What has been declared in the stage so far, by final name.
struct Declared {
  struct Declaration {
    std::string text;  ///< Without qualifiers that may differ, to compare.
    Span span;
    std::size_t owner = 0;
  };
  std::unordered_map<std::string, Declaration> globals;
  std::unordered_map<std::string, Declaration> structs;
};

/// Puts the unit behind what the stage has already.
void write_unit(Composition& composition, const PlacedUnit& unit, Declared& declared, MappedText& stage);

}  // namespace plugc

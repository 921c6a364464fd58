#pragma once
// One placed unit on its way to text, and the steps that take it there. Internal to the compose room.

#include <string>
#include <string_view>
#include <unordered_map>

#include "compose/placed_unit.h"
#include "compose/unit_edits.h"

namespace plugc {

/// What has been declared in the stage so far, by final name.
struct Declared {
  struct Global {
    Storage storage = Storage::none;
    std::string_view type, array;
    const PlacedUnit* unit = nullptr;       ///< Null for what the head of the stage declares.
    const GlobalOutline* global = nullptr;  ///< In that unit.
  };
  struct Struct {
    const PlacedUnit* unit = nullptr;
    const StructOutline* type = nullptr;
  };
  std::unordered_map<std::string_view, Global> globals;
  std::unordered_map<std::string_view, Struct> structs;
};

struct UnitDraft {
  UnitDraft(Composition& of, const PlacedUnit& placed)
      : composition(of),
        unit(placed),
        code(*placed.code),
        text(code.text.text()),
        edits(text),
        keeps_names(of.keeps_names(placed)) {}

  Composition& composition;
  const PlacedUnit& unit;
  const CodeUnit& code;
  const std::string_view text;
  UnitEdits edits;
  const bool keeps_names;  ///< No name of it changes, save those of plug functions.

  std::string_view final_name(std::string_view name) const { return keeps_names ? name : composition.final_name(unit, name); }
};

/// A piece of the unit's code that is written anew (a call's arguments, a declaration's rest), its names final.
std::string renamed(const UnitDraft& draft, std::string_view code);

/// Takes out what the stage has declared before and what its head has; notes what is new. Unequal declarations are reported.
void write_declarations(UnitDraft& draft, Declared& declared);
/// Calls in the place of markers, prototypes of what they call, and functions that call another owner's.
void write_calls(UnitDraft& draft);
/// Names of plug functions, then all others.
void write_names(UnitDraft& draft);

}  // namespace plugc

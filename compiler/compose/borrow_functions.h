#pragma once
// Functions that an owner only declares and another one defines. Internal to the compose room.

#include <vector>

#include "compose/placed_unit.h"

namespace plugc {

/// A prototype, and the owner that defines it.
struct Borrowing {
  std::size_t unit = 0;
  const FunctionOutline* prototype = nullptr;
  std::size_t definer = 0;
};

bool same_parameters(const FunctionOutline& a, const FunctionOutline& b);

/// In the unit's stage the name is the other owner's; what its owner means by it in another stage stays its own.
void borrow_name(Composition& composition, const PlacedUnit& unit, std::string_view name, std::size_t other);

/// Makes every prototype call what it means.
void borrow_functions(Composition& composition, const std::vector<Borrowing>& borrowings);

}  // namespace plugc

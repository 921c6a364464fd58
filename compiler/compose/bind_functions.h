#pragma once
// A function without a body is sought in the shape's other effects (the thesis's library parts). Internal to the compose room.

#include <map>
#include <vector>

#include "compose/borrow_functions.h"

namespace plugc {

class FunctionBinder {
 public:
  explicit FunctionBinder(Composition& composition) : c_(composition) {}
  /// Finds what the unit only declares; what nobody defines and something calls is reported.
  void bind(const PlacedUnit& unit);
  /// Gives the names, once all units are bound.
  void finish();

 private:
  /// A definition of a function, and whose it is.
  struct Definition {
    std::size_t owner = 0;
    const FunctionOutline* function = nullptr;
  };
  void index_definitions();
  std::set<std::size_t> definers(const PlacedUnit& unit, const FunctionOutline& prototype);
  void bind_prototype(const PlacedUnit& unit, const FunctionOutline& prototype);
  void note_undefined(const PlacedUnit& unit, const FunctionOutline& prototype);
  std::vector<RelatedPlace> undefined_causes(const PlacedUnit& unit, const FunctionOutline& prototype) const;
  void step_aside(const PlacedUnit& unit, std::string_view name);

  Composition& c_;
  std::map<std::pair<ShaderStage, std::string_view>, std::vector<Definition>> definitions_;  // made when first asked for
  std::vector<Borrowing> borrowings_;
  std::vector<std::pair<const PlacedUnit*, std::string_view>> idle_;  // functions that are declared, and no more
};

}  // namespace plugc

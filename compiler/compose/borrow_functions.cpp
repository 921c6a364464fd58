// A name that stands for functions of one other owner is that owner's name. One that stands for several owners' overloads, or
// for an own one too, stays the declaring owner's, and each prototype becomes a function that calls the right one: calls are
// never looked at, GLSL tells the overloads apart.

#include "compose/borrow_functions.h"

#include <algorithm>
#include <tuple>

namespace plugc {
namespace {

class Borrower {
 public:
  explicit Borrower(Composition& composition) : c_(composition) {}

  /// Overloads of one name that one owner borrows in one stage.
  void borrow(const std::vector<Borrowing>& overloads) {
    const PlacedUnit& unit = c_.units[overloads.front().unit];
    const std::string_view name = overloads.front().prototype->name;
    const std::string_view target = c_.name_of(overloads.front().definer, name);
    const bool one_definer = std::all_of(overloads.begin(), overloads.end(),
                                         [&](const Borrowing& each) { return c_.name_of(each.definer, name) == target; });
    one_definer && !defines(unit, name) ? borrow_name(c_, unit, name, overloads.front().definer) : forward(overloads);
  }

 private:
  /// Whether the unit's owner defines a function of the name in the unit's stage.
  bool defines(const PlacedUnit& unit, std::string_view name) const {
    return std::any_of(c_.units.begin(), c_.units.end(), [&](const PlacedUnit& other) {
      const auto& functions = other.code->outline.functions;
      const bool is_meant = !other.dropped && other.owner == unit.owner && other.stage == unit.stage;
      return is_meant && std::any_of(functions.begin(), functions.end(), [&](const FunctionOutline& function) {
               return function.name == name && function.is_definition();
             });
    });
  }

  void forward(const std::vector<Borrowing>& overloads) {
    take_name(c_.units[overloads.front().unit], overloads.front().prototype->name);
    std::vector<const FunctionOutline*> written;  // an owner's parts may declare the same overload each
    for (const Borrowing& each : overloads) {
      const bool again = std::any_of(written.begin(), written.end(),
                                     [&](const FunctionOutline* other) { return same_parameters(*other, *each.prototype); });
      if (again) continue;
      written.push_back(each.prototype);
      PlacedUnit& unit = c_.units[each.unit];
      const auto index = static_cast<std::size_t>(each.prototype - unit.code->outline.functions.data());
      unit.forwards.emplace_back(index, c_.name_of(each.definer, each.prototype->name));
    }
  }

  /// The name must be the owner's own in this stage, though no definition of its may have taken it.
  void take_name(const PlacedUnit& unit, std::string_view name) {
    std::string_view taken = c_.final_name(unit, name);
    if (!c_.taken.is_free(taken, in_stage(unit.stage), unit.owner)) {
      taken = c_.taken.new_name(name, unit.owner, c_.units);
      c_.owners[unit.owner].borrowed[static_cast<std::size_t>(unit.stage)].insert_or_assign(name, taken);
    }
    c_.taken.take(taken, in_stage(unit.stage), unit.owner);
  }

  Composition& c_;
};

}  // namespace

bool same_parameters(const FunctionOutline& a, const FunctionOutline& b) {
  return std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(), b.parameters.end(),
                    [](const Parameter& p, const Parameter& q) { return p.type == q.type && p.array == q.array; });
}

void borrow_name(Composition& composition, const PlacedUnit& unit, std::string_view name, std::size_t other) {
  auto& borrowed = composition.owners[unit.owner].borrowed[static_cast<std::size_t>(unit.stage)];
  borrowed.insert_or_assign(name, composition.name_of(other, name));
}

void borrow_functions(Composition& composition, const std::vector<Borrowing>& borrowings) {
  std::map<std::tuple<std::size_t, ShaderStage, std::string_view>, std::vector<Borrowing>> by_name;
  for (const Borrowing& each : borrowings) {
    const PlacedUnit& unit = composition.units[each.unit];
    by_name[{unit.owner, unit.stage, each.prototype->name}].push_back(each);
  }
  for (const auto& [key, overloads] : by_name) Borrower(composition).borrow(overloads);
}

}  // namespace plugc

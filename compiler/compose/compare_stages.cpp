// Within a stage, unequal declarations are found where they are written. A uniform of several stages, and what one stage hands
// to another, are compared here: else only the linker would see them, without a place.

#include <map>
#include <tuple>

#include <fmt/format.h>

#include "compose/bind_names.h"

namespace plugc {
namespace {

/// How declarations in two stages are one variable: as a uniform, or as what a stage hands to the next.
enum class Link : std::uint8_t { none, uniform, into_geometry, into_fragment };

/// The first declaration of a variable that stages share.
struct Linked {
  const PlacedUnit* unit = nullptr;
  const GlobalOutline* global = nullptr;
};

using LinkedVariables = std::map<std::tuple<Link, std::size_t, std::string_view>, Linked>;

/// What the vertex stage writes goes to the fragment stage where nothing stands between or plugc passes it on.
Link link(const Composition& c, const PlacedUnit& unit, const GlobalOutline& global) {
  if (global.storage == Storage::uniform) return Link::uniform;
  if (unit.stage == ShaderStage::vertex) {
    if (global.storage != Storage::out) return Link::none;
    return !c.has_geometry || c.passed.contains(c.name_of(unit.owner, global.name)) ? Link::into_fragment : Link::into_geometry;
  }
  if (global.storage == Storage::in) return unit.stage == ShaderStage::geometry ? Link::into_geometry : Link::into_fragment;
  return unit.stage == ShaderStage::geometry && global.storage == Storage::out ? Link::into_fragment : Link::none;
}

/// A geometry stage reads an array of what one vertex has.
bool are_equal(const GlobalOutline& a, const GlobalOutline& b, Link as) {
  return a.type == b.type && (as == Link::into_geometry || a.array == b.array);
}

void compare_unit(Composition& c, const PlacedUnit& unit, LinkedVariables& variables) {
  for (const GlobalOutline& global : unit.code->outline.globals) {
    const Link as = link(c, unit, global);
    if (as == Link::none || global.name.starts_with("castle_")) continue;
    const std::string_view name = as == Link::into_fragment ? unit.code->macro_word(global.name) : global.name;
    const Linked& first = variables.try_emplace({as, unit.owner, name}, Linked{&unit, &global}).first->second;
    if (first.unit->stage == unit.stage || are_equal(*first.global, global, as)) continue;
    c.report_fault(DiagnosticId::unequal_declarations, unit, global.name, global.name_begin,
                   fmt::format("`{}` is declared here as `{}{}`, and differently in the {} stage", global.name, global.type,
                               global.array, to_text(first.unit->stage)),
                   {{name_span(*first.unit->code, first.global->name, first.global->name_begin), "the other declaration"}});
  }
}

}  // namespace

void compare_stages(Composition& composition) {
  LinkedVariables variables;
  for (const PlacedUnit& unit : composition.units) {
    if (!unit.dropped && composition.by_author(unit)) compare_unit(composition, unit, variables);
  }
}

}  // namespace plugc

// Names are looked up in short tables; a near one is suggested. Plugc reads all nodes whatever the head asks for, so that
// nothing here is more than a warning. Of units only those matter to a picture that angles and lengths are in: forces and
// masses move bodies, which plugc does not.

#include "scene/check_head.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "scene/node_table.h"

namespace plugc {
namespace {

constexpr std::array<std::string_view, 8> kProfiles = {
    "CADInterchange", "Core", "Full", "Immersive", "Interactive", "Interchange", "MPEG4Interactive", "MedicalInterchange"};
constexpr std::array<std::string_view, 4> kUnitCategories = {"angle", "force", "length", "mass"};
/// What follows from the four (X3D 4.1 part 1, table 4.3), and time, which is always in seconds.
constexpr std::array<std::string_view, 6> kOtherCategories = {"acceleration", "angular_rate", "area",
                                                              "speed",        "time",         "volume"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_profile(const Name& profile, Diagnostics& diagnostics) {
  if (profile.empty() || contains(kProfiles, profile.text)) return;
  diagnostics.report(DiagnosticId::head_unknown, profile.span,
                     fmt::format("X3D has no profile `{}`{}", profile.text, did_you_mean(profile.text, kProfiles)));
}

void check_component(const ComponentSyntax& component, Diagnostics& diagnostics) {
  const std::string_view name = component.name.text;
  const auto known = component_table();
  const auto found = std::find_if(known.begin(), known.end(), [&](const ComponentInfo& one) { return one.name == name; });
  if (found == known.end()) {
    std::vector<std::string_view> names;
    for (const ComponentInfo& one : known) names.push_back(one.name);
    return diagnostics.report(DiagnosticId::head_unknown, component.name.span,
                              fmt::format("X3D has no component `{}`{}", name, did_you_mean(name, names)));
  }
  if (component.level >= 1 && component.level <= found->highest_level) return;
  diagnostics.report(DiagnosticId::head_unknown, component.level_span,
                     fmt::format("the component `{}` has no level {}; {}", name, component.level,
                                 found->highest_level == 1 ? "it has level 1 alone"
                                                           : fmt::format("it has levels 1 to {}", found->highest_level)));
}

void check_category(const UnitSyntax& unit, Diagnostics& diagnostics) {
  const Name& category = unit.category;
  if (category.empty()) {
    return diagnostics.report(DiagnosticId::head_unknown, unit.name.span,
                              fmt::format("the unit `{}` needs a category: angle, force, length or mass", unit.name.text));
  }
  const std::string_view problem =
      contains(kOtherCategories, category.text) ? "no file chooses the unit of" : "no unit is of the category";
  diagnostics.report(DiagnosticId::head_unknown, category.span,
                     fmt::format("{} `{}`{}", problem, category.text, did_you_mean(category.text, kUnitCategories)));
}

void check_unit(const UnitSyntax& unit, Diagnostics& diagnostics) {
  if (!contains(kUnitCategories, unit.category.text)) return check_category(unit, diagnostics);
  const bool angle = unit.category.text == "angle";
  if (unit.factor == 1 || (!angle && unit.category.text != "length")) return;
  diagnostics.report(DiagnosticId::unit_not_converted, unit.factor_span,
                     angle ? "plugc converts no units: the angles of this file are read as radians"
                           : "plugc converts no units: where files of different units of length are joined, sizes differ");
}

}  // namespace

void check_head(const HeadSyntax& head, Diagnostics& diagnostics) {
  check_profile(head.profile, diagnostics);
  for (const ComponentSyntax& component : head.components) check_component(component, diagnostics);
  for (const UnitSyntax& unit : head.units) check_unit(unit, diagnostics);
}

}  // namespace plugc

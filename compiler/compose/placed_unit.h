#pragma once
// The working state of one composition. Internal to the compose room: place_units.cpp makes it, resolve_plugs.cpp decides
// the calls, name_owners.cpp and bind_names.cpp give every name its final form, stage_text.cpp writes it down.

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "compose/castle_names.h"
#include "compose/compose.h"

namespace plugc {

/// Whose names a unit's names are.
enum class OwnerKind : std::uint8_t { renderer, effect, shader };

/// What a unit acts on: the whole shape, one light, one texture, the fog, or what is cut by one clip plane.
enum class ScopeKind : std::uint8_t { shape, light, texture, fog, clip_plane };
struct PlugScope {
  ScopeKind kind = ScopeKind::shape;
  int number = -1;
  friend auto operator<=>(PlugScope, PlugScope) = default;
};

struct Owner {
  OwnerKind kind = OwnerKind::renderer;
  int index = -1;                                                ///< Into Scene::effects or Scene::shaders.
  using Renames = std::map<std::string_view, std::string_view>;  // both live as long as the composition (TakenNames::keep)
  Renames renames = {};
  /// Names of other owners for what a stage of this one only declares; they come before `renames`.
  std::array<Renames, kStageCount> borrowed = {};
  bool keeps_names_in(ShaderStage stage) const { return renames.empty() && borrowed[static_cast<std::size_t>(stage)].empty(); }
};

/// A call that a marker gets: which plug function of which unit.
struct PlugCall {
  std::size_t unit = 0;
  std::size_t function = 0;
  bool rgb_only = false;                 ///< A vec3 function at a vec4 marker: it gets `.rgb` of the first argument.
  std::vector<std::size_t> guards = {};  ///< Only while these are on; into ComposedProgram::switches.
};

struct PlacedUnit {
  std::shared_ptr<const CodeUnit> code;
  ShaderStage stage = ShaderStage::vertex;
  std::size_t owner = 0;  ///< Into Composition::owners; 0 is the renderer.
  PlugScope scope;
  std::vector<std::size_t> guards;               ///< Its code runs while these are on; into ComposedProgram::switches.
  bool of_shadow = false;                        ///< Without it the shape merely shows no shadow of its light.
  bool offers_to_scope_alone = false;            ///< What acts on the whole shape does not reach its markers.
  bool dropped = false;                          ///< A piece of the renderer whose plugs the base shader lacks.
  std::vector<std::string_view> function_names;  ///< Final names of plug functions by function; others are empty.
  std::vector<std::vector<PlugCall>> calls;      ///< By marker.
  /// Prototypes that get a body which calls another owner's function: by function, with the final name of the other's.
  std::vector<std::pair<std::size_t, std::string_view>> forwards;
  std::vector<std::string> passes;  ///< Varyings that this unit hands through the geometry stage, as its owner names them.
};

PlacedUnit make_placed_unit(std::shared_ptr<const CodeUnit> code, ShaderStage stage, std::size_t owner = 0,
                            PlugScope scope = {});

/// The stages in which a name counts.
using StageMask = unsigned;
constexpr StageMask in_stage(ShaderStage stage) {
  return 1U << static_cast<unsigned>(stage);
}
inline constexpr StageMask kAllStages = (1U << kStageCount) - 1;

/// The names that are taken, and by whom.
class TakenNames {
 public:
  /// Whether nobody else has the name in any of the stages.
  bool is_free(std::string_view name, StageMask stages, std::size_t owner) const;
  /// `name` must live as long as this: it stands in some unit's code, or has been kept.
  void take(std::string_view name, StageMask stages, std::size_t owner);
  /// `name_2`, `name_3`, ...: the first that is free in all stages and none of the owner's own words.
  std::string_view new_name(std::string_view name, std::size_t owner, const std::vector<PlacedUnit>& units);
  /// A name that stands in nobody's code, for as long as this lives.
  std::string_view keep(std::string name) { return kept_.emplace_back(std::move(name)); }

 private:
  const std::unordered_set<std::string_view>& words_of(std::size_t owner, const std::vector<PlacedUnit>& units);
  std::unordered_map<std::string_view, std::array<std::size_t, kStageCount>> owners_;  // by stage
  std::deque<std::string> kept_;
  std::unordered_map<std::string_view, int> next_number_;  // so that a thousand equal names stay cheap
  std::unordered_map<std::size_t, std::unordered_set<std::string_view>> words_;
};

/// What the head of a geometry stage says.
struct GeometryStage {
  int input_size = 3;  ///< Vertices of an input primitive.
  std::string layout;  ///< `layout(triangles) in;` and a line end.
  Span layout_span;
  std::size_t owner = 0;  ///< Whose the `main` is.
};

struct Composition {
  Composition(const Recipe& asked, const ComposeInput& from, Target for_target, Diagnostics& sink, ComposedProgram& program)
      : recipe(asked), input(from), target(for_target), diagnostics(sink), result(program) {}

  const Recipe& recipe;
  const ComposeInput& input;
  const Target target;
  Diagnostics& diagnostics;
  ComposedProgram& result;
  std::vector<Owner> owners = {Owner{}};
  std::vector<PlacedUnit> units;  ///< In call order, which is also text order within a stage.
  TakenNames taken;
  bool has_geometry = false;  ///< The program has a geometry stage.
  GeometryStage geometry;
  std::map<std::string_view, std::string_view> precisions;     ///< Of uniforms that are declared with several.
  std::map<std::string_view, std::uint32_t> output_locations;  ///< Of the fragment stage, by final name, where it has several.
  Owner::Renames passed;  ///< Final names of varyings in front of the geometry stage and behind it.

  const SceneEffect& author(const Owner& owner) const {
    return (owner.kind == OwnerKind::shader ? input.scene.shaders : input.scene.effects)[static_cast<std::size_t>(owner.index)];
  }
  bool by_author(const PlacedUnit& unit) const { return owners[unit.owner].kind != OwnerKind::renderer; }
  /// Whether every name of the unit's code stays as it is.
  bool keeps_names(const PlacedUnit& unit) const {
    const bool behind_geometry = unit.stage == ShaderStage::fragment && !passed.empty();
    return !behind_geometry && owners[unit.owner].keeps_names_in(unit.stage);
  }
  /// A name as the composed text has it; in fragment code a varying that has passed a geometry stage has the name that it has
  /// there.
  std::string_view final_name(const PlacedUnit& unit, std::string_view name) const;
  /// What the owner's name is called once no two owners' names meet.
  std::string_view name_of(std::size_t owner, std::string_view name) const;
  /// The GLSL type of a castle_ name here: of a texture, its own sampler.
  std::string_view type_of(const CastleName& name) const;
  /// Notes that the unit's effect takes something from another author.
  void note_need(const PlacedUnit& unit, std::size_t provider, NeedKind kind, std::string_view name);
  /// Leaves the unit's effect (or the ComposedShader) out of the program.
  void mark_faulty(const PlacedUnit& unit) { mark_faulty(owners[unit.owner]); }
  void mark_faulty(const Owner& owner);
  bool is_faulty(const PlacedUnit& unit) const;
  /// Reports at a name that stands at `begin` in the unit's code, and leaves its author out.
  void report_fault(DiagnosticId id, const PlacedUnit& unit, std::string_view name, std::uint32_t begin, std::string message,
                    std::vector<RelatedPlace> related = {});
};

/// The place of a name that stands at `begin` in the unit's text.
Span name_span(const CodeUnit& code, std::string_view name, std::uint32_t begin);

/// Where a name stands that seems to be missing: in an author's code of the stage that is broken or not wholly understood. The
/// first such place, else the first such code, or none.
std::vector<RelatedPlace> doubtful_places(const ComposeInput& input, ShaderStage stage, std::string_view name);

/// The pieces of code that the recipe asks for.
void place_units(Composition& composition);
/// A call at every marker for every plug function that reaches it.
void resolve_plugs(Composition& composition);
/// Gives every global its name.
void name_owners(Composition& composition);
/// Finds what owners only declare: functions and inputs of other owners, fields that feed uniforms.
void bind_names(Composition& composition);
/// The text of a stage. From here no PLUG marker remains.
MappedText stage_text(Composition& composition, ShaderStage stage);

}  // namespace plugc

#pragma once
// The working state of one composition. Internal to the compose room: place_units.cpp makes it, resolve_plugs.cpp adds
// the calls, join_units.cpp turns it into text.

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "compose/compose.h"

namespace plugc {

/// Whose names a unit's names are.
enum class OwnerKind : std::uint8_t { renderer, effect, shader };

/// What a unit acts on: the whole shape, one light or one texture.
enum class ScopeKind : std::uint8_t { shape, light, texture };
struct Scope {
  ScopeKind kind = ScopeKind::shape;
  int number = -1;
  friend bool operator==(Scope, Scope) = default;
};

struct Owner {
  OwnerKind kind = OwnerKind::renderer;
  int index = -1;                              ///< Into Scene::effects or Scene::shaders.
  std::map<std::string, std::string, std::less<>> renames;
};

/// A call that a marker gets: the statement, and the plug function's place.
struct PlugCall {
  std::string statement;
  Span origin;
};

/// A prototype that a unit needs in front of its functions.
struct ForwardDeclaration {
  std::string text;
  Span origin;
};

struct PlacedUnit {
  std::shared_ptr<const CodeUnit> code;
  ShaderStage stage = ShaderStage::vertex;
  std::size_t owner = 0;                        ///< Into Composition::owners; 0 is the renderer.
  Scope scope;
  bool dropped = false;                         ///< A piece of the renderer whose plugs the base shader lacks.
  std::vector<std::string> function_names;      ///< Final names by function; empty: not renamed one by one.
  std::vector<std::vector<PlugCall>> calls;     ///< By marker.
  std::vector<ForwardDeclaration> forward;
};

struct Composition {
  Composition(const Recipe& asked, const ComposeInput& from, Diagnostics& sink, ComposedProgram& program)
      : recipe(asked), input(from), diagnostics(sink), result(program) {}

  const Recipe& recipe;
  const ComposeInput& input;
  Diagnostics& diagnostics;
  ComposedProgram& result;
  std::vector<Owner> owners = {Owner{}};
  std::vector<PlacedUnit> units;                ///< In call order, which is also text order within a stage.
  std::array<std::map<std::string, std::size_t, std::less<>>, kStageCount> taken = {};  ///< Global names by stage -> owner.

  const SceneEffect& author(const Owner& owner) const {
    return (owner.kind == OwnerKind::shader ? input.scene.shaders : input.scene.effects)[static_cast<std::size_t>(owner.index)];
  }
  std::map<std::string, std::size_t, std::less<>>& taken_in(ShaderStage stage) { return taken[static_cast<std::size_t>(stage)]; }
  /// Leaves the unit's effect (or the ComposedShader) out of the program.
  void mark_faulty(const PlacedUnit& unit);
};

/// The pieces of code that the recipe asks for.
void place_units(Composition& composition);
/// A call at every marker for every plug function that reaches it.
void resolve_plugs(Composition& composition);
/// Gives every global its name, and says which uniforms the authors' fields feed.
void join_names(Composition& composition);
/// The text of a stage. From here no PLUG marker remains.
MappedText stage_text(Composition& composition, ShaderStage stage, Target target);

}  // namespace plugc

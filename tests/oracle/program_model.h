#pragma once
// One shape's program as the second composer builds it: its pieces of effect code, and the markers that they and the base
// shader offer. Internal to the second composer.

#include <set>
#include <string>
#include <vector>

#include "oracle/effect_set.h"
#include "oracle/plug_rows.h"
#include "oracle/specification.h"

namespace plugc::oracle {

enum class Stage { vertex, fragment };

enum class ScopeKind { shape, light, texture };
/// Whose code a piece is: the whole shape's, or that of one light or texture.
struct Scope {
  ScopeKind kind = ScopeKind::shape;
  int number = 0;
  friend bool operator==(const Scope&, const Scope&) = default;
};

/// A part of an effect, where it acts.
struct Piece {
  int effect = 0;
  int placement = 0;  ///< An effect that acts on two lights, or stands in two lists, is there twice.
  const PartModel* part = nullptr;
  Stage stage = Stage::vertex;
  Scope scope;
};

struct Call {
  std::size_t piece = 0;
  const FunctionModel* function = nullptr;
};

struct Marker {
  std::string plug;
  Stage stage = Stage::vertex;
  Scope scope;
  int piece = -1;                             ///< -1: of the base shader.
  const StatementModel* statement = nullptr;  ///< Of an author's marker.
  std::vector<Call> calls;
};

/// An effect that calls a function, reads a varying or fills a marker of another one, and of no one else.
struct Need {
  int effect = 0;
  int provider = 0;
};

struct ProgramModel {
  const EffectSet& set;
  const ShapeModel& shape;
  std::vector<Piece> pieces;    ///< In call order.
  std::vector<Marker> markers;  ///< Of the base shader in the order it reaches them, then those of the pieces.
  std::set<int> faulty;         ///< Effects that cannot stay in.
  std::vector<Need> needs;      ///< Who cannot stay in without whom.
};

/// A light of the program by its number: the effects on it.
std::vector<std::vector<int>> numbered_lights(const EffectSet& set);

void say(std::set<std::string>& said, int line, std::string_view code);

// The chapters, each in a file of its own.
void place_pieces(ProgramModel& program, const std::set<int>& left_out);                          // which code, in which order
void offer_plugs(ProgramModel& program);                                                          // which plugs the shape has
void fill_plugs(ProgramModel& program, std::set<std::string>& said);                              // who is called where
void check_names(ProgramModel& program, std::set<std::string>& said);                             // who is meant by a name
void check_fields(const EffectModel& effect, const EffectSet& set, std::set<std::string>& said);  // what feeds a uniform
ProgramTrace trace_program(const ProgramModel& program);  // all of it, in the order of a run

/// What a name means in a piece.
/// Definitions of the helper `name` for an argument of `type` that the piece can mean: its own effect's, else all others'.
std::vector<Call> helper_candidates(const ProgramModel& program, const Piece& piece, const std::string& name,
                                    const std::string& type);
/// The effects whose vertex code writes the varying that the piece names: its own effect's, else all others that do.
std::vector<int> varying_writers(const ProgramModel& program, const Piece& piece, const std::string& name,
                                 const std::string& type);
/// Tags of the vertex functions of an effect that write the varying.
std::set<int> writing_functions(const ProgramModel& program, int effect, const std::string& name);

}  // namespace plugc::oracle

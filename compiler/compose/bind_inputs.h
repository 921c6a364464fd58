#pragma once
// An input that no part of its own effect writes is sought in an earlier stage among the varyings of the others. Internal to
// the compose room.

#include <array>
#include <map>
#include <set>
#include <vector>

#include "compose/placed_unit.h"

namespace plugc {

class InputBinder {
 public:
  explicit InputBinder(Composition& composition) : c_(composition) {}
  /// Finds who writes what the unit reads; what nobody writes is reported.
  void bind(const PlacedUnit& unit);

 private:
  /// A declared output of a stage, and whose it is.
  struct Output {
    const PlacedUnit* unit = nullptr;
    const GlobalOutline* global = nullptr;
  };
  using Outputs = std::vector<Output>;

  void index_outputs();
  Outputs written_in(ShaderStage stage, std::string_view name);
  Outputs writers(ShaderStage reader, std::string_view name);
  void note_geometry(const PlacedUnit& unit, std::string_view name, const Outputs& all);
  void bind_input(const PlacedUnit& unit, const GlobalOutline& input);
  void report_unwritten(const PlacedUnit& unit, const GlobalOutline& input, std::size_t candidates);
  std::string unwritten_message(const PlacedUnit& unit, const GlobalOutline& input);
  std::vector<RelatedPlace> unwritten_causes(const PlacedUnit& unit, std::string_view name);
  bool in_vertex_stage(std::string_view castle_name) const;
  void check_castle_inputs(const PlacedUnit& unit);

  Composition& c_;
  bool indexed_ = false;
  std::array<std::map<std::string_view, Outputs>, kStageCount> outputs_;  // of each stage: by name; made when first asked for
};

}  // namespace plugc

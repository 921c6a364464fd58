#pragma once
// Which effects of an invalid program are at fault.

#include <map>
#include <set>
#include <vector>

#include "validate/candidate.h"

namespace plugc {

struct Fault {
  /// In call order: a minimal set of effects that fail together. Empty: the program fails without any effect.
  std::vector<int> effects;
  std::vector<ShaderMessage> messages;  ///< What glslang says of these effects alone.
  bool died = false;                    ///< Validating these alone crashed or took too long.
  bool is_sure = true;                  ///< False: checks ran out before the set was minimal.
};

/// Searches by composing subsets of a candidate's effects anew. What such trials find wrong is not reported: an effect may
/// miss another one there that it does not miss in the end.
class FaultSearch {
 public:
  /// `rechecks` are the checks that the whole search for the faults of one program may spend.
  FaultSearch(CandidateChecker& checker, const SourceSet& sources, std::size_t rechecks)
      : checker_(checker), sources_(sources), last_recheck_(checker.rechecks() + rechecks) {}

  /// `candidate` is not valid.
  Fault find(const ProgramCandidate& candidate);
  /// Further checks that may be made.
  std::size_t rechecks_left() const { return last_recheck_ - std::min(last_recheck_, checker_.rechecks()); }

 private:
  struct Trial {
    bool fails = false;
    bool died = false;
    std::vector<ShaderMessage> messages;
  };
  const Trial& try_effects(const ProgramCandidate& candidate, std::set<int> effects);
  bool fails_by_itself(const ProgramCandidate& candidate, int effect);
  std::vector<int> suspects(const ProgramCandidate& candidate) const;
  std::set<int> bisect(const ProgramCandidate& candidate, bool& is_sure);
  Fault fault_of(const ProgramCandidate& candidate, std::set<int> effects);

  CandidateChecker& checker_;
  const SourceSet& sources_;
  std::size_t last_recheck_;
  std::map<std::pair<int, std::set<int>>, Trial> trials_;  // by shader and effects
};

}  // namespace plugc

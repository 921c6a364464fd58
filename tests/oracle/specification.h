#pragma once
// The second composer: what composing an effect set must come to, computed the slow and obvious way from what is specified.
// It writes no text. What it says of a program is the trace of one run through it:
//
//     f17@light 1    the author's function with tag 17 is called, for light 1
//     u:E3.level     it reads the uniform that field `level` of effect E3 feeds; `E3.-`: that no field feeds
//     c:castle_X     it reads the renderer's uniform of that name
//     w:17,18 v:17   it writes, or reads, the varying that the vertex functions 17 (and 18) write
//     k30 m31 s2     it uses the constant 30, the macro 31, the structure with member_2

#include <set>
#include <string>
#include <vector>

#include "oracle/effect_set.h"

namespace plugc::oracle {

using Trace = std::vector<std::string>;

struct ProgramTrace {
  Trace vertex, fragment;
  std::set<std::string> plugs_filled;
  friend bool operator==(const ProgramTrace&, const ProgramTrace&) = default;
};

struct Outcome {
  std::set<std::string> said;          ///< `LINE code`.
  std::vector<ProgramTrace> programs;  ///< By shape.
};

Outcome expect_outcome(const EffectSet& set);

}  // namespace plugc::oracle

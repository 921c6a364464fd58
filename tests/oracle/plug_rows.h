#pragma once
// stdlib_plugs/plugs.tsv, as the generator and the second composer read it.

#include <span>
#include <string>
#include <vector>

#include "oracle/effect_set.h"

namespace plugc::oracle {

struct PlugRow {
  std::string name;
  char stage = 'F';  ///< V, G, F, or L: where the shape is lit.
  std::vector<ParameterModel> parameters;
  std::string replaced_by;
  std::vector<bool> keeps_changes;  ///< By parameter: const, but what is made of it counts.
};

/// All rows, in the order of the file, which is the order of the calls.
std::span<const PlugRow> plug_rows();
const PlugRow* find_row(const std::string& name);

}  // namespace plugc::oracle

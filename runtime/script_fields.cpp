#include "runtime/script_fields.h"

namespace plugc {
namespace {

template <typename Parts>
ScriptFields::Pairs by_field(const Parts& parts) {
  ScriptFields::Pairs pairs;
  for (flatbuffers::uoffset_t i = 0; i < parts.size(); ++i)
    pairs.emplace_back(static_cast<std::uint32_t>(parts.Get(i)->field()), i);
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

ScriptFields find_script_fields(const PackedEventNode& node) {
  ScriptFields found;
  for (flatbuffers::uoffset_t field = 0; field < node.inputs()->size(); ++field) {
    if (node.inputs()->Get(field) != kNoSlot) found.fields.emplace_back(node.inputs()->Get(field), field);
  }
  std::ranges::sort(found.fields);
  found.variables = by_field(*node.script()->variables());
  found.functions = by_field(*node.script()->functions());
  return found;
}

bool script_listens(const ScriptFields& fields, std::uint32_t field) {
  return !ScriptFields::beside(fields.functions, field).empty() || !ScriptFields::beside(fields.variables, field).empty();
}

}  // namespace plugc

#pragma once
// What a file of VRML 1.0 says, before its meaning: nodes with their fields and children. Values lie in the pools of the
// Document that is being made, so that those which X3D takes as they are need no copy.

#include <span>
#include <string_view>
#include <vector>

#include "document/document.h"
#include "document/vrml1_nodes.h"

namespace plugc {

struct Vrml1Field {
  const Vrml1FieldInfo* info = nullptr;
  Name name;
  ValueSyntax value;  ///< Words are strings; of kind `none` where what is written is no value (reported).
};

/// A node at the place where it is written or USEd.
struct Vrml1Child {
  std::uint32_t node = 0;
  Span place;
};

struct Vrml1Node {
  const Vrml1NodeInfo* info = nullptr;
  Name type, def;
  Range<Vrml1Field> fields;
  Range<Vrml1Child> children;
  bool is_used = false;  ///< By a USE.
};

/// No node contains itself: a USE names one that ended before it.
struct Vrml1Tree {
  std::vector<Vrml1Node> nodes;
  std::vector<Vrml1Field> fields;
  std::vector<Vrml1Child> child_pool;
  Range<Vrml1Child> roots;

  std::span<const Vrml1Field> of(Range<Vrml1Field> range) const { return {fields.data() + range.first, range.count}; }
  std::span<const Vrml1Child> of(Range<Vrml1Child> range) const { return {child_pool.data() + range.first, range.count}; }
};

}  // namespace plugc

#pragma once
// Values as written, read by the type of their field: numbers and strings. Nodes are the graph builder's.

#include <deque>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "document/document.h"
#include "scene/node_graph.h"

namespace plugc {

/// How many numbers the texts of attributes may still unfold to, in all files of a scene together.
struct NumberBudget {
  std::size_t left = kMaxDocumentNumbers;
  bool is_spent = false;  ///< Which was reported.
};

/// Where values live that no document holds.
struct ValueStore {
  /// Short lists, of which a scene has very many, share a block.
  std::span<const double> keep(std::vector<double> list);

  std::deque<std::vector<double>>& numbers;
  std::deque<std::vector<MappedText>>& strings;
  NumberBudget& budget;
};

/// What is asked of a value: its type and range, and what messages call it.
struct ValueContract {
  FieldType type = FieldType::unknown;
  const FieldInfo* info = nullptr;  ///< Range and words; null for a field that a prototype or a script declares.
  std::string_view field, node;     ///< "`radius` of `Sphere`".
};

/// Reads `syntax` (no nodes, no IS) as the contract says. False when it has no value of that type (reported, field_type,
/// unless the reader reported the mistake behind it). A number out of range (field_range) and a string that is none of the
/// field's words (field_value) are reported and kept.
bool read_value(const ValueSyntax& syntax, const Document& document, const ValueContract& contract, ValueStore& store,
                Diagnostics& diagnostics, FieldValue& value);

/// "a string stands", "3 numbers stand"...: for messages.
std::string what_stands(const ValueSyntax& value);

}  // namespace plugc

#pragma once
// The fields that a host may change while the scene is drawn, beside those that events change, and the events that are not
// followed because a program would have to be made anew for them.

#include <string>
#include <string_view>
#include <vector>

#include "scene/node_graph.h"

namespace plugc {

struct DynamicField {
  NodeId node;
  std::string_view name;  ///< As in the table or the interface.
};

/// The fields that `DEF.field` names, in every node that has the name (each instance of a prototype has its own). One that
/// does not exist, takes no events or holds no value is reported at the node. `known` gets the names that named a node at all.
std::vector<DynamicField> find_dynamic_fields(const NodeGraph& graph, const std::vector<std::string>& names,
                                              std::vector<std::string>& known, Diagnostics& diagnostics);

/// Routes into fields that decide what a program or a shape is made of: nodes and urls. They keep their first value.
void report_ignored_events(const NodeGraph& graph, Diagnostics& diagnostics);

}  // namespace plugc

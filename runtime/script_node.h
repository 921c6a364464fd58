#pragma once
// A Script in the event graph.

#include <cstdint>
#include <vector>

#include "runtime/event_node.h"
#include "runtime/messages.h"

namespace plugc {

/// What a Script sends that time or events wake: when it is woken first, `initialize` runs, then a function for each event.
/// `work_left`: of kMaxFrameScriptWork.
std::vector<SentEvent> wake_script(const EventNodeInputs& inputs, EventMemory& memory, std::uint64_t& work_left);

/// Says of each Script of the scene what it has to be told of.
void report_scripts(const Package& package, const PackedScene& scene, const std::vector<EventMemory>& memory,
                    Messages& messages);

}  // namespace plugc

#pragma once
// What is said when effects are left out: what glslang objects to, which effect goes, and which ones go with it.

#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "compose/compose.h"
#include "validate/validate.h"

namespace plugc {

/// Whether the place lies in the text of one of the author's parts, wherever that was read from.
bool lies_in(const Span& span, const SceneEffect& author);

/// glslang's messages about the authors' texts. Where none has a place there, all are said at `culprit`, as what the authors
/// wrote can break text behind theirs; `culprit` is not valid where the program fails without any author.
void report_messages(const std::vector<ShaderMessage>& messages, const std::vector<const SceneEffect*>& authors,
                     const Span& culprit, Diagnostics& diagnostics);

/// `failing` in call order: the effects that fail together, of which the last is left out. `where`: behind "is left out", such
/// as " of target `essl300`".
void report_left_out(const std::vector<int>& failing, int left_out, std::string_view where, const Scene& scene,
                     Diagnostics& diagnostics);

/// What was not understood of code that now turns out to be faulty.
void report_doubts(const EffectCode& code, Diagnostics& diagnostics);

/// An effect goes because what it needs has gone.
void report_lost_need(const EffectNeed& need, const Scene& scene, Diagnostics& diagnostics);

}  // namespace plugc

#pragma once
// Everything plugc says about the input. Kinds are registered in diagnostic_kinds.def, each with a stable code; a test
// fails when one of them appears in no conformance case.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/source.h"

namespace plugc {

enum class Severity : std::uint8_t { note, warning, error };

enum class DiagnosticId : std::uint16_t {
#define PLUGC_DIAGNOSTIC(id, code, severity, meaning) id,
#include "base/diagnostic_kinds.def"
#undef PLUGC_DIAGNOSTIC
  count
};

/// What the registry knows of a kind.
struct DiagnosticKind {
  std::string_view code;  ///< Stable, e.g. `effect-unknown-plug`.
  Severity severity;
  std::string_view meaning;  ///< One sentence for docs and SARIF.
};
const DiagnosticKind& diagnostic_kind(DiagnosticId id);

/// A second place that a diagnostic speaks of ("first defined here").
struct RelatedPlace {
  Span span;
  std::string message;
};

struct Diagnostic {
  DiagnosticId id = DiagnosticId::count;
  Span span;            ///< The author's place; not valid when the whole input is meant.
  std::string message;  ///< Lower case, no full stop, code in backticks.
  std::vector<RelatedPlace> related;
};

/// Collects what is said, in order, each different thing once (an effect used by a thousand shapes is one mistake), up to
/// kMaxDiagnostics of them.
class Diagnostics {
 public:
  explicit Diagnostics(const SourceSet& sources) : sources_(&sources) {}

  void report(DiagnosticId id, const Span& span, std::string message, std::vector<RelatedPlace> related = {});

  /// Reports what others say, whose sources are this one's own from `first_source` on (SourceSet::append).
  void append(const Diagnostics& other, std::uint32_t first_source);

  std::span<const Diagnostic> all() const { return diagnostics_; }
  const SourceSet& sources() const { return *sources_; }
  std::size_t count(Severity severity) const;
  bool has_errors() const { return count(Severity::error) != 0; }

 private:
  const SourceSet* sources_;
  std::vector<Diagnostic> diagnostics_;
  std::unordered_multimap<std::size_t, std::size_t> by_hash_;  // indices of diagnostics_
};

/// `file:line:column: error: message [code]`, the line itself and a caret under the span, then the related places.
std::string to_text(const Diagnostic& diagnostic, const SourceSet& sources);
std::string_view to_text(Severity severity);

/// The candidate nearest to `name` by edit distance, or "" when none is near enough to be meant.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);
/// "; did you mean `x`?" or "".
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace plugc

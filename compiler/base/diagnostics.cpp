// The sink keeps order and drops exact repeats, found by hash. The text form is the one compilers share, so that editors can
// jump to it: place, severity, message, code; then the line and a caret that spans what is meant.

#include "base/diagnostics.h"

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>

#include "base/check.h"
#include "base/limits.h"

namespace plugc {
namespace {

constexpr std::array kKinds = {
#define PLUGC_DIAGNOSTIC(id, code, severity, meaning) DiagnosticKind{code, Severity::severity, meaning},
#include "base/diagnostic_kinds.def"
#undef PLUGC_DIAGNOSTIC
};

constexpr std::size_t kMaxShownLine = 160;

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// The line with control characters (a tab, an escape sequence) as single spaces, and a caret line of equal columns.
std::string excerpt(const Span& span, const SourceSet& sources) {
  const std::string_view line = sources.line_at(span.source, span.begin);
  if (line.size() > kMaxShownLine) return "";
  const auto column = sources.position(span.source, span.begin).column;
  const auto line_begin = static_cast<std::uint32_t>(line.data() - sources.text(span.source).data());
  const std::uint32_t shown_end = std::min(span.end, line_begin + static_cast<std::uint32_t>(line.size()));
  std::uint32_t width = 0;
  for (std::uint32_t i = span.begin; i < shown_end; ++i) {
    if ((static_cast<unsigned char>(line[i - line_begin]) & 0xC0U) != 0x80U) ++width;
  }
  std::string shown(line.substr(line.starts_with("\xEF\xBB\xBF") ? 3 : 0));
  std::replace_if(shown.begin(), shown.end(), is_control, ' ');
  return fmt::format("  {}\n  {:>{}}{}\n", shown, "^", column, std::string(width > 1 ? width - 1 : 0, '~'));
}

std::string place(const Span& span, const SourceSet& sources) {
  if (!span.valid()) return "plugc";
  const Position at = sources.position(span.source, span.begin);
  return fmt::format("{}:{}:{}", sources.name(span.source), at.line, at.column);
}

std::size_t hash_of(DiagnosticId id, const Span& span, const std::string& message) {
  const auto place = std::hash<std::uint64_t>()((std::uint64_t{span.begin} << 32) | span.end);
  return std::hash<std::string>()(message) ^ (place * 31) ^ (static_cast<std::size_t>(id) << 17) ^ span.source.value;
}

char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Letters of either case count as equal: `BOX` is near `Box`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (lower_case(a[i - 1]) == lower_case(b[j - 1]) ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

const DiagnosticKind& diagnostic_kind(DiagnosticId id) {
  PLUGC_CHECK(id < DiagnosticId::count, "a registered diagnostic");
  return kKinds[static_cast<std::size_t>(id)];
}

void Diagnostics::report(DiagnosticId id, const Span& span, std::string message, std::vector<RelatedPlace> related) {
  if (diagnostics_.size() > kMaxDiagnostics) return;
  const std::size_t hash = hash_of(id, span, message);
  const auto [first, last] = by_hash_.equal_range(hash);
  const bool known = std::any_of(first, last, [&](const auto& entry) {
    const Diagnostic& said = diagnostics_[entry.second];
    return said.id == id && said.span == span && said.message == message;
  });
  if (known) return;
  if (diagnostics_.size() == kMaxDiagnostics) {
    diagnostics_.push_back({DiagnosticId::diagnostics_limit,
                            {},
                            fmt::format("more than {} things are wrong; no more of them are listed", kMaxDiagnostics),
                            {}});
    return;
  }
  by_hash_.emplace(hash, diagnostics_.size());
  diagnostics_.push_back({id, span, std::move(message), std::move(related)});
}

std::size_t Diagnostics::count(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& said) {
    return diagnostic_kind(said.id).severity == severity;
  }));
}

std::string_view to_text(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  return "";
}

std::string to_text(const Diagnostic& diagnostic, const SourceSet& sources) {
  const DiagnosticKind& kind = diagnostic_kind(diagnostic.id);
  std::string text =
      fmt::format("{}: {}: {} [{}]\n", place(diagnostic.span, sources), to_text(kind.severity), diagnostic.message, kind.code);
  if (diagnostic.span.valid()) text += excerpt(diagnostic.span, sources);
  for (const RelatedPlace& related : diagnostic.related) {
    text += fmt::format("{}: note: {}\n", place(related.span, sources), related.message);
    if (related.span.valid()) text += excerpt(related.span, sources);
  }
  return text;
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  constexpr std::size_t kLongestName = 64;
  if (name.size() > kLongestName) return "";
  std::string_view nearest;
  std::size_t best = std::min(std::max<std::size_t>(name.size() / 3, 1) + 1, name.size());  // something of it must stay
  for (const std::string_view candidate : candidates) {
    if (candidate == name || candidate.size() > kLongestName) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  const std::string_view nearest = nearest_name(name, candidates);
  return nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest);
}

}  // namespace plugc

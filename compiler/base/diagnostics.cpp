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

/// Whether a character goes on in this byte of UTF-8.
bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::size_t character_start(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && continues_character(text[at])) --at;
  return at;
}

std::uint32_t count_characters(std::string_view text) {
  return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

/// The part of a line that is shown: all of it, or of a very long one what stands around `at`.
struct Excerpt {
  std::size_t begin = 0, end = 0;
};
Excerpt shown_part(std::string_view line, std::size_t at) {
  constexpr std::size_t kBefore = 60;
  if (line.size() <= kMaxShownLine) return {line.starts_with("\xEF\xBB\xBF") ? std::size_t{3} : 0, line.size()};
  const std::size_t begin = character_start(line, at > kBefore ? at - kBefore : 0);
  return {begin, character_start(line, std::min(begin + kMaxShownLine, line.size()))};
}

/// The line with control characters (a tab, an escape sequence) as single spaces, and a caret line of equal columns.
std::string excerpt(const Span& span, const SourceSet& sources) {
  const std::string_view line = sources.line_at(span.source, span.begin);
  const std::size_t line_begin = static_cast<std::size_t>(line.data() - sources.text(span.source).data());
  const std::size_t at = std::min<std::size_t>(span.begin - line_begin, line.size());
  const auto [begin, end] = shown_part(line, at);
  const std::string_view before = begin > 3 ? "..." : "", behind = end < line.size() ? "..." : "";
  const std::size_t mark_end = std::clamp<std::size_t>(span.end - std::min<std::size_t>(span.end, line_begin), at, end);
  const std::uint32_t column = count_characters(line.substr(begin, at - std::min(begin, at)));
  const std::uint32_t width = std::max(count_characters(line.substr(at, mark_end - at)), 1U);
  std::string shown(line.substr(begin, end - begin));
  std::replace_if(shown.begin(), shown.end(), is_control, ' ');
  return fmt::format("  {}{}{}\n  {:{}}^{}\n", before, shown, behind, "", before.size() + column, std::string(width - 1, '~'));
}

/// One line, not too long, whatever the input made it quote: control characters could command a terminal.
void make_presentable(std::string& message) {
  if (message.size() > kMaxMessageBytes) {
    message.resize(character_start(message, kMaxMessageBytes));
    message += "...";
  }
  std::replace_if(message.begin(), message.end(), is_control, '?');
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
  make_presentable(message);
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

void Diagnostics::append(const Diagnostics& other, std::uint32_t first_source) {
  const auto moved = [first_source](Span span) {
    if (span.valid()) span.source.value += first_source;
    return span;
  };
  for (const Diagnostic& said : other.all()) {
    std::vector<RelatedPlace> related;
    for (const RelatedPlace& place : said.related) related.push_back({moved(place.span), place.message});
    report(said.id, moved(said.span), said.message, std::move(related));
  }
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
    if (candidate == name || candidate.size() > name.size() + best || name.size() > candidate.size() + best) continue;
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

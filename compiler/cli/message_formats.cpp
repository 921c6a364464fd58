// One walk over the diagnostics a format. JSON is made by the library, so that any text is escaped rightly.

#include "cli/message_formats.h"

#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace plugc {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void add_place(Json& json, const Span& span, const SourceSet& sources) {
  if (!span.valid()) return;
  const Position begin = sources.position(span.source, span.begin);
  const Position end = sources.position(span.source, span.end);
  json["file"] = sources.name(span.source);
  json["line"] = begin.line;
  json["column"] = begin.column;
  json["end_line"] = end.line;
  json["end_column"] = end.column;
}

std::string json_messages(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const DiagnosticKind& kind = diagnostic_kind(diagnostic.id);
    Json entry = {{"code", kind.code}, {"severity", to_text(kind.severity)}, {"message", diagnostic.message}};
    add_place(entry, diagnostic.span, diagnostics.sources());
    for (const RelatedPlace& related : diagnostic.related) {
      Json place = {{"message", related.message}};
      add_place(place, related.span, diagnostics.sources());
      entry["related"].push_back(std::move(place));
    }
    list.push_back(std::move(entry));
  }
  return dumped(list);
}

Json sarif_location(const Span& span, const SourceSet& sources) {
  const Position begin = sources.position(span.source, span.begin);
  const Position end = sources.position(span.source, span.end);
  return {{"physicalLocation",
           {{"artifactLocation", {{"uri", sources.name(span.source)}}},
            {"region",
             {{"startLine", begin.line}, {"startColumn", begin.column}, {"endLine", end.line}, {"endColumn", end.column}}}}}};
}

std::string sarif_messages(const Diagnostics& diagnostics) {
  Json results = Json::array();
  Json rules = Json::array();
  std::set<DiagnosticId> listed;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const DiagnosticKind& kind = diagnostic_kind(diagnostic.id);
    if (listed.insert(diagnostic.id).second) {
      rules.push_back({{"id", kind.code}, {"shortDescription", {{"text", kind.meaning}}}});
    }
    Json result = {{"ruleId", kind.code}, {"level", to_text(kind.severity)}, {"message", {{"text", diagnostic.message}}}};
    if (diagnostic.span.valid()) result["locations"] = Json::array({sarif_location(diagnostic.span, diagnostics.sources())});
    results.push_back(std::move(result));
  }
  const Json driver = {{"name", "plugc"}, {"version", PLUGC_VERSION}, {"rules", std::move(rules)}};
  return dumped({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({{{"tool", {{"driver", driver}}}, {"results", std::move(results)}}})}});
}

/// Percent, carriage return and newline as workflow commands want them.
std::string github_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '%')
      escaped += "%25";
    else if (c == '\r')
      escaped += "%0D";
    else if (c == '\n')
      escaped += "%0A";
    else
      escaped += c;
  }
  return escaped;
}

std::string github_messages(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const DiagnosticKind& kind = diagnostic_kind(diagnostic.id);
    const std::string_view level = kind.severity == Severity::note ? "notice" : to_text(kind.severity);
    std::string place;
    if (diagnostic.span.valid()) {
      const SourceSet& sources = diagnostics.sources();
      const Position at = sources.position(diagnostic.span.source, diagnostic.span.begin);
      place = fmt::format(" file={},line={},col={}", github_escaped(sources.name(diagnostic.span.source)), at.line, at.column);
    }
    text += fmt::format("::{}{}::{} [{}]\n", level, place, github_escaped(diagnostic.message), kind.code);
  }
  return text;
}

}  // namespace

std::string formatted_messages(const Diagnostics& diagnostics, std::string_view format) {
  if (format == "sarif") return sarif_messages(diagnostics);
  return format == "github" ? github_messages(diagnostics) : json_messages(diagnostics);
}

}  // namespace plugc

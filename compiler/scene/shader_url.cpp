// A url that starts with `data:` (RFC 2397) carries the code itself: everything behind the first comma. Plain code stays
// mapped to the scene file byte for byte. Percent-decoding applies only where the data holds no white space, because
// `i %20` in unencoded GLSL is a modulo, not a blank; encoded text maps to the place of the whole url.

#include "scene/shader_url.h"

#include <fmt/format.h>

#include "base/clean_text.h"
#include "base/data_url.h"

namespace plugc {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

MappedText decoded_text(std::string_view bytes, const Span& span) {
  MappedText text;
  text.append_generated(bytes, span);
  return text;
}

/// Code of a `data:` url; nullopt when it has no comma or broken base64.
std::optional<MappedText> data_url_code(const MappedText& url, const Span& span) {
  const std::string_view all = url.text();
  const std::size_t comma = all.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view data = all.substr(comma + 1);
  if (all.substr(0, comma).ends_with(";base64")) {
    const auto bytes = base64_decode(data);
    return bytes ? std::optional(decoded_text(*bytes, span)) : std::nullopt;
  }
  const bool encoded = data.find('%') != std::string_view::npos && data.find_first_of(kBlank) == std::string_view::npos;
  if (encoded) return decoded_text(percent_decode(data), span);
  MappedText code;
  code.append(url, static_cast<std::uint32_t>(comma + 1), url.size());
  return code;
}

}  // namespace

std::optional<ShaderCode> read_shader_code(const NodeGraph& graph, NodeId part, SourceSet& sources, FileAccess& files,
                                           Diagnostics& diagnostics) {
  const FieldValue& urls = graph.field(part, "url");
  Diagnostics failures(sources);
  for (const MappedText& url : urls.strings) {
    const Span span = url.locate(0, url.size());
    if (is_data_url(url.text())) {
      if (auto code = data_url_code(url, span)) return ShaderCode{std::move(*code), span};
      failures.report(DiagnosticId::effect_url, span,
                      "this `data:` url holds no readable code; write `data:text/plain,` and the code");
      continue;
    }
    if (auto bytes = read_url(files, url.text(), graph.base_path(part), span, failures)) {
      const auto path = resolve_url(url.text(), graph.base_path(part));
      const SourceId source =
          add_clean_text(sources, path ? path->string() : std::string(url.text()), std::move(*bytes), diagnostics);
      const Span whole{source, 0, static_cast<std::uint32_t>(sources.text(source).size())};
      return ShaderCode{MappedText(sources, whole), whole};
    }
  }
  const std::span<const MappedText> cdata = graph[part].cdata();
  if (!cdata.empty()) {
    MappedText code;  // XML may divide a text, at a `]]>` for one
    for (const MappedText& piece : cdata) code.append(piece);
    return ShaderCode{code, code.locate(0, code.size())};
  }
  for (const Diagnostic& failure : failures.all()) diagnostics.report(failure.id, failure.span, failure.message);
  if (failures.all().empty()) {
    diagnostics.report(DiagnosticId::effect_url, graph[part].type_span,
                       fmt::format("`{}` has no code: give it a `url`", graph[part].info->name));
  }
  return std::nullopt;
}

}  // namespace plugc

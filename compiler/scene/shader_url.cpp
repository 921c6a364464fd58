// A url that starts with `data:` (RFC 2397) carries the code itself: everything behind the first comma. Plain code stays
// mapped to the scene file byte for byte. Percent-decoding applies only where the data holds no white space, because
// `i %20` in unencoded GLSL is a modulo, not a blank; encoded text maps to the place of the whole url.

#include "scene/shader_url.h"

#include <fmt/format.h>

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

std::optional<ShaderCode> read_shader_code(const NodeGraph& graph, NodeId part, CodeFiles& files, Diagnostics& diagnostics) {
  const FieldValue& urls = graph.field(part, "url");
  Diagnostics failures(files.sources);
  for (const MappedText& url : urls.strings) {
    const Span span = url.locate(0, url.size());
    if (is_data_url(url.text())) {
      if (auto code = data_url_code(url, span)) return ShaderCode{std::move(*code), span};
      failures.report(DiagnosticId::effect_url, span,
                      "this `data:` url holds no readable code; write `data:text/plain,` and the code");
      continue;
    }
    if (const auto whole = read_code_file(files, graph, part, url, failures))
      return ShaderCode{MappedText(files.sources, *whole), *whole};
  }
  if (!graph[part].cdata().empty()) {
    MappedText code = joined_cdata(graph, part);
    const Span span = code.locate(0, code.size());
    return ShaderCode{std::move(code), span};
  }
  for (const Diagnostic& failure : failures.all()) diagnostics.report(failure.id, failure.span, failure.message);
  if (failures.all().empty()) {
    diagnostics.report(DiagnosticId::effect_url, graph[part].type_span,
                       fmt::format("`{}` has no code: give it a `url`", graph[part].info->name));
  }
  return std::nullopt;
}

}  // namespace plugc

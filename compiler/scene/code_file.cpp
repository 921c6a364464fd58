#include "scene/code_file.h"

#include "base/clean_text.h"

namespace plugc {

std::optional<Span> read_code_file(CodeFiles& from, const NodeGraph& graph, NodeId node, const MappedText& url,
                                   Diagnostics& failures) {
  const std::filesystem::path& base = graph.base_path(node);
  const auto path = resolve_url(url.text(), base);
  auto known = path ? from.known.find(*path) : from.known.end();
  if (known == from.known.end()) {
    auto bytes = read_url(from.files, url.text(), base, url.locate(0, url.size()), failures);
    if (!path || !bytes) return std::nullopt;
    known = from.known.emplace(*path, add_clean_text(from.sources, path->string(), std::move(*bytes), from.diagnostics)).first;
  }
  return Span{known->second, 0, static_cast<std::uint32_t>(from.sources.text(known->second).size())};
}

MappedText joined_cdata(const NodeGraph& graph, NodeId node) {
  MappedText all;
  for (const MappedText& piece : graph[node].cdata()) all.append(piece);
  return all;
}

}  // namespace plugc

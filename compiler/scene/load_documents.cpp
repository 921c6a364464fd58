// Files that a file includes. Each is read once, however often it is named; an Inline builds its nodes anew each time, in a
// scope of its own, and an EXTERNPROTO sees the file as a library: its prototypes, not its nodes.

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/read_document.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

bool is_gltf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".gltf" || extension == ".glb";
}

Span place_of(const MappedText& url, const Span& otherwise) {
  const Span span = url.empty() ? Span() : url.locate(0, url.size());
  return span.valid() ? span : otherwise;
}

/// `urn:web3d:x3d:node:Box` to "Box"; "" for any other url.
std::string_view urn_node(std::string_view url) {
  if (!url.starts_with("urn:")) return "";
  return url.substr(url.rfind(':') + 1);
}

}  // namespace

std::optional<std::uint32_t> GraphBuilder::load(std::string_view url, const std::filesystem::path& base, const Span& span,
                                                Diagnostics& diagnostics) {
  const auto path = resolve_url(url, base);
  if (path) {
    const auto known = loaded_.find(path->string());
    if (known != loaded_.end()) return known->second;
    if (is_gltf(*path)) {
      diagnostics.report(DiagnosticId::encoding_unknown, span,
                         fmt::format("`{}` is a glTF model; plugc reads X3D and VRML 2.0", url));
      return std::nullopt;
    }
  }
  std::optional<std::string> bytes = read_url(files_, url, base, span, diagnostics);
  if (!bytes) return std::nullopt;
  const SourceId source = sources_.add(path->generic_string(), std::move(*bytes));
  const auto index = static_cast<std::uint32_t>(graph_.documents_.size());
  graph_.documents_.push_back(read_document(source, sources_, diagnostics_));
  graph_.document_paths_.push_back(*path);
  loaded_[path->string()] = index;
  return index;
}

/// The first url that can be read counts; when there is none, what was wrong with each is reported.
std::optional<std::uint32_t> GraphBuilder::load_first(const FieldValue& urls, const std::filesystem::path& base) {
  Diagnostics failures(sources_);
  for (const MappedText& url : urls.strings) {
    const auto loaded = load(url.text(), base, place_of(url, urls.span), failures);
    if (loaded) return loaded;
  }
  for (const Diagnostic& failure : failures.all()) report(failure.id, failure.span, failure.message);
  return std::nullopt;
}

void GraphBuilder::run_inlined(const Job& job) {
  const FieldValue urls = graph_.field(job.built, "url");
  if (!graph_.boolean(job.built, "load")) return;
  const std::filesystem::path base = graph_.base_path(job.built);
  const auto loaded = load_first(urls, base);
  if (!loaded || !may_inline(job, *loaded, urls.span)) return;
  Scope& scope = scopes_.emplace_back();
  scope.document = *loaded;
  scope.outer = job.scope;
  scope.inline_depth = job.scope->inline_depth + 1;
  scope.proto_depth = job.scope->proto_depth;
  scope.repeats = true;
  if (job.definition != nullptr) job.definition->inlined = &scope;
  const FieldInfo& children = *find_field_info(*graph_.nodes_[job.built.value].info, "children");
  const std::size_t index = write_field(job.built, children, urls.span);
  graph_.nodes_[job.built.value].fields[index].value.type = children.type;
  Job model;
  model.scope = &scope;
  model.depth = job.depth + 1;
  model.to.holder = job.built;
  model.to.list = new_list(job.built, index, false);
  push_statements(document(scope).of(document(scope).statements), model);
}

bool GraphBuilder::may_inline(const Job& job, std::uint32_t included, const Span& span) {
  for (const Scope* at = job.scope; at != nullptr; at = at->outer) {
    if (at->instance != nullptr || at->document != included) continue;
    report(DiagnosticId::inline_cycle, span,
           fmt::format("`{}` includes itself", graph_.document_paths_[included].generic_string()));
    return false;
  }
  if (job.scope->inline_depth < kMaxInlineDepth) return true;
  report(DiagnosticId::inline_cycle, span, fmt::format("files are inlined more than {} deep", kMaxInlineDepth));
  return false;
}

/// X3D 4.1 part 1, 4.4.6: IMPORT gives a name to a node that an inlined file EXPORTs.
void GraphBuilder::export_or_import(Scope& scope, const ImportSyntax& statement) {
  const std::string_view alias = statement.alias.empty() ? statement.name.text : statement.alias.text;
  if (statement.inline_def.empty()) {
    scope.exports[alias] = statement.name.text;
    return;
  }
  const auto holder = scope.definitions.find(statement.inline_def.text);
  if (holder == scope.definitions.end()) {
    return report(DiagnosticId::use_unknown, statement.inline_def.span,
                  fmt::format("no `DEF {}` stands before this `IMPORT`", statement.inline_def.text));
  }
  const Scope* inlined = holder->second->inlined;
  if (inlined == nullptr) return;  // not loaded, which was reported
  const auto exported = inlined->exports.find(statement.name.text);
  const auto found =
      exported == inlined->exports.end() ? inlined->definitions.end() : inlined->definitions.find(exported->second);
  if (found == inlined->definitions.end()) {
    return report(DiagnosticId::use_unknown, statement.name.span,
                  fmt::format("the file that `{}` inlines exports no `{}`", statement.inline_def.text, statement.name.text));
  }
  scope.definitions[alias] = found->second;
}

/// Follows external prototypes that name external prototypes. Null when the end is missing, which is reported.
Prototype* GraphBuilder::resolve_external(Prototype& prototype) {
  Prototype* at = &prototype;
  for (std::uint32_t i = 0; i < kMaxInlineDepth && at != nullptr; ++i) {
    if (!at->external || at->built_in != nullptr) return at;
    if (!at->resolved) look_up_external(*at);
    if (at->built_in == nullptr) at = at->target;
  }
  const Name& name = prototype.syntax->name;
  report(DiagnosticId::externproto_missing, name.span,
         fmt::format("external prototype `{}` is found at none of its urls", name.text));
  return nullptr;
}

void GraphBuilder::look_up_external(Prototype& prototype) {
  prototype.resolved = true;
  const std::filesystem::path base = graph_.document_paths_[prototype.document];
  const std::span<const MappedText> urls = graph_.documents_[prototype.document].of(prototype.syntax->urls);
  Diagnostics failures(sources_);
  for (const MappedText& url : urls) {
    const std::string_view text = url.text();
    prototype.built_in = find_node_info(urn_node(text));
    if (prototype.built_in != nullptr) return;
    const std::size_t hash = text.find('#');
    const auto loaded = load(text.substr(0, hash), base, place_of(url, prototype.syntax->span), failures);
    if (!loaded) continue;
    const Scope& names = library(*loaded);
    const std::string_view wanted = hash == std::string_view::npos ? prototype.syntax->name.text : text.substr(hash + 1);
    const auto found = names.prototypes.find(wanted);
    prototype.target = found == names.prototypes.end() ? nullptr : found->second.back();
    if (prototype.target == nullptr && hash == std::string_view::npos) prototype.target = names.first_prototype;
    if (prototype.target != nullptr) return;
  }
  prototype.built_in = find_node_info(prototype.syntax->name.text);  // a node that other browsers know from a file
}

/// The prototypes of a file.
Scope& GraphBuilder::library(std::uint32_t index) {
  Scope*& known = libraries_[index];
  if (known != nullptr) return *known;
  known = &scopes_.emplace_back();
  known->document = index;
  known->repeats = true;
  const Document& text = graph_.documents_[index];
  for (const StatementSyntax& statement : text.of(text.statements)) {
    const bool external = statement.kind == StatementKind::externproto;
    if (!external && statement.kind != StatementKind::proto) continue;
    declare_prototype(*known, statement.index, external);
    if (known->first_prototype == nullptr && !prototypes_.empty()) known->first_prototype = &prototypes_.back();
  }
  return *known;
}

}  // namespace plugc

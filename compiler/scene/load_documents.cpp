// Files that a file includes. Each is read once, however often it is named; an Inline builds its nodes anew each time, in a
// scope of its own, and an EXTERNPROTO sees the file as a library: its prototypes, not its nodes.

#include <algorithm>

#include <fmt/format.h>

#include "base/clean_text.h"
#include "base/limits.h"
#include "document/read_document.h"
#include "document/read_gltf.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

/// What an inlined file costs beside its nodes, in nodes: it has name spaces of its own.
constexpr std::size_t kInlineWork = 16;

template <typename Map>
std::vector<std::string_view> sorted_names(const Map& map) {
  std::vector<std::string_view> names;
  for (const auto& [name, what] : map) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
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
  }
  std::optional<std::string> bytes = read_url(files_, url, base, span, diagnostics);
  if (!bytes) return std::nullopt;
  const SourceId source = add_clean_text(sources_, path->generic_string(), std::move(*bytes), diagnostics_);
  const std::uint32_t index = add_document(read_document(source, *path, files_, sources_, diagnostics_), *path);
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
  if (!loaded || !may_inline(job, *loaded, urls.span) || !spend(kInlineWork, urls.span)) return;
  Scope& scope = scopes_.emplace_back();
  scope.document = *loaded;
  scope.outer = job.scope;
  scope.inline_depth = job.scope->inline_depth + 1;
  scope.proto_depth = job.scope->proto_depth;
  scope.repeats = true;
  if (job.definition != nullptr) job.definition->inlined = &scope;
  for (Instance* instance = job.stands_for; instance != nullptr; instance = instance->stands_for) {
    if (instance->definition != nullptr) instance->definition->inlined = &scope;
  }
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

/// X3D 4.1 part 1, 4.4.6: an EXPORT may stand before what it exports, so it is checked at the end.
void GraphBuilder::note_export(Scope& scope, const ImportSyntax& statement) {
  if (!spend(1, statement.span)) return;
  scope.exports[statement.alias.empty() ? statement.name.text : statement.alias.text] = statement.name.text;
  pending_exports_.push_back({&statement, &scope});
}

void GraphBuilder::check_export(const PendingExport& pending) {
  const Name& name = pending.syntax->name;
  if (pending.scope->definitions.contains(name.text) || is_reported(DiagnosticId::import_invalid, name.span)) return;
  report(DiagnosticId::import_invalid, name.span,
         fmt::format("no node of this file is named `{}`{}", name.text, unknown_name_hint(*pending.scope, name)));
}

/// IMPORT gives a name to a node that an inlined file EXPORTs.
void GraphBuilder::import(Scope& scope, const ImportSyntax& statement) {
  if (!spend(1, statement.span)) return;
  const Name& alias = statement.alias.empty() ? statement.name : statement.alias;
  Definition* found = find_import(scope, statement);
  if (found == nullptr) return lose_name(scope, alias.text);
  scope.definitions[alias.text] = found;
}

/// What is imported, or null: the Inline is missing or is none (reported), its file was not loaded (reported where that is a
/// mistake), or that exports no such name (reported).
Definition* GraphBuilder::find_import(Scope& scope, const ImportSyntax& statement) {
  const Name& holder_name = statement.inline_def;
  const auto holder = scope.definitions.find(holder_name.text);
  if (holder == scope.definitions.end()) {
    report(DiagnosticId::import_invalid, holder_name.span,
           fmt::format("no `DEF {}` stands before this `IMPORT`{}", holder_name.text, unknown_name_hint(scope, holder_name)));
    return nullptr;
  }
  const Definition& definition = *holder->second;
  const Scope* inlined = definition.inlined;
  if (inlined == nullptr) {
    if (!definition.node.valid() || graph_.is(definition.node, "Inline")) return nullptr;
    report(DiagnosticId::import_invalid, holder_name.span,
           fmt::format("`{}` is a `{}`; names are imported from an `Inline`", holder_name.text,
                       graph_.nodes_[definition.node.value].info->name));
    return nullptr;
  }
  const Name& name = statement.name;
  const auto exported = inlined->exports.find(name.text);
  if (exported == inlined->exports.end()) {
    const auto names = [&] { return sorted_names(inlined->exports); };
    const bool is_there = inlined->definitions.contains(name.text);
    const std::string hint = is_there ? fmt::format("; it needs an `EXPORT {}`", name.text) : suggest(name.text, names);
    report(DiagnosticId::import_invalid, name.span,
           fmt::format("the file that `{}` inlines exports no `{}`{}", holder_name.text, name.text, hint));
    return nullptr;
  }
  const auto found = inlined->definitions.find(exported->second);
  return found == inlined->definitions.end() ? nullptr : found->second;  // reported at the EXPORT
}

/// Follows external prototypes that name external prototypes. Null when the end is missing, which is reported.
Prototype* GraphBuilder::resolve_external(Prototype& prototype) {
  Prototype* at = &prototype;
  for (std::uint32_t i = 0; i < kMaxInlineDepth; ++i) {
    if (!at->external || at->built_in != nullptr) return at;
    if (!at->resolved) look_up_external(*at);
    if (at->built_in != nullptr) return at;
    if (at->target == nullptr) return nullptr;
    at = at->target;
  }
  const Name& name = prototype.syntax->name;
  report(DiagnosticId::externproto_missing, name.span,
         fmt::format("external prototype `{}` leads from file to file, more than {} times or in a circle", name.text,
                     kMaxInlineDepth));
  return nullptr;
}

/// The first url that leads to a prototype counts; when there is none, what was wrong with each is reported. A node that
/// other browsers know from a file is then the built-in one.
void GraphBuilder::look_up_external(Prototype& prototype) {
  prototype.resolved = true;
  const Name& name = prototype.syntax->name;
  Diagnostics failures(sources_);
  const std::span<const MappedText> urls = graph_.documents_[prototype.document].of(prototype.syntax->urls);
  for (const MappedText& url : urls) {
    prototype.built_in = find_node_info(urn_node(url.text()));
    if (prototype.built_in == nullptr) prototype.target = find_external(prototype, url, failures);
    if (prototype.built_in != nullptr || prototype.target != nullptr) break;
  }
  if (prototype.target != nullptr) return check_declaration(prototype, *prototype.target);
  if (prototype.built_in == nullptr) prototype.built_in = find_node_info(name.text);
  if (prototype.built_in != nullptr) return;
  for (const Diagnostic& failure : failures.all()) report(failure.id, failure.span, failure.message);
  if (urls.empty()) {
    report(DiagnosticId::externproto_missing, name.span, fmt::format("external prototype `{}` names no url", name.text));
  }
}

/// ISO/IEC 14772-1, 4.9.3: `#Name` names the prototype; without it the first PROTO of the file is meant. `#Name` alone is one
/// of the same file (RFC 3986, 4.4).
Prototype* GraphBuilder::find_external(const Prototype& prototype, const MappedText& url, Diagnostics& failures) {
  const Span span = place_of(url, prototype.syntax->span);
  const std::string_view text = url.text();
  if (!urn_node(text).empty()) {
    failures.report(DiagnosticId::externproto_missing, span, fmt::format("plugc knows no node called `{}`", text));
    return nullptr;
  }
  const std::size_t hash = std::min(text.find('#'), text.size());
  const bool same_file = hash == 0 && !text.empty();
  const auto loaded = same_file ? std::optional(prototype.document)
                                : load(text.substr(0, hash), graph_.document_paths_[prototype.document], span, failures);
  if (!loaded) return nullptr;
  const Scope& names = library(*loaded);
  if (hash == text.size()) {
    if (names.first_prototype == nullptr) {
      failures.report(DiagnosticId::externproto_missing, span, fmt::format("`{}` declares no prototype", text));
    }
    return names.first_prototype;
  }
  const std::string_view wanted = text.substr(hash + 1);
  if (const auto found = names.prototypes.find(wanted); found != names.prototypes.end()) return found->second.back();
  const auto declared = [&] { return sorted_names(names.prototypes); };
  failures.report(
      DiagnosticId::externproto_missing, span,
      fmt::format("{} declares no prototype `{}`{}", same_file ? "this file" : fmt::format("`{}`", text.substr(0, hash)),
                  wanted, suggest(wanted, declared)));
  return nullptr;
}

/// X3D 4.1 part 1, 4.4.5.2: what an EXTERNPROTO declares is a part of what the prototype does.
void GraphBuilder::check_declaration(const Prototype& external, const Prototype& target) {
  const auto actual = graph_.documents_[target.document].of(target.syntax->interface);
  std::vector<std::string_view> names;
  std::unordered_map<std::string_view, const InterfaceSyntax*> by_name;
  for (const InterfaceSyntax& one : actual) {
    names.push_back(one.name.text);
    by_name.emplace(one.name.text, &one);
  }
  for (const InterfaceSyntax& promised : graph_.documents_[external.document].of(external.syntax->interface)) {
    const Name& name = promised.name;
    const auto found = by_name.find(name.text);
    if (found == by_name.end()) {
      report(DiagnosticId::field_unknown, name.span,
             fmt::format("the prototype `{}` that this declares has no field `{}`{}", target.syntax->name.text, name.text,
                         suggest(name.text, [&] { return names; })));
      continue;
    }
    const InterfaceSyntax& field = *found->second;
    if (field.type.text != promised.type.text) {
      report(DiagnosticId::field_type, promised.type.span,
             fmt::format("`{}` is of type {} in the prototype `{}` that this declares", name.text, field.type.text,
                         target.syntax->name.text));
    } else if (field.access != promised.access) {
      report(DiagnosticId::access_type, promised.span,
             fmt::format("`{}` is {} in the prototype `{}` that this declares", name.text, to_text(field.access),
                         target.syntax->name.text));
    }
  }
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
    if (known->first_prototype == nullptr && !external) known->first_prototype = &prototypes_.back();
  }
  return *known;
}

}  // namespace plugc

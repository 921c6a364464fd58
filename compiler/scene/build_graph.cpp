// The walk itself. Jobs lie on a stack, the next one on top; a job that has children pushes its own end first and then the
// children, last one first, so that everything happens in the order of the text:
//
//     Group { children [ A { } B { } ] }     ->  create Group | A, finish A | B, finish B | finish Group
//
// When the stack is empty every node exists and every list of nodes is complete; then routes are resolved and the fields
// get their views of the lists.

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/check_head.h"
#include "scene/graph_builder.h"

namespace plugc {

NodeGraph GraphBuilder::build(Document document, const std::filesystem::path& path, std::optional<Document> appended) {
  NodeList& roots = graph_.node_lists_.emplace_back();
  loaded_[path.lexically_normal().string()] = 0;
  build_roots(add_document(std::move(document), path), roots);
  if (appended) build_roots(add_document(std::move(*appended), path), roots);
  for (const PendingExport& one : pending_exports_) check_export(one);
  for (const PendingRoute& route : pending_routes_) resolve_route(route);
  finish_graph(roots);
  return std::move(graph_);
}

std::uint32_t GraphBuilder::add_document(Document document, const std::filesystem::path& path) {
  check_head(document.head, diagnostics_);
  graph_.documents_.push_back(std::move(document));
  graph_.document_paths_.push_back(path);
  return static_cast<std::uint32_t>(graph_.documents_.size() - 1);
}

void GraphBuilder::build_roots(std::uint32_t index, NodeList& roots) {
  Scope& scope = scopes_.emplace_back();
  scope.document = index;
  Job model;
  model.scope = &scope;
  model.to.list = &roots;
  push_statements(document(scope).of(document(scope).statements), model);
  run_jobs();
  expand_unused(scope);
}

void GraphBuilder::run_jobs() {
  while (!jobs_.empty() && !out_of_work_) {
    Job job = jobs_.back();
    if (job.following == 0) {
      jobs_.pop_back();
    } else {
      Job& rest = jobs_.back();
      --rest.following;
      if (rest.kind == JobKind::node) ++rest.node;
      if (rest.kind == JobKind::statement) ++rest.statement;
    }
    run(job);
  }
  jobs_.clear();
}

void GraphBuilder::run(const Job& job) {
  switch (job.kind) {
    case JobKind::node: build_node(job); break;
    case JobKind::statement: run_statement(job); break;
    case JobKind::body: run_body(job); break;
    case JobKind::inlined: run_inlined(job); break;
    case JobKind::finish: finish_node(job); break;
  }
}

void GraphBuilder::push_statements(std::span<const StatementSyntax> statements, Job model) {
  if (statements.empty()) return;
  model.kind = JobKind::statement;
  model.statement = statements.data();
  model.following = static_cast<std::uint32_t>(statements.size() - 1);
  jobs_.push_back(model);
}

void GraphBuilder::run_statement(const Job& job) {
  const Document& text = document(*job.scope);
  const std::uint32_t index = job.statement->index;
  switch (job.statement->kind) {
    case StatementKind::node: {
      Job node = job;
      node.kind = JobKind::node;
      node.node = &text.nodes[index];
      build_node(node);
      break;
    }
    case StatementKind::route: note_route(*job.scope, text.routes[index]); break;
    case StatementKind::proto: declare_prototype(*job.scope, index, false); break;
    case StatementKind::externproto: declare_prototype(*job.scope, index, true); break;
    case StatementKind::import: import(*job.scope, text.imports[index]); break;
    case StatementKind::export_: note_export(*job.scope, text.imports[index]); break;
  }
}

void GraphBuilder::build_node(const Job& written) {
  Job job = written;
  if (job.stands_for == nullptr) job.to.written = job.node;
  const Name& type = job.node->type;
  if (!job.node->extras->use.empty()) return place_use(job);
  const Encoding encoding = document(*job.scope).encoding;
  const bool names_node = (encoding == Encoding::xml || encoding == Encoding::json) && !job.node->is_instance;
  const NodeInfo* info = job.node->is_instance ? nullptr : find_node_info(type.text);
  if (names_node && info != nullptr) return create_node(job, *info);
  if (Prototype* prototype = find_prototype(*job.scope, type.text)) {
    if (names_node) report_element_of_a_prototype(type);
    return instantiate(job, *prototype);
  }
  if (info != nullptr) return create_node(job, *info);
  report_unknown_node(job);
  lose(*job.scope, *job.node);
}

void GraphBuilder::create_node(const Job& job, const NodeInfo& info) {
  const NodeSyntax& syntax = *job.node;
  if (!spend(1 + syntax.fields.count + syntax.extras->interface.count, syntax.type.span)) return;
  if (job.depth > kMaxSceneDepth) {
    lose(*job.scope, syntax);
    return report(DiagnosticId::nesting_limit, syntax.type.span,
                  fmt::format("more than {} nodes inside one another", kMaxSceneDepth));
  }
  const NodeId id{static_cast<std::uint32_t>(graph_.nodes_.size())};
  GraphNode& node = graph_.nodes_.emplace_back();
  heights_.push_back(0);
  node.info = &info;
  node.def = syntax.extras->def.text;
  for (const Instance* instance = job.stands_for; instance != nullptr; instance = instance->stands_for) {
    if (!instance->def.empty()) node.def = instance->def;  // the name by which the outermost scope knows the node
  }
  node.span = syntax.span;
  node.type_span = syntax.type.span;
  node.document = job.scope->document;
  node.fields.reserve(std::min<std::size_t>(syntax.fields.count, info.fields.size()));
  if (!syntax.extras->interface.empty() || !syntax.extras->cdata.empty()) {
    node.own = std::make_unique<OwnDeclarations>();
    node.own->cdata = document(*job.scope).of(syntax.extras->cdata);
  }
  Definition* definition = define(*job.scope, syntax.extras->def);
  if (definition != nullptr) definition->node = id;
  place(job, id);

  Job finish = job;
  finish.kind = JobKind::finish;
  finish.following = 0;
  finish.built = id;
  finish.definition = definition;
  jobs_.push_back(finish);
  const auto first_child = static_cast<std::ptrdiff_t>(jobs_.size());
  build_fields(job, id);
  if (is_a(info, "Inline")) {
    finish.kind = JobKind::inlined;
    jobs_.push_back(finish);
  }
  std::reverse(jobs_.begin() + first_child, jobs_.end());
}

void GraphBuilder::finish_node(const Job& job) {
  if (job.definition != nullptr) job.definition->open = false;
  if (!job.built.valid()) return;
  raise_height(job.to.holder, job.built);
  container_lists_.erase(container_lists_.lower_bound({job.built.value, nullptr}),
                         container_lists_.lower_bound({job.built.value + 1, nullptr}));
}

/// Lists no longer grow, so the fields may now view them.
void GraphBuilder::finish_graph(const NodeList& roots) {
  for (const ListUse& use : list_uses_) {
    GraphNode& node = graph_.nodes_[use.node.value];
    FieldValue& value = use.interface ? node.own->interface[use.index].value : node.fields[use.index].value;
    value.nodes = use.list->ids();
  }
  graph_.roots_.assign(roots.ids().begin(), roots.ids().end());
}

Definition* GraphBuilder::define(Scope& scope, const Name& name) {
  if (name.empty()) return nullptr;
  Definition& definition = definitions_.emplace_back();
  Definition*& known = scope.definitions[name.text];
  const bool may_repeat = document(scope).encoding == Encoding::vrml2;  // ISO/IEC 14772-1, 4.6.2
  if (known != nullptr && !may_repeat) {
    report(DiagnosticId::name_repeated, name.span,
           fmt::format("`DEF {}` stands here for the second time; a `USE` means the nearest one before it", name.text));
  }
  known = &definition;
  return known;
}

NodeGraph build_graph(Document document, const std::filesystem::path& path, SourceSet& sources, FileAccess& files,
                      Diagnostics& diagnostics, std::optional<Document> appended) {
  return GraphBuilder(sources, files, diagnostics).build(std::move(document), path, std::move(appended));
}

}  // namespace plugc

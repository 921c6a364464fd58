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
#include "scene/graph_builder.h"

namespace plugc {
namespace {

/// Nodes, fields, links and routes together: what expanding may cost when prototypes multiply anything but nodes.
constexpr std::size_t kMaxWork = std::size_t{6} * kMaxSceneNodes;

std::vector<std::string_view> node_names() {
  std::vector<std::string_view> names;
  for (const NodeInfo& info : node_table()) names.push_back(info.name);
  for (const std::string_view statement : {"ROUTE", "IMPORT", "EXPORT", "ProtoDeclare", "ProtoInstance"})
    names.push_back(statement);
  return names;
}

std::vector<std::string_view> field_type_names() {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(FieldType::unknown); ++i) {
    names.push_back(to_text(static_cast<FieldType>(i)));
  }
  return names;
}

}  // namespace

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

Scope& GraphBuilder::add_document(Document document, const std::filesystem::path& path) {
  Scope& scope = scopes_.emplace_back();
  scope.document = static_cast<std::uint32_t>(graph_.documents_.size());
  graph_.documents_.push_back(std::move(document));
  graph_.document_paths_.push_back(path);
  return scope;
}

void GraphBuilder::build_roots(Scope& scope, NodeList& roots) {
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

/// XML and JSON have one element for the instances of all prototypes.
void GraphBuilder::report_element_of_a_prototype(const Name& type) {
  report(DiagnosticId::node_unknown, type.span,
         fmt::format("`{}` is a prototype; its instance is a `ProtoInstance` with this `name`", type.text));
}

void GraphBuilder::report_unknown_node(const Job& job) {
  const Name& type = job.node->type;
  if (is_reported(DiagnosticId::node_unknown, type.span)) return;
  const auto known = [&] {
    std::vector<std::string_view> names;
    if (!job.node->is_instance) names = node_names();
    for (const Scope* at = job.scope; at != nullptr; at = at->declared_in) {
      for (const auto& [name, declared] : at->prototypes) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  };
  const std::string what = job.node->is_instance ? fmt::format("no prototype `{}` is declared before this instance", type.text)
                                                 : fmt::format("unknown node `{}`", type.text);
  report(DiagnosticId::node_unknown, type.span, what + suggest(type.text, known));
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

/// Of a node that is passed over the names are remembered, its own and those inside, so that no USE or ROUTE of them is told
/// as a further mistake.
void GraphBuilder::lose(Scope& scope, const NodeSyntax& node) {
  const Document& text = document(scope);
  std::vector<const NodeSyntax*> passed{&node};
  const auto pass_over = [&](const ValueSyntax& value) {
    if (value.kind != ValueKind::nodes) return;
    for (const NodeSyntax& inner : text.of(value.nodes())) passed.push_back(&inner);
  };
  while (!passed.empty()) {
    const NodeSyntax& one = *passed.back();
    passed.pop_back();
    if (!spend(1, one.span)) return;
    if (!one.extras->def.empty()) lose_name(scope, one.extras->def.text);
    for (const FieldSyntax& field : text.of(one.fields)) pass_over(field.value);
    for (const InterfaceSyntax& field : text.of(one.extras->interface)) pass_over(field.value);
  }
}

void GraphBuilder::lose_name(Scope& scope, std::string_view name) {
  Definition& definition = definitions_.emplace_back();
  definition.lost = true;
  scope.definitions[name] = &definition;
}

void GraphBuilder::report_unknown_type(const Name& type) {
  if (is_reported(DiagnosticId::field_type, type.span)) return;
  report(DiagnosticId::field_type, type.span,
         fmt::format("no field type is called `{}`{}", type.text, suggest(type.text, field_type_names)));
}

bool GraphBuilder::spend(std::size_t work, const Span& span) {
  work_ += work;
  if (out_of_work_) return false;
  if (work_ <= kMaxWork && graph_.nodes_.size() < kMaxSceneNodes) return true;
  out_of_work_ = true;
  report(DiagnosticId::scene_limit, span,
         fmt::format("the scene expands to more than {} nodes; what follows is left out", kMaxSceneNodes));
  return false;
}

void GraphBuilder::report(DiagnosticId id, const Span& span, const std::string& message) {
  const auto key =
      (std::uint64_t{static_cast<std::uint16_t>(id)} << 48) ^ (std::uint64_t{span.source.value} << 32) ^ span.begin;
  if (reported_.insert(key).second) diagnostics_.report(id, span, message);
}

bool GraphBuilder::is_reported(DiagnosticId id, const Span& span) const {
  return reported_.contains((std::uint64_t{static_cast<std::uint16_t>(id)} << 48) ^ (std::uint64_t{span.source.value} << 32) ^
                            span.begin);
}

bool GraphBuilder::may_look_through(std::size_t names) {
  looked_through_ += names;
  return ++suggestions_ <= kMaxSuggestions && looked_through_ <= kMaxLookedThrough;
}

std::string GraphBuilder::suggest(std::string_view name, const std::function<std::vector<std::string_view>()>& candidates) {
  if (!may_look_through(0)) return "";
  const std::vector<std::string_view> names = candidates();
  looked_through_ += names.size();
  return did_you_mean(name, names);
}

NodeGraph build_graph(Document document, const std::filesystem::path& path, SourceSet& sources, FileAccess& files,
                      Diagnostics& diagnostics, std::optional<Document> appended) {
  return GraphBuilder(sources, files, diagnostics).build(std::move(document), path, std::move(appended));
}

}  // namespace plugc

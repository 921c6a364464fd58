#pragma once
// The state of build_graph, shared by the files that it is divided into. Nothing else includes this header.
//
// Building walks the documents with an explicit stack of jobs instead of recursion, so that no nesting of nodes, prototypes
// and files can exhaust the call stack. Jobs are taken in the order of the text: a node's job creates it and leaves one job
// for each of its children, then one that finishes it. So a USE sees exactly the DEFs before it, and a node that is still
// open when its own name is USEd contains itself.

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "scene/event_names.h"
#include "scene/field_values.h"
#include "scene/node_graph.h"

namespace plugc {

/// Looking for a near name costs more than all else about a mistake, so only the first mistakes get one, and none of those in
/// a file of very many names.
constexpr std::size_t kMaxSuggestions = 200;
constexpr std::size_t kMaxLookedThrough = 500'000;

struct Scope;
struct Instance;

/// What a DEF name stands for.
struct Definition {
  NodeId node;                   // not valid while a prototype's instance has not reached its first node
  Instance* instance = nullptr;  // when the name was given to a prototype's instance
  Scope* inlined = nullptr;      // when it was given to an Inline: what that holds
  bool open = true;              // the node is not finished: USE now would be a cycle
  bool lost = false;             // what it names was passed over, which was reported: no more is said of it
};

/// A PROTO or EXTERNPROTO statement met in a scope.
struct Prototype {
  std::uint32_t document = 0;
  const ProtoSyntax* syntax = nullptr;
  Scope* scope = nullptr;   // where it was declared
  std::uint32_t order = 0;  // its place among that scope's prototypes: the body sees those before it
  bool external = false;
  bool used = false;
  bool resolved = false;                                            // external: looked up already
  Prototype* target = nullptr;                                      // external: what it names, or
  const NodeInfo* built_in = nullptr;                               // the built-in node that it names
  std::unordered_map<std::string_view, std::uint32_t> field_index;  // by name: the place of each field of its interface
};

/// One name space: a file each time it is read, or a prototype's body each time it is expanded.
struct Scope {
  std::uint32_t document = 0;
  Scope* outer = nullptr;                         // where the Inline or the instance stands
  Scope* declared_in = nullptr;                   // a body: the scope of the PROTO statement, for the names of prototypes
  std::uint32_t visible_prototypes = UINT32_MAX;  // a body: how many of declared_in's prototypes it sees
  Instance* instance = nullptr;                   // a body: whose
  std::uint32_t inline_depth = 0;
  std::uint32_t proto_depth = 0;
  bool repeats = false;  // its syntax may be built more than once
  std::unordered_map<std::string_view, Definition*> definitions;
  std::unordered_map<std::string_view, std::vector<Prototype*>> prototypes;
  std::unordered_map<std::string_view, std::string_view> exports;  // alias to DEF name
  std::uint32_t prototype_count = 0;
  Prototype* first_prototype = nullptr;  // a library: its first PROTO, which a url without `#name` means
};

/// Where an IS leads: a field of a node, or of an instance inside the body.
struct Link {
  NodeId node;
  Instance* instance = nullptr;
  std::string_view field;
};

/// One interface field of a prototype's instance.
struct ProtoField {
  const InterfaceSyntax* declared = nullptr;
  FieldType type = FieldType::unknown;
  bool is_given = false;  // by the instance
  bool has_value = false;
  FieldValue value;                  // numbers and strings
  std::uint32_t value_document = 0;  // the file that wrote the value, which its urls are relative to
  NodeList* nodes = nullptr;         // SFNode and MFNode
  std::vector<Link> links;
};

struct Instance {
  const Prototype* prototype = nullptr;
  const Prototype* external = nullptr;  // the declaration that led to it from another file
  Instance* stands_for = nullptr;       // the instance whose first node this one is
  std::string_view def;
  Definition* definition = nullptr;
  NodeId first;
  Scope* body = nullptr;
  std::vector<ProtoField> fields;
};

ProtoField* find_proto_field(Instance& instance, std::string_view name);

/// Where a built node goes. By field: into `list`, checked against `field`. By container (XML): into the field of `holder`
/// that the node's type leads to. Without either: nowhere.
struct Destination {
  NodeId holder;
  NodeList* list = nullptr;
  const FieldInfo* field = nullptr;
  bool single = false;  // the list takes one node
  bool by_container = false;
  const NodeSyntax* written = nullptr;  // the node statement at this place (an instance's, not its body's)
};

enum class JobKind : std::uint8_t { node, statement, body, inlined, finish };

/// One step of the walk. A list of siblings is one job that leaves itself for those that follow.
struct Job {
  JobKind kind = JobKind::node;
  const NodeSyntax* node = nullptr;
  const StatementSyntax* statement = nullptr;
  std::uint32_t following = 0;  // nodes or statements behind this one
  Scope* scope = nullptr;
  Destination to;
  Instance* stands_for = nullptr;    // the instance whose first node this is; for `body`, whose body
  Definition* definition = nullptr;  // finish: what is no longer open; inlined: what names the Inline
  NodeId built;                      // finish: which node is done; inlined: the Inline
  std::uint32_t depth = 0;
};

/// An EXPORT, which may stand before what it exports.
struct PendingExport {
  const ImportSyntax* syntax = nullptr;
  const Scope* scope = nullptr;
};

struct PendingRoute {
  const RouteSyntax* syntax = nullptr;
  Scope* scope = nullptr;
  Definition* from = nullptr;
  Definition* to = nullptr;
};

/// One end of a route.
struct RouteEnd {
  Link link;
  FieldType type = FieldType::unknown;
};

class GraphBuilder {
 public:
  GraphBuilder(SourceSet& sources, FileAccess& files, Diagnostics& diagnostics)
      : sources_(sources), files_(files), diagnostics_(diagnostics) {}
  NodeGraph build(Document document, const std::filesystem::path& path, std::optional<Document> appended);

 private:
  // build_graph.cpp: jobs and nodes
  std::uint32_t add_document(Document document, const std::filesystem::path& path);
  void build_roots(std::uint32_t index, NodeList& roots);
  void run_jobs();
  void run(const Job& job);
  void push_statements(std::span<const StatementSyntax> statements, Job model);
  void run_statement(const Job& job);
  void build_node(const Job& job);
  void create_node(const Job& job, const NodeInfo& info);
  void finish_node(const Job& job);
  void finish_graph(const NodeList& roots);
  Definition* define(Scope& scope, const Name& name);
  const Document& document(const Scope& scope) const { return graph_.documents_[scope.document]; }

  // build_fields.cpp: what stands in a node
  void build_fields(const Job& job, NodeId id);
  void build_field(const Job& job, NodeId id, const FieldSyntax& field);
  void build_node_field(const Job& job, NodeId id, const FieldInfo& info, const FieldSyntax& field);
  void build_interface(const Job& job, NodeId id);
  bool declare_once(std::unordered_set<std::string_view>& names, const InterfaceSyntax& declared);
  void build_interface_value(const Job& job, NodeId id, std::size_t index, const InterfaceSyntax& declared);
  void connect_field(const Job& job, NodeId id, const FieldInfo& info, const FieldSyntax& field);
  const FieldInfo* find_field(const Scope& scope, const NodeInfo& node, const FieldSyntax& field);
  void check_connected(const FieldValue& value, const ValueContract& contract);
  void connect_interface(const Job& job, NodeId id, std::size_t index, const InterfaceSyntax& declared);
  bool read_plain(const Scope& scope, const ValueSyntax& syntax, const ValueContract& contract, FieldValue& value);
  bool holds_nodes(const Scope& scope, const ValueSyntax& value, const ValueContract& contract);
  void push_nodes(const Job& job, const ValueSyntax& value, const Destination& to, Scope& scope);
  std::size_t write_field(NodeId id, const FieldInfo& info, const Span& name_span);
  NodeList* new_list(NodeId id, std::size_t index, bool interface);
  void report_unknown_field(const NodeInfo& info, const Name& name);
  void report_renamed(const NodeInfo& node, const Name& name, const FieldInfo& field);

  // place_nodes.cpp: where a node goes
  void place(const Job& job, NodeId id);
  bool choose_container(Destination& to, NodeId id);
  void place_use(const Job& job);
  void check_use(const Job& job, const Definition& definition);
  NodeList* share(const Job& job, NodeId holder, const FieldInfo* info, const ProtoField& source);
  void check_accepted(const FieldInfo& field, NodeId holder, NodeId id, const Span& span);
  bool fits_depth(std::uint32_t depth, NodeId id, const Span& span);
  void raise_height(NodeId holder, NodeId child);

  // expand_prototypes.cpp
  void declare_prototype(Scope& scope, std::uint32_t index, bool external);
  Prototype* find_prototype(const Scope& scope, std::string_view name) const;
  void expand_unused(Scope& scope);
  void instantiate(const Job& job, Prototype& prototype);
  void expand(const Job& job, Prototype& prototype, const Prototype* external);
  bool may_expand(const Job& job, const Prototype& prototype);
  Instance& new_instance(const Job& job, const Prototype& prototype, const Prototype* external);
  void declare_fields(Instance& instance);
  void run_body(const Job& job);

  // instance_fields.cpp
  bool declares(const Prototype& prototype, std::string_view field) const;
  ProtoField* find_given(const Job& job, Instance& instance, const FieldSyntax& written);
  void set_field(const Job& job, Instance& instance, const FieldSyntax& written);
  void give_value(const Job& job, Instance& instance, ProtoField& field, const ValueSyntax& value, Scope& scope);
  ProtoField* container_of(Instance& instance, const FieldSyntax& child, const Document& document);
  ProtoField* follow_is(const Scope& scope, const ValueSyntax& is, FieldType type, AccessType access, const Link& link);

  // load_documents.cpp
  std::optional<std::uint32_t> load(std::string_view url, const std::filesystem::path& base, const Span& span,
                                    Diagnostics& diagnostics);
  std::optional<std::uint32_t> load_first(const FieldValue& urls, const std::filesystem::path& base);
  void run_inlined(const Job& job);
  bool may_inline(const Job& job, std::uint32_t document, const Span& span);
  void note_export(Scope& scope, const ImportSyntax& statement);
  void check_export(const PendingExport& pending);
  void import(Scope& scope, const ImportSyntax& statement);
  Definition* find_import(Scope& scope, const ImportSyntax& statement);
  Prototype* resolve_external(Prototype& prototype);
  void look_up_external(Prototype& prototype);
  Prototype* find_external(const Prototype& prototype, const MappedText& url, Diagnostics& failures);
  void check_declaration(const Prototype& external, const Prototype& target);
  Scope& library(std::uint32_t document);

  // resolve_routes.cpp
  void note_route(Scope& scope, const RouteSyntax& route);
  void resolve_route(const PendingRoute& pending);
  std::optional<RouteEnd> route_end(const PendingRoute& pending, bool outgoing);
  std::optional<RouteEnd> instance_end(Instance& instance, const Name& field, bool outgoing);
  std::optional<RouteEnd> node_end(NodeId id, const Name& field, bool outgoing);
  const InterfaceField* find_interface(NodeId id, std::string_view name);
  bool inner_field_allows(NodeId id, std::string_view name, EventUse use);
  void report_no_event(std::string_view type, const Name& field, bool outgoing,
                       const std::function<std::vector<std::string_view>()>& names);
  void follow_links(const Link& from, bool outgoing, std::vector<Link>& ends, const Span& span);

  // graph_reports.cpp: what is told, and what is passed over
  /// Once a place: a prototype's body is reported on once, however often it is expanded.
  void report(DiagnosticId id, const Span& span, const std::string& message);
  bool is_reported(DiagnosticId id, const Span& span) const;
  std::string unknown_name_hint(const Scope& scope, const Name& name);
  /// The names are gathered only where one may still be suggested.
  std::string suggest(std::string_view name, const std::function<std::vector<std::string_view>()>& candidates);
  std::string suggest_defined(const Scope& scope, std::string_view name);
  /// Whether one more name may be searched for among that many.
  bool may_look_through(std::size_t names);
  void report_unknown_node(const Job& job);
  void report_element_of_a_prototype(const Name& type);
  void report_unknown_type(const Name& type);
  void lose(Scope& scope, const NodeSyntax& node);
  void lose_nodes(Scope& scope, const ValueSyntax& value);
  void lose_name(Scope& scope, std::string_view name);
  bool spend(std::size_t work, const Span& span);

  SourceSet& sources_;
  FileAccess& files_;
  Diagnostics& diagnostics_;
  NodeGraph graph_;
  std::vector<Job> jobs_;
  std::deque<Scope> scopes_;
  std::deque<Instance> instances_;
  std::deque<Definition> definitions_;
  std::deque<Prototype> prototypes_;
  std::vector<PendingRoute> pending_routes_;
  std::vector<PendingExport> pending_exports_;
  std::set<std::tuple<NodeId, NodeId, std::string_view, std::string_view>> joined_;  // by routes
  std::vector<std::uint32_t> heights_;                                               // of each node: the longest path below it

  /// Fields that hold nodes, whose lists have their final place only at the end.
  struct ListUse {
    NodeId node;
    std::uint32_t index : 31;
    std::uint32_t interface : 1;
    NodeList* list;
  };
  std::vector<ListUse> list_uses_;
  std::map<std::pair<std::uint32_t, const FieldInfo*>, NodeList*> container_lists_;            // XML children of open nodes
  std::map<std::pair<const ValueSyntax*, FieldType>, std::optional<FieldValue>> read_values_;  // of scopes that repeat
  std::map<std::string, std::uint32_t> loaded_;                                                // document of each path
  std::map<std::uint32_t, Scope*> libraries_;  // of documents that an EXTERNPROTO names
  std::map<std::uint32_t, std::unordered_map<std::string_view, std::uint32_t>> interface_index_;  // of nodes that routes name
  std::unordered_set<std::uint64_t> reported_;
  NumberBudget number_budget_;
  std::size_t work_ = 0;
  std::size_t suggestions_ = 0;
  std::size_t looked_through_ = 0;  // names, by all of them
  bool out_of_work_ = false;
};

}  // namespace plugc

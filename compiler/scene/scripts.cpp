// Code stands behind `castlescript:` in a url or in CDATA, or in a file of its own. What a field holds becomes a variable of
// the code; which fields it listens at and sends from is known when it is compiled.

#include "scene/scripts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "base/script_limits.h"
#include "scene/event_names.h"

namespace plugc {
namespace {

// The second of each is the old name of the language.
constexpr std::array<std::string_view, 2> kProtocols = {"castlescript:", "kambiscript:"};
constexpr std::array<std::string_view, 3> kEndings = {".castlescript", ".kambiscript", ".kscript"};

/// The part of a url behind the language's name; nullopt where it names another language, or a file.
std::optional<MappedText> code_in_url(const MappedText& url) {
  const std::string_view text = url.text();
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  for (const std::string_view protocol : kProtocols) {
    if (!text.substr(begin).starts_with(protocol)) continue;
    MappedText code;
    code.append(url, static_cast<std::uint32_t>(begin + protocol.size()), url.size());
    return code;
  }
  return std::nullopt;
}

bool names_code_file(const MappedText& url) {
  return std::ranges::any_of(kEndings, [&](std::string_view ending) { return url.text().ends_with(ending); });
}

/// The first code that can be read. Files that cannot are reported where no other url serves.
std::optional<MappedText> find_code(const NodeGraph& graph, NodeId node, CodeFiles& files, Diagnostics& diagnostics) {
  Diagnostics failures(files.sources);
  for (const MappedText& url : graph.field(node, "url").strings) {
    if (auto code = code_in_url(url)) return code;
    if (!names_code_file(url)) continue;
    if (const auto whole = read_code_file(files, graph, node, url, failures)) return MappedText(files.sources, *whole);
  }
  if (auto code = code_in_url(joined_cdata(graph, node))) return code;
  for (const Diagnostic& failure : failures.all()) diagnostics.report(failure.id, failure.span, failure.message);
  return std::nullopt;
}

ScriptKind kind_of(FieldType type) {
  if (type == FieldType::SFString) return ScriptKind::text;
  if (!slot_type(type)) return ScriptKind::other;
  switch (*slot_type(type)) {
    case SlotType::bool_: return ScriptKind::boolean;
    case SlotType::int_: return ScriptKind::integer;
    case SlotType::float_: return ScriptKind::number;
    case SlotType::vec2: return ScriptKind::vec2;
    case SlotType::vec3: return ScriptKind::vec3;
    case SlotType::vec4:
    case SlotType::rotation: return ScriptKind::vec4;
    case SlotType::mat3: return ScriptKind::mat3;
    case SlotType::mat4: return ScriptKind::mat4;
  }
  return ScriptKind::other;
}

/// Lists begin empty, all else as zeros, where nobody has written a value.
std::vector<double> first_value(const InterfaceField& field) {
  if (!field.value.numbers.empty()) return {field.value.numbers.begin(), field.value.numbers.end()};
  std::vector<double> value;
  if (field.type == FieldType::SFString && !field.value.strings.empty()) {
    for (const char c : field.value.strings.front().text()) value.push_back(static_cast<unsigned char>(c));
  }
  const auto type = slot_type(field.type);
  if (type && !is_multiple(field.type)) value.assign(component_count(*type), 0.0);
  return value;
}

std::vector<ScriptField> script_fields(const GraphNode& node) {
  std::vector<ScriptField> fields;
  for (const InterfaceField& own : node.interface()) {
    const ScriptKind kind = kind_of(own.type);
    const bool list = is_multiple(own.type) && kind != ScriptKind::other;
    fields.push_back({own.name,
                      {kind, list},
                      allows(own.access, EventUse::receive),
                      own.access != AccessType::input_only,
                      first_value(own)});
  }
  return fields;
}

void add_script(Scripts& scripts, const GraphNode& node, NodeId id, ScriptProgram program) {
  SceneScript& script = scripts[id];
  script.program = std::move(program);
  std::set<int> answered, stored;
  for (const ScriptFunction& function : script.program.functions) {
    answered.insert(function.field);
    stored.insert(function.sends.begin(), function.sends.end());
  }
  const std::span<const InterfaceField> fields = node.interface();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto field = static_cast<int>(i);
    const bool holds = fields[i].access == AccessType::input_output;
    const bool sends = allows(fields[i].access, EventUse::send) && stored.contains(field);
    script.inputs.push_back(holds || answered.contains(field) ? fields[i].name : "");
    script.outputs.push_back(sends ? fields[i].name : "");
  }
  script.info = {node.info->name, EventKind::script, script.inputs, script.outputs};
}

bool has_too_many_fields(const GraphNode& script, Diagnostics& diagnostics) {
  const bool too_many = script.interface().size() > kMaxScriptFields;
  if (too_many)
    diagnostics.report(DiagnosticId::scene_limit, script.type_span,
                       fmt::format("this Script has more than {} fields; it does not run", kMaxScriptFields));
  return too_many;
}

/// What each instance of a Script takes anew.
std::size_t size_of(const MappedText& code, std::span<const ScriptField> fields) {
  std::size_t size = code.size();
  for (const ScriptField& field : fields) size += field.value.size();
  return size;
}

void report_rest(const GraphNode& script, Diagnostics& diagnostics) {
  diagnostics.report(DiagnosticId::scene_limit, script.type_span,
                     fmt::format("all Scripts together have more than {} characters of code and numbers in their fields; "
                                 "those from this one on do not run",
                                 kMaxSceneScriptSize));
}

}  // namespace

Scripts read_scripts(const NodeGraph& graph, CodeFiles& files, Diagnostics& diagnostics) {
  Scripts scripts;
  std::size_t size = 0;
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const NodeId id{i};
    if (!graph.is(id, "X3DScriptNode")) continue;
    const auto code = find_code(graph, id, files, diagnostics);
    if (!code || has_too_many_fields(graph[id], diagnostics)) continue;
    const std::vector<ScriptField> fields = script_fields(graph[id]);
    size += size_of(*code, fields);
    if (size > kMaxSceneScriptSize) {
      report_rest(graph[id], diagnostics);
      break;
    }
    ScriptProgram program = compile_script(*code, fields, diagnostics);
    if (!program.functions.empty()) add_script(scripts, graph[id], id, std::move(program));
  }
  return scripts;
}

bool sends_at_start(const Scripts& scripts, NodeId node, std::string_view field) {
  const auto found = scripts.find(node);
  if (found == scripts.end()) return false;
  const int index = find_field_index(found->second.outputs, field);
  const auto stores = [&](const ScriptFunction& one) {
    return one.field < 0 && std::ranges::find(one.sends, index) != one.sends.end();
  };
  return index >= 0 && std::ranges::any_of(found->second.program.functions, stores);
}

const EventNodeInfo* find_event_node(const NodeGraph& graph, const Scripts& scripts, NodeId node) {
  const auto script = scripts.find(node);
  return script != scripts.end() ? &script->second.info : find_event_node(graph[node].info->name);
}

}  // namespace plugc

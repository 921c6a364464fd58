// Reads the embedded table once. Its parameters are plain `[const] direction type name` lists, split at commas and blanks.

#include "compose/plug_table.h"

#include <algorithm>

#include "base/check.h"
#include "stdlib_plugs/stdlib_plugs.h"

namespace plugc {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

PlugParameter read_parameter(std::string_view text) {
  std::vector<std::string_view> words = split(text, ' ');
  std::erase(words, std::string_view());
  PlugParameter parameter;
  if (words.front() == "const") {
    parameter.is_const = true;
    words.erase(words.begin());
  }
  PLUGC_CHECK(words.size() == 3, "a parameter is direction, type, name");
  parameter.direction = words[0];
  parameter.type = words[1];
  parameter.name = words[2];
  return parameter;
}

PlugStage read_stage(std::string_view text) {
  if (text == "V") return PlugStage::vertex;
  if (text == "G") return PlugStage::geometry;
  return text == "F" ? PlugStage::fragment : PlugStage::lighting;
}

void note_kept_changes(std::string_view names, PlugInfo& plug) {
  for (const std::string_view name : split(names, ' ')) {
    const auto named = [&](const PlugParameter& parameter) { return parameter.name == name; };
    const auto found = std::find_if(plug.parameters.begin(), plug.parameters.end(), named);
    PLUGC_CHECK(found != plug.parameters.end(), "kept changes are those of parameters");
    found->keeps_changes = true;
  }
}

std::vector<PlugInfo> read_table() {
  std::vector<PlugInfo> table;
  for (const std::string_view line : split(stdlib_text("plugs.tsv"), '\n')) {
    const auto columns = split(line, '\t');
    if (columns.size() < 5 || columns[0] == "name") continue;
    PlugInfo plug{columns[0], read_stage(columns[1]), columns[2], {}, columns[3], columns[4]};
    if (!plug.signature.empty()) {
      for (const std::string_view parameter : split(plug.signature, ',')) plug.parameters.push_back(read_parameter(parameter));
    }
    if (columns.size() > 5) note_kept_changes(columns[5], plug);
    table.push_back(std::move(plug));
  }
  return table;
}

}  // namespace

std::string_view to_text(PlugStage stage) {
  switch (stage) {
    case PlugStage::vertex: return "VERTEX";
    case PlugStage::geometry: return "GEOMETRY";
    case PlugStage::fragment: return "FRAGMENT";
    case PlugStage::lighting: return "LIGHT";
  }
  return "";
}

std::span<const PlugInfo> plug_table() {
  static const std::vector<PlugInfo> table = read_table();
  return table;
}

const PlugInfo* find_plug(std::string_view name) {
  const auto table = plug_table();
  const auto found = std::find_if(table.begin(), table.end(), [&](const PlugInfo& plug) { return plug.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::span<const std::string_view> plug_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const PlugInfo& plug : plug_table()) list.push_back(plug.name);
    return list;
  }();
  return names;
}

}  // namespace plugc

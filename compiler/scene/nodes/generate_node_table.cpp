// generate_node_table OUT.inc TSV...: the node tables as constexpr arrays that node_table.cpp includes.
//
// The first word of its header says what a table gives: `abstract` the abstract types and their bases; `component` the
// components and their highest levels; `enumeration` the words that a string field takes, separated by `|` (`""` for the
// empty one); every other one field a row.
// A row without a base adds its field to a node that another table defines, or, when it names an abstract type, to every
// node of that type. A node whose base is itself a node inherits that node's fields. `@containerField` rows give the XML
// default. A later addition of the same field wins. Nodes, and fields inside a node, come out sorted by name, so that
// look-up is a binary search.

#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Field {
  std::string type, access, value, minimum, maximum, accepts, words;
};

struct Node {
  std::string component, bases, container_field;
  std::map<std::string, Field> fields;
};

struct Tables {
  std::map<std::string, std::string> abstracts;  // name to bases
  std::map<std::string, Node> nodes;
  std::vector<std::vector<std::string>> additions;  // rows without a base
  std::vector<std::vector<std::string>> enumerations;
  std::map<std::string, std::string> components;  // name to highest level
};

const std::set<std::string> kWithInterface = {"ComposedShader", "Effect", "PackagedShader", "Script", "ShaderProgram"};

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, separator);) cells.push_back(cell);
  return cells;
}

void set_field(Node& node, const std::vector<std::string>& row) {
  if (row[4] == "@containerField") {
    node.container_field = row[7];
  } else {
    node.fields[row[4]] = {row[5], row[6], row[7], row[8], row[9], row[10], ""};
  }
}

void read_table(const std::string& path, Tables& tables) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const bool abstract = line.rfind("abstract", 0) == 0;
  const bool component = line.rfind("component", 0) == 0;
  const bool enumeration = line.rfind("enumeration", 0) == 0;
  while (std::getline(file, line)) {
    std::vector<std::string> row = split(line, '\t');
    row.resize(abstract || component ? 2 : enumeration ? 3 : 11);
    if (row[0].empty()) continue;
    if (component) {
      tables.components[row[0]] = row[1];
    } else if (enumeration) {
      tables.enumerations.push_back(row);
    } else if (abstract) {
      tables.abstracts[row[0]] = row[1];
    } else if (row[3].empty()) {
      tables.additions.push_back(row);
    } else {
      Node& node = tables.nodes[row[0]];
      node.component = row[1];
      node.bases = row[3];
      set_field(node, row);
    }
  }
}

bool is_a(const Tables& tables, const std::string& type, const std::string& base) {
  if (type == base) return true;
  const auto node = tables.nodes.find(type);
  const auto abstract = tables.abstracts.find(type);
  const std::string bases = node != tables.nodes.end()           ? node->second.bases
                            : abstract != tables.abstracts.end() ? abstract->second
                                                                 : "";
  for (const std::string& one : split(bases, '|')) {
    if (is_a(tables, one, base)) return true;
  }
  return false;
}

/// False when a row adds to a type that no table knows.
bool add_fields(Tables& tables) {
  for (const std::vector<std::string>& row : tables.additions) {
    bool found = false;
    for (auto& [name, node] : tables.nodes) {
      if (!is_a(tables, name, row[0])) continue;
      set_field(node, row);
      found = true;
    }
    if (found) continue;
    std::fprintf(stderr, "generate_node_table: no node is a `%s`\n", row[0].c_str());
    return false;
  }
  return true;
}

/// False when a row names a string field that no node of its type has.
bool add_enumerations(Tables& tables) {
  for (const std::vector<std::string>& row : tables.enumerations) {
    bool found = false;
    for (auto& [name, node] : tables.nodes) {
      const auto field = node.fields.find(row[1]);
      if (!is_a(tables, name, row[0]) || field == node.fields.end()) continue;
      if (field->second.type != "SFString" && field->second.type != "MFString") continue;
      field->second.words = row[2];
      found = true;
    }
    if (found) continue;
    std::fprintf(stderr, "generate_node_table: no `%s` has a string field `%s`\n", row[0].c_str(), row[1].c_str());
    return false;
  }
  return true;
}

void inherit_fields(Tables& tables) {
  for (auto& [name, node] : tables.nodes) {
    for (const std::string& base : split(node.bases, '|')) {
      const auto inherited = tables.nodes.find(base);
      if (inherited == tables.nodes.end()) continue;
      node.fields.insert(inherited->second.fields.begin(), inherited->second.fields.end());
      if (node.container_field.empty()) node.container_field = inherited->second.container_field;
    }
  }
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// Types that plugc gives no value (`XFAny`) become `unknown`.
std::string type_name(const std::string& type) {
  const bool plain = (type.rfind("SF", 0) == 0 || type.rfind("MF", 0) == 0);
  return plain ? type : "unknown";
}

std::string access_name(const std::string& access) {
  if (access == "initializeOnly") return "initialize_only";
  if (access == "inputOnly") return "input_only";
  if (access == "outputOnly") return "output_only";
  return "input_output";
}

void write_fields(std::ostream& out, const Tables& tables) {
  out << "constexpr FieldInfo kFields[] = {\n";
  for (const auto& [name, node] : tables.nodes) {
    out << "    // " << name << "\n";
    for (const auto& [field_name, field] : node.fields) {
      out << "    {" << quoted(field_name) << ", FieldType::" << type_name(field.type)
          << ", FieldAccess::" << access_name(field.access) << ", " << quoted(field.value) << ", " << quoted(field.minimum)
          << ", " << quoted(field.maximum) << ", " << quoted(field.accepts) << ", " << quoted(field.words) << "},\n";
    }
  }
  out << "};\n\n";
}

void write_nodes(std::ostream& out, const Tables& tables) {
  out << "constexpr NodeInfo kNodes[] = {\n";
  std::size_t first = 0;
  for (const auto& [name, node] : tables.nodes) {
    out << "    {" << quoted(name) << ", " << quoted(node.component) << ", " << quoted(node.bases) << ", "
        << quoted(node.container_field) << ", {kFields + " << first << ", " << node.fields.size() << "}, "
        << (kWithInterface.count(name) != 0 ? "true" : "false") << "},\n";
    first += node.fields.size();
  }
  out << "};\n\n";
}

void write_abstracts(std::ostream& out, const Tables& tables) {
  out << "constexpr AbstractInfo kAbstracts[] = {\n";
  for (const auto& [name, bases] : tables.abstracts) out << "    {" << quoted(name) << ", " << quoted(bases) << "},\n";
  out << "};\n";
}

void write_components(std::ostream& out, const Tables& tables) {
  out << "\nconstexpr ComponentInfo kComponents[] = {\n";
  for (const auto& [name, level] : tables.components) out << "    {" << quoted(name) << ", " << level << "},\n";
  out << "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: generate_node_table OUT.inc TSV...\n");
    return 2;
  }
  Tables tables;
  for (int i = 2; i < argc; ++i) read_table(argv[i], tables);
  if (!add_fields(tables)) return 1;
  inherit_fields(tables);
  if (!add_enumerations(tables)) return 1;
  std::ofstream out(argv[1]);
  out << "// Made by generate_node_table. Change the tables in scene/nodes, not this file.\n\n";
  write_fields(out, tables);
  write_nodes(out, tables);
  write_abstracts(out, tables);
  write_components(out, tables);
  return out.good() ? 0 : 1;
}

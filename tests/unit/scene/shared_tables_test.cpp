// The tables that plugc was made from lie beside the project, where they are present. Every node and field of theirs is in
// plugc's own, as they say; the deliberate differences stand in shared_tables_differences.tsv, each with its reason.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/node_table.h"

namespace plugc {
namespace {

const std::filesystem::path kTables = PLUGC_SOURCE_DIR "/../shared/data";

std::vector<std::vector<std::string>> read_rows(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);  // the names of the columns
  while (std::getline(file, line)) {
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    row.resize(11);
  }
  return rows;
}

std::string_view access_word(FieldAccess access) {
  switch (access) {
    case FieldAccess::initialize_only: return "initializeOnly";
    case FieldAccess::input_only: return "inputOnly";
    case FieldAccess::output_only: return "outputOnly";
    case FieldAccess::input_output: return "inputOutput";
  }
  return "";
}

/// "Node.field what" for each thing in which plugc's table is not what the row says.
void compare(const std::vector<std::string>& row, std::vector<std::string>& differences) {
  const std::string subject = row[0] + "." + row[4];
  const auto differs = [&](const std::string& what) { differences.push_back(subject + " " + what); };
  const NodeInfo* node = find_node_info(row[0]);
  if (node == nullptr) return differs("node");
  if (row[4] == "@containerField") {
    if (node->container_field != row[7]) differs("default");
    return;
  }
  const FieldInfo* field = find_field_info(*node, row[4]);
  if (field == nullptr) return differs("field");
  if (to_text(field->type) != row[5]) differs("type");
  if (access_word(field->access) != row[6]) differs("access");
  if (field->default_text != row[7]) differs("default");
  if (field->minimum != row[8] || field->maximum != row[9]) differs("range");
  if (field->accepts != row[10]) differs("accepts");
}

TEST(NodeTable, HoldsWhatTheSharedTablesSay) {
  if (!std::filesystem::exists(kTables)) GTEST_SKIP() << "there are no shared tables beside the project";
  std::vector<std::string> differences;
  for (const char* table : {"x3d-4.1-fields.tsv", "castle-extensions-fields.tsv"}) {
    for (const auto& row : read_rows(kTables / table)) compare(row, differences);
  }
  std::vector<std::string> expected;
  for (const auto& row : read_rows(PLUGC_SOURCE_DIR "/tests/unit/scene/shared_tables_differences.tsv")) {
    EXPECT_FALSE(row[1].empty()) << row[0] << " has no reason";
    expected.push_back(row[0]);
  }
  EXPECT_THAT(differences, testing::UnorderedElementsAreArray(expected));
}

TEST(NodeTable, HasTheAbstractTypesOfTheSharedTables) {
  if (!std::filesystem::exists(kTables)) GTEST_SKIP() << "there are no shared tables beside the project";
  std::map<std::string, std::string> bases;
  for (const auto& row : read_rows(kTables / "x3d-4.1-abstract.tsv")) bases[row[0]] = row[1];
  for (const auto& row : read_rows(kTables / "x3d-4.1-fields.tsv")) {
    const NodeInfo* node = find_node_info(row[0]);
    if (node == nullptr) continue;  // the other test tells
    for (std::string base = row[3]; !base.empty(); base = bases[base]) {
      if (base.find('|') != std::string::npos) break;
      EXPECT_TRUE(is_a(*node, base)) << row[0] << " is a " << base;
    }
  }
}

}  // namespace
}  // namespace plugc

// Columns stand between tabs, parameters between commas; the last word of a parameter is its name, the one before its type.

#include "oracle/plug_rows.h"

#include <algorithm>
#include <sstream>

#include "stdlib_plugs/stdlib_plugs.h"

namespace plugc::oracle {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, separator);) pieces.push_back(piece);
  return pieces;
}

ParameterModel parameter(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  ParameterModel read{"", words[words.size() - 2]};
  for (std::size_t i = 0; i + 2 < words.size(); ++i) read.qualifier += (i > 0 ? " " : "") + words[i];
  return read;
}

std::vector<PlugRow> read_rows() {
  std::vector<PlugRow> rows;
  const std::vector<std::string> lines = split(std::string(stdlib_text("plugs.tsv")), '\n');
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> columns = split(lines[i], '\t');
    PlugRow row{columns[0], columns[1][0], {}, columns[3], {}};
    const std::vector<std::string> kept = columns.size() > 5 ? split(columns[5], ' ') : std::vector<std::string>();
    for (const std::string& text : split(columns[2], ',')) {
      row.parameters.push_back(parameter(text));
      row.keeps_changes.push_back(std::find(kept.begin(), kept.end(), text.substr(text.rfind(' ') + 1)) != kept.end());
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::span<const PlugRow> plug_rows() {
  static const std::vector<PlugRow> rows = read_rows();
  return rows;
}

const PlugRow* find_row(const std::string& name) {
  for (const PlugRow& row : plug_rows()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace plugc::oracle

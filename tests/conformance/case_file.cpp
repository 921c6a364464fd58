// Line by line; a line that starts with three dashes and a blank opens a section.

#include "conformance/case_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDashes = "--- ";

std::vector<std::string> words(std::string_view line) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> found;
  for (std::string word; stream >> word;) found.push_back(word);
  return found;
}

CaseFile read_case_file(const fs::path& path, const fs::path& folder) {
  CaseFile file;
  file.path = path;
  file.name = path.lexically_relative(folder).replace_extension().string();
  std::replace(file.name.begin(), file.name.end(), '/', '.');
  std::ifstream stream(path);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.starts_with(kDashes)) {
      file.sections.push_back({words(std::string_view(line).substr(kDashes.size())), number, {}});
    } else {
      (file.sections.empty() ? file.head : file.sections.back().lines).push_back(line);
    }
  }
  return file;
}

bool is_titled(const CaseSection& section, std::string_view title, std::string_view second) {
  if (section.title.empty() || section.title.front() != title) return false;
  return second.empty() || (section.title.size() > 1 && section.title[1] == second);
}

bool is_input(const CaseSection& section) {
  const std::string& kind = section.title.front();
  return kind == "file" || kind == "scene" || kind == "image" || kind == "options";
}

}  // namespace

const CaseSection* CaseFile::find(std::string_view title, std::string_view second) const {
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const CaseSection& section) { return is_titled(section, title, second); });
  return found == sections.end() ? nullptr : &*found;
}

std::vector<CaseFile> read_case_files(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".case") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<CaseFile> files;
  for (const fs::path& path : paths) files.push_back(read_case_file(path, folder));
  return files;
}

std::string section_text(const CaseSection& section) {
  std::string text;
  for (const std::string& line : section.lines) text += line + "\n";
  return text;
}

void rewrite_diagnostics(CaseFile& file, std::string_view scene, const std::vector<std::string>& lines) {
  const auto is_diagnostics = [&](const CaseSection& section) { return is_titled(section, "diagnostics", scene); };
  auto place = std::find_if(file.sections.begin(), file.sections.end(), is_diagnostics);
  if (place == file.sections.end()) {  // behind the scene's files, in front of what is expected of the program
    place = std::find_if_not(file.sections.begin(), file.sections.end(), [](const CaseSection& section) {
      return is_input(section) || section.title.front() == "diagnostics";
    });
    CaseSection section{{"diagnostics"}, 0, {}};
    if (!scene.empty()) section.title.emplace_back(scene);
    place = file.sections.insert(place, std::move(section));
  }
  place->lines = lines;
  if (lines.empty()) file.sections.erase(place);
  std::ofstream stream(file.path, std::ios::trunc);
  for (const std::string& line : file.head) stream << line << "\n";
  for (const CaseSection& section : file.sections) {
    stream << "---";
    for (const std::string& word : section.title) stream << " " << word;
    stream << "\n" << section_text(section);
  }
}

}  // namespace plugc

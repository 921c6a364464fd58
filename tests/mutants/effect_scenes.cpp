// A scene counts when its own text names a node that holds shader code; shader files of their own come in through its urls.

#include "mutants/effect_scenes.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "conformance/case_file.h"

namespace plugc::mutants {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool holds_shaders(std::string_view text) {
  return text.find("EffectPart") != std::string_view::npos || text.find("ShaderPart") != std::string_view::npos;
}

bool is_scene(const fs::path& path) {
  constexpr std::string_view kEndings[] = {".x3dv", ".x3d", ".wrl"};
  return std::find(std::begin(kEndings), std::end(kEndings), path.extension().string()) != std::end(kEndings);
}

void add_scenes_below(const fs::path& folder, std::vector<EffectScene>& scenes) {
  std::error_code missing;
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, missing)) {
    if (is_scene(entry.path()) && holds_shaders(read_file(entry.path()))) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const fs::path& path : paths) scenes.push_back({path.lexically_relative(folder).string(), path, {}, folder});
}

/// The first scene of a case, where all its files are texts.
void add_case(const CaseFile& file, std::vector<EffectScene>& scenes) {
  EffectScene scene;
  scene.name = file.name;
  bool has_shaders = false;
  for (const CaseSection& section : file.sections) {
    const std::string& kind = section.title.front();
    if (kind == "image" || kind == "gzip") return;
    if (kind != "file" && kind != "scene") continue;
    if (scene.path.empty()) scene.path = section.title.at(1);
    has_shaders = has_shaders || holds_shaders(section_text(section));
    scene.files[section.title.at(1)] = section_text(section);
  }
  if (has_shaders) scenes.push_back(std::move(scene));
}

}  // namespace

LayeredFiles::LayeredFiles(const EffectScene& scene) {
  memory_.files = scene.files;
  if (!scene.root.empty()) disk_.emplace(scene.root);
}

FileContent LayeredFiles::read(const fs::path& path) {
  FileContent content = memory_.read(path);
  return content.status == FileStatus::missing && disk_ ? disk_->read(path) : content;
}

std::vector<EffectScene> find_effect_scenes(const fs::path& checkout) {
  std::vector<EffectScene> scenes;
  for (const char* folder : {"../shared/corpus/scenes", "examples", "stdlib_plugs/effects"}) {
    add_scenes_below((checkout / folder).lexically_normal(), scenes);
  }
  for (const CaseFile& file : read_case_files(checkout / "tests/conformance")) add_case(file, scenes);
  return scenes;
}

}  // namespace plugc::mutants

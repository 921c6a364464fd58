// Groups stand in the page in the order of kGroups; one that is not there is a mistake, which the test of the page shows.

#include "pictures/picture_scenes.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "scene/node_table.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

struct Group {
  std::string_view folder, title;
};

constexpr std::array kGroups = {
    Group{"geometry3d", "Solids and faces"},
    Group{"geometry2d", "Figures in a plane"},
    Group{"lines", "Lines and points"},
    Group{"text", "Text"},
    Group{"materials", "Materials"},
    Group{"appearance", "Filling, alpha, clipping"},
    Group{"textures", "Textures"},
    Group{"lights", "Lights"},
    Group{"fog", "Fog"},
    Group{"background", "Backgrounds"},
    Group{"groups", "Groups"},
    Group{"shaders", "Shaders"},
    Group{"offscreen", "Textures that are drawn, and effects on the whole picture"},
};

std::string second_line(const fs::path& scene) {
  std::ifstream stream(scene);
  std::string line;
  std::getline(stream, line);
  std::getline(stream, line);
  return line.starts_with("# ") ? line.substr(2) : "";
}

std::size_t group_place(const PictureScene& scene) {
  return static_cast<std::size_t>(std::ranges::find(kGroups, scene.group, &Group::folder) - kGroups.begin());
}

/// In a table a bar would end the cell.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  return text;
}

}  // namespace

std::vector<PictureScene> read_picture_scenes() {
  std::vector<PictureScene> scenes;
  for (const auto& entry : fs::recursive_directory_iterator(PLUGC_SOURCE_DIR "/tests/pictures")) {
    if (entry.path().extension() != ".x3dv") continue;
    PictureScene scene{entry.path().parent_path().filename().string(), entry.path().stem().string(), second_line(entry.path()),
                       entry.path(), entry.path()};
    scene.picture.replace_extension(".png");
    scenes.push_back(std::move(scene));
  }
  std::ranges::sort(scenes, {},
                    [](const PictureScene& scene) { return std::tuple(group_place(scene), scene.group, scene.name); });
  return scenes;
}

namespace {

constexpr std::string_view kComponents[] = {
    "Shape",   "Rendering", "Geometry3D", "Geometry2D",       "Text",       "Texturing",           "Texturing3D", "Lighting",
    "Shaders", "Grouping",  "Navigation", "CubeMapTexturing", "Networking", "EnvironmentalEffects"};

/// Nothing of these is drawn, or not by this suite.
constexpr std::string_view kExceptions[] = {
    "AcousticProperties",  // is heard
    "LoadSensor",          // tells of loading
    "PackagedShader",
    "ProgramShader",
    "ShaderProgram",  // shaders in languages that plugc does not compile
    "EnvironmentLight",
    "FontLibrary",
    "InlineGeometry",  // of X3D 4.1, not drawn
    "MovieTexture",    // shows a picture as ImageTexture does
    // of the reference engine and of other viewers, not drawn
    "MultiGeneratedTextureCoordinate",
    // of the reference engine, drawn as the nodes that they extend, or only settings
    "KambiAppearance",
    "KambiHeadLight",
    "KambiInline",
    "KambiNavigationInfo",
    "KambiOctreeProperties",
    "KambiTriangulation",
};

/// Words that open a node in the classic encoding.
std::set<std::string> words_before_braces(const std::string& text) {
  std::set<std::string> words;
  static const std::regex node(R"(\b([A-Z]\w*)\s*\{)");
  for (auto found = std::sregex_iterator(text.begin(), text.end(), node); found != std::sregex_iterator(); ++found)
    words.insert((*found)[1]);
  return words;
}

}  // namespace

std::vector<std::string> nodes_without_picture(const std::vector<PictureScene>& scenes) {
  std::set<std::string> shown;
  for (const PictureScene& scene : scenes) {
    std::ifstream stream(scene.scene);
    shown.merge(words_before_braces({std::istreambuf_iterator<char>(stream), {}}));
  }
  std::vector<std::string> missing;
  for (const NodeInfo& node : node_table()) {
    const bool counts = std::ranges::find(kComponents, node.component) != std::end(kComponents) &&
                        std::ranges::find(kExceptions, node.name) == std::end(kExceptions);
    if (counts && !shown.contains(std::string(node.name))) missing.emplace_back(node.name);
  }
  return missing;
}

std::string nodes_page(const std::vector<PictureScene>& scenes) {
  std::string page =
      "# What nodes look like\n\n"
      "Every picture is drawn by plugc from the scene of the same name beside it, and is compared with what plugc draws by "
      "every\n"
      "test run (`./dev test -R pictures`). `PLUGC_REWRITE=1 build/bin/pictures` writes this page.\n";
  std::string group;
  for (const PictureScene& scene : scenes) {
    if (scene.group != group) {
      group = scene.group;
      const std::size_t place = group_place(scene);
      page += fmt::format("\n## {}\n\n| | |\n|---|---|\n", place < kGroups.size() ? kGroups[place].title : group);
    }
    page += fmt::format("| [![{0}](../tests/pictures/{1}/{0}.png)](../tests/pictures/{1}/{0}.x3dv) | {2} |\n", scene.name,
                        scene.group, cell(scene.about));
  }
  return page;
}

}  // namespace plugc

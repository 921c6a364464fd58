#pragma once
// The scenes of this suite: tests/pictures/<group>/<name>.x3dv, each with what it shows in its second line and with its picture
// beside it.

#include <filesystem>
#include <string>
#include <vector>

namespace plugc {

struct PictureScene {
  std::string group, name;
  std::string about;  ///< The comment in the second line.
  std::filesystem::path scene, picture;
};

/// In the order of groups and names.
std::vector<PictureScene> read_picture_scenes();

/// Nodes that can be seen, of which no scene has one: those of the components that this suite shows, less what is not to be
/// seen.
std::vector<std::string> nodes_without_picture(const std::vector<PictureScene>& scenes);

/// docs/nodes.md: a table a group, every scene with its picture.
std::string nodes_page(const std::vector<PictureScene>& scenes);

}  // namespace plugc

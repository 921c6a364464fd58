#pragma once
// The scenes whose effects are mutated, each with the files beside it.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/file_access.h"

namespace plugc::mutants {

/// A scene; its files come from memory, then from the disk below `root`.
struct EffectScene {
  std::string name;  ///< For people: the case's name, or the path below its folder.
  std::filesystem::path path;
  std::map<std::string, std::string> files;  ///< By path.
  std::filesystem::path root;                ///< Empty: everything is in memory.
};

/// Reads what is in memory from there, and the rest from the disk.
class LayeredFiles : public FileAccess {
 public:
  explicit LayeredFiles(const EffectScene& scene);
  FileContent read(const std::filesystem::path& path) override;
  /// From here the file has other bytes.
  void replace(const std::string& path, std::string bytes) { memory_.files[path] = std::move(bytes); }

 private:
  MemoryFiles memory_;
  std::optional<DiskFiles> disk_;
};

/// Scenes with a shader in them: the shared corpus where it lies beside the checkout, the examples, the standard effects, the
/// conformance cases; in name order.
std::vector<EffectScene> find_effect_scenes(const std::filesystem::path& checkout);

}  // namespace plugc::mutants

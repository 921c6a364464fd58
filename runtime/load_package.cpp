// Read the file whole, verify the bytes, keep both. A vector's bytes stay where they are when it is moved, so the view
// into them stays valid.

#include "runtime/load_package.h"

#include "base/file_access.h"

namespace plugc {

LoadedPackage load_package(std::vector<std::uint8_t> bytes, std::string& error) {
  LoadedPackage loaded;
  loaded.bytes = std::move(bytes);
  const PackageView view = open_package(loaded.bytes);
  loaded.package = view.package;
  if (view.package == nullptr) error = view.error;
  return loaded;
}

LoadedPackage load_package_file(const std::string& path, std::string& error) {
  DiskFiles files{{}};
  const FileContent content = files.read(path);
  if (content.status != FileStatus::ok) {
    error = "cannot read `" + path + "`" + (content.status == FileStatus::too_large ? ": it is too large" : "");
    return {};
  }
  LoadedPackage loaded = load_package({content.bytes.begin(), content.bytes.end()}, error);
  if (loaded.package == nullptr) error = "`" + path + "`: " + error;
  return loaded;
}

}  // namespace plugc

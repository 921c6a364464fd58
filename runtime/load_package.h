#pragma once
// From package bytes to data that can be drawn: nothing is decoded, only checked and pointed at.

#include <memory>
#include <string>
#include <vector>

#include "package/package_file.h"

namespace plugc {

/// Bytes kept alive with their verified view.
struct LoadedPackage {
  std::vector<std::uint8_t> bytes;
  const Package* package = nullptr;
};

/// Throws nothing: on failure `package` is null and `error` says why.
LoadedPackage load_package(std::vector<std::uint8_t> bytes, std::string& error);
LoadedPackage load_package_file(const std::string& path, std::string& error);

}  // namespace plugc

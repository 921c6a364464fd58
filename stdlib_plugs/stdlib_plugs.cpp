#include "stdlib_plugs/stdlib_plugs.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace plugc {
namespace {

constexpr auto kFiles = std::to_array<StdlibFile>({
#include "stdlib_data.inc"
});

}  // namespace

std::span<const StdlibFile> stdlib_files() {
  return kFiles;
}

std::string_view stdlib_text(std::string_view name) {
  const auto found = std::find_if(kFiles.begin(), kFiles.end(), [&](const StdlibFile& file) { return file.name == name; });
  if (found == kFiles.end()) std::abort();
  return found->text;
}

}  // namespace plugc

#pragma once
// The source files that a package names, and which lines and columns of them its texts come from.

#include <map>
#include <string>
#include <vector>

#include "base/source.h"
#include "package/package_file.h"

namespace plugc {

/// Source files by their place in the package's list.
class SourceList {
 public:
  SourceList(const SourceSet& sources, std::vector<std::string>& names) : sources_(&sources), names_(&names) {}
  std::vector<PackedLineOrigin> origins(const MappedText& text);
  PackedLineOrigin origin(const Span& span);
  /// Where columns differ from those of the lines that `origins` names.
  std::vector<PackedColumnOrigin> columns(const MappedText& text, const std::vector<PackedLineOrigin>& origins);

 private:
  std::uint32_t index(SourceId source);
  const SourceSet* sources_;
  std::vector<std::string>* names_;
  std::map<std::uint32_t, std::uint32_t> known_;
};

}  // namespace plugc

#pragma once
// The files of stdlib_plugs/ that plugc carries inside itself: template shaders and the table of plugs.

#include <span>
#include <string_view>

namespace plugc {

struct StdlibFile {
  std::string_view name;  ///< Path below stdlib_plugs/, e.g. `templates/phong.frag`.
  std::string_view text;
};

std::span<const StdlibFile> stdlib_files();
/// The text of one file; the file must exist (checked by a test that asks for all).
std::string_view stdlib_text(std::string_view name);

}  // namespace plugc

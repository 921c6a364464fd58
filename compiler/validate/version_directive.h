#pragma once
// The two directives that matter before and after parsing: `#version` and `#line`.

#include <optional>
#include <string>
#include <string_view>

#include "glsl/stage.h"

namespace plugc {

/// `#version 330 core` as written. Number 0: there is none, which GLSL takes as 110 and ESSL as 100.
struct WrittenVersion {
  std::uint32_t number = 0;
  std::string profile;
  std::uint32_t line = 0;
};

/// The directive behind nothing but white space and comments, where alone it is allowed (GLSL 3.30, 3.3).
WrittenVersion read_version_directive(std::string_view text);

/// Whether text of this version may be given to the target's compiler.
bool fits(const WrittenVersion& version, Target target);
/// Says why not.
std::string mismatch_text(const WrittenVersion& version, Target target);

/// The text with each `#line` directive blanked out, at the same size; nullopt when it has none.
std::optional<std::string> without_line_directives(std::string_view text);

}  // namespace plugc

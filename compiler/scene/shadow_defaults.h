#pragma once
// Shadow defaults as the command line writes them.

#include <string>
#include <string_view>

#include "scene/shadow_method.h"

namespace plugc {

struct ReadShadowDefaults {
  ShadowDefaults shadows;
  std::string error;  ///< Empty: none.
};

/// `METHOD[,SIZE]`: `pcf3`, or `pcf3,1024`.
ReadShadowDefaults read_shadow_defaults(std::string_view text);

}  // namespace plugc

// Asks the context for each name of functions.def. Mesa hands out a stub for any name that it has ever heard of, so a
// pointer alone does not prove a version: the context does that by asking for 3.3 when it is made.

#include "runtime/gl/functions.h"

#include <fmt/format.h>

#include "runtime/gl/context.h"

namespace plugc::gl {

constexpr std::size_t kMostErrors = 16;  // a lost context goes on for ever

bool load_functions(const Context& context, Functions& functions, std::string& error) {
#define PLUGC_GL(name, type)                                                          \
  functions.name = reinterpret_cast<PFNGL##type##PROC>(context.function("gl" #name)); \
  if (functions.name == nullptr) error = "the OpenGL driver lacks `gl" #name "`";
#include "runtime/gl/functions.def"
#undef PLUGC_GL
  return error.empty();
}

std::vector<std::string> take_errors(const Functions& functions) {
  std::vector<std::string> errors;
  for (GLenum error = functions.GetError(); error != GL_NO_ERROR && errors.size() < kMostErrors; error = functions.GetError()) {
    errors.push_back(fmt::format("0x{:04x}", error));
  }
  return errors;
}

}  // namespace plugc::gl

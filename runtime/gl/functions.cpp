// Asks the context for each name of functions.def. Mesa hands out a stub for any name that it has ever heard of, so a
// pointer alone does not prove a version: the context does that by asking for 3.3 when it is made.

#include "runtime/gl/functions.h"

#include <string_view>

#include <fmt/format.h>

#include "runtime/gl/context.h"

namespace plugc::gl {

namespace {

bool has_extension(const Functions& functions, std::string_view wanted) {
  GLint count = 0;
  functions.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* const name = reinterpret_cast<const char*>(functions.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (name != nullptr && wanted == name) return true;
  }
  return false;
}

}  // namespace

constexpr std::size_t kMostErrors = 16;  // a lost context goes on for ever

bool load_functions(const Context& context, Functions& functions, std::string& error) {
#define PLUGC_GL(name, type)                                                          \
  functions.name = reinterpret_cast<PFNGL##type##PROC>(context.function("gl" #name)); \
  if (functions.name == nullptr) error = "the OpenGL driver lacks `gl" #name "`";
#include "runtime/gl/functions.def"
#undef PLUGC_GL
  if (!error.empty()) return false;
  if (has_extension(functions, "GL_ARB_clip_control")) {
    functions.ClipControl = reinterpret_cast<PFNGLCLIPCONTROLPROC>(context.function("glClipControl"));
  }
  return true;
}

std::vector<std::string> take_errors(const Functions& functions) {
  std::vector<std::string> errors;
  for (GLenum error = functions.GetError(); error != GL_NO_ERROR && errors.size() < kMostErrors; error = functions.GetError()) {
    errors.push_back(fmt::format("0x{:04x}", error));
  }
  return errors;
}

}  // namespace plugc::gl

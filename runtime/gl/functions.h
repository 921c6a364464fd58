#pragma once
// OpenGL's functions as pointers of one context: no loader library finds them under OSMesa.

#include <string>
#include <vector>

#include <GL/glcorearb.h>

namespace plugc::gl {

class Context;

struct Functions {
#define PLUGC_GL(name, type) PFNGL##type##PROC name = nullptr;
#include "runtime/gl/functions.def"
#undef PLUGC_GL
  PFNGLCLIPCONTROLPROC ClipControl = nullptr;  ///< Absent before OpenGL 4.5 without GL_ARB_clip_control.
};

/// Fills every pointer that OpenGL 3.3 has, or says in `error` which of them the context lacks. The context must be current.
bool load_functions(const Context& context, Functions& functions, std::string& error);

/// Every error since the last call (`0x0502`), oldest first.
std::vector<std::string> take_errors(const Functions& functions);

}  // namespace plugc::gl

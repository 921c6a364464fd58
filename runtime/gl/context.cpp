// Mesa is tuned by environment variables that it reads once, when its library is loaded. So they are set before the first
// dlopen and never again: a `setenv` beside a running Mesa thread would be a race.
// The cache of generated code does not know about the vector width or `nopt` (neither is part of its key): each mode has
// a folder of its own, or one mode would be handed the other's code.

#include "runtime/gl/context.h"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string_view>

#include "runtime/gl/functions.h"
#include "runtime/gl/pass.h"

namespace plugc::gl {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool says_true(std::string_view value) {
  return value == "1" || value == "true" || value == "yes" || value == "y";
}

/// Where cached code may lie: what the user set, what the caller wishes, Mesa's own place; empty when there is none.
fs::path cache_base(const std::string& wished) {
  if (const std::string set = environment("MESA_SHADER_CACHE_DIR"); !set.empty()) return set;
  if (!wished.empty()) return wished;
  if (const std::string xdg = environment("XDG_CACHE_HOME"); !xdg.empty()) return fs::path(xdg) / "plugc";
  if (const std::string home = environment("HOME"); !home.empty()) return fs::path(home) / ".cache" / "plugc";
  return {};
}

void set_cache_folder(const ContextTuning& tuning) {
  if (says_true(environment("MESA_SHADER_CACHE_DISABLE")) || says_true(environment("MESA_GLSL_CACHE_DISABLE"))) return;
  const fs::path base = cache_base(tuning.cache_folder);
  const fs::path folder = base / (tuning.single_picture ? "single_picture" : "many_frames");
  std::error_code error;
  if (!base.empty()) fs::create_directories(folder, error);
  if (base.empty() || error) {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  } else {
    setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
  }
}

}  // namespace

void tune_mesa(const ContextTuning& tuning) {
  static std::once_flag once;  // the environment and the loaded library belong to the process
  std::call_once(once, [&tuning] {
    set_cache_folder(tuning);
    if (!tuning.single_picture) return;
    setenv("GALLIVM_PERF", "nopt", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
  });
}

std::unique_ptr<Context> make_context(const ContextTuning& tuning, std::string& error) {
  tune_mesa(tuning);
  std::string osmesa_error;
  if (auto context = make_osmesa_context(osmesa_error)) return context;
  std::string egl_error;
  if (auto context = make_egl_context(egl_error)) return context;
  error = osmesa_error + "; " + egl_error;
  return nullptr;
}

std::unique_ptr<Context> make_current_context(const ContextTuning& tuning, Functions& functions, std::string& error) {
  std::unique_ptr<Context> context = make_context(tuning, error);
  if (context == nullptr) return nullptr;
  if (!context->make_current()) {
    error = "the OpenGL context cannot be made current";
    return nullptr;
  }
  if (!load_functions(*context, functions, error)) return nullptr;
  set_context_defaults(functions);
  return context;
}

}  // namespace plugc::gl

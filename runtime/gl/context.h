#pragma once
// An OpenGL 3.3 core context without a window. Two ways to one: OSMesa (quick to start) and EGL surfaceless (what Mesa
// keeps from 25.1 on).

#include <memory>
#include <string>

namespace plugc::gl {

class Context {
 public:
  virtual ~Context() = default;
  /// Binds the context to the calling thread. Cheap when it is bound already.
  virtual bool make_current() = 0;
  /// The function of that name (`glClear`), or null.
  virtual void* function(const char* name) const = 0;
};

/// How Mesa generates code. A process has one way: whatever was asked first.
struct ContextTuning {
  bool single_picture = false;
  std::string cache_folder;
};

/// The first kind that works. Null with `error` set when none does.
std::unique_ptr<Context> make_context(const ContextTuning& tuning, std::string& error);

struct Functions;
/// The same, current on the calling thread and with set_context_defaults(), and its functions. Null with `error` set where
/// anything of it fails.
std::unique_ptr<Context> make_current_context(const ContextTuning& tuning, Functions& functions, std::string& error);

std::unique_ptr<Context> make_osmesa_context(std::string& error);
std::unique_ptr<Context> make_egl_context(std::string& error);

/// Sets Mesa's environment variables. Does something on the first call of a process only.
void tune_mesa(const ContextTuning& tuning);

}  // namespace plugc::gl

// EGL on Mesa's surfaceless platform, by dlopen: eglGetPlatformDisplay, eglInitialize, eglBindAPI, a context without a
// configuration (EGL_KHR_no_config_context) that is current without a surface (EGL_KHR_surfaceless_context).
// The display belongs to the process and is never terminated: another Renderer may use it.

#include <array>

#include <dlfcn.h>

#include "runtime/gl/context.h"

namespace plugc::gl {
namespace {

using Display = void*;
using EglContext = void*;

constexpr unsigned kSurfacelessPlatform = 0x31DD, kOpenGlApi = 0x30A2;
constexpr int kMajorVersion = 0x3098, kMinorVersion = 0x30FB, kProfileMask = 0x30FD, kCoreProfileBit = 1, kNone = 0x3038;

struct Egl {
  Display (*platform_display)(unsigned platform, void* native, const std::intptr_t* attributes) = nullptr;
  unsigned (*initialize)(Display, int* major, int* minor) = nullptr;
  unsigned (*bind_api)(unsigned api) = nullptr;
  EglContext (*create)(Display, void* configuration, EglContext shared, const int* attributes) = nullptr;
  unsigned (*destroy)(Display, EglContext) = nullptr;
  unsigned (*make_current)(Display, void* draw, void* read, EglContext) = nullptr;
  EglContext (*current)() = nullptr;
  void* (*function)(const char* name) = nullptr;
  Display display = nullptr;
  std::string error;
};

template <typename Function>
void find(void* library, const char* name, Function& function, std::string& error) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) error = std::string("`libEGL.so.1` lacks `") + name + "`";
}

Egl load_egl() {
  Egl egl;
  void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    egl.error = "cannot load `libEGL.so.1`: install the package libegl1";
    return egl;
  }
  find(library, "eglGetPlatformDisplay", egl.platform_display, egl.error);
  find(library, "eglInitialize", egl.initialize, egl.error);
  find(library, "eglBindAPI", egl.bind_api, egl.error);
  find(library, "eglCreateContext", egl.create, egl.error);
  find(library, "eglDestroyContext", egl.destroy, egl.error);
  find(library, "eglMakeCurrent", egl.make_current, egl.error);
  find(library, "eglGetCurrentContext", egl.current, egl.error);
  find(library, "eglGetProcAddress", egl.function, egl.error);
  if (!egl.error.empty()) return egl;
  egl.display = egl.platform_display(kSurfacelessPlatform, nullptr, nullptr);
  if (egl.display == nullptr || egl.initialize(egl.display, nullptr, nullptr) == 0) {
    egl.error = "EGL has no surfaceless display";
  }
  return egl;
}

const Egl& egl() {
  static const Egl library = load_egl();
  return library;
}

class EglDevice : public Context {
 public:
  explicit EglDevice(EglContext context) : context_(context) {}
  EglDevice(const EglDevice&) = delete;
  EglDevice& operator=(const EglDevice&) = delete;
  ~EglDevice() override {
    if (egl().current() == context_) egl().make_current(egl().display, nullptr, nullptr, nullptr);
    egl().destroy(egl().display, context_);
  }

  bool make_current() override {
    if (egl().current() == context_) return true;
    egl().bind_api(kOpenGlApi);  // a setting of the thread
    return egl().make_current(egl().display, nullptr, nullptr, context_) != 0;
  }
  void* function(const char* name) const override { return egl().function(name); }

 private:
  EglContext context_;
};

}  // namespace

std::unique_ptr<Context> make_egl_context(std::string& error) {
  if (!egl().error.empty()) {
    error = egl().error;
    return nullptr;
  }
  egl().bind_api(kOpenGlApi);
  constexpr std::array<int, 7> attributes = {kMajorVersion, 3, kMinorVersion, 3, kProfileMask, kCoreProfileBit, kNone};
  auto* const context = egl().create(egl().display, nullptr, nullptr, attributes.data());
  if (context == nullptr) {
    error = "EGL has no OpenGL 3.3 core profile";
    return nullptr;
  }
  return std::make_unique<EglDevice>(context);
}

}  // namespace plugc::gl

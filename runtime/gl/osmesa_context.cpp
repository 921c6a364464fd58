// OSMesa by dlopen: a machine without it can still build and start plugc. Its header cannot be included beside
// glcorearb.h (it pulls in gl.h), so the five functions and eight numbers that matter stand here.
// Frames are drawn into framebuffer objects; the 4 by 4 buffer exists because OSMesaMakeCurrent wants one.

#include <array>
#include <cstdint>

#include <dlfcn.h>

#include "runtime/gl/context.h"

namespace plugc::gl {
namespace {

using OsMesaContext = struct osmesa_context*;

constexpr int kFormat = 0x22, kRgba = 0x1908, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34, kMajorVersion = 0x36,
              kMinorVersion = 0x37;
constexpr unsigned kUnsignedByte = 0x1401;

struct OsMesa {
  OsMesaContext (*create)(const int* attributes, OsMesaContext shared) = nullptr;
  void (*destroy)(OsMesaContext) = nullptr;
  unsigned char (*make_current)(OsMesaContext, void* buffer, unsigned type, int width, int height) = nullptr;
  OsMesaContext (*current)() = nullptr;
  void* (*function)(const char* name) = nullptr;
  std::string error;
};

template <typename Function>
void find(void* library, const char* name, Function& function, std::string& error) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) error = std::string("`libOSMesa.so.8` lacks `") + name + "`";
}

OsMesa load_osmesa() {
  OsMesa mesa;
  void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    mesa.error = "cannot load `libOSMesa.so.8`: install the package libosmesa6";
    return mesa;
  }
  find(library, "OSMesaCreateContextAttribs", mesa.create, mesa.error);
  find(library, "OSMesaDestroyContext", mesa.destroy, mesa.error);
  find(library, "OSMesaMakeCurrent", mesa.make_current, mesa.error);
  find(library, "OSMesaGetCurrentContext", mesa.current, mesa.error);
  find(library, "OSMesaGetProcAddress", mesa.function, mesa.error);
  return mesa;
}

/// Never unloaded: Mesa's worker threads and exit handlers outlive every context.
const OsMesa& osmesa() {
  static const OsMesa mesa = load_osmesa();
  return mesa;
}

class OsMesaDevice : public Context {
 public:
  explicit OsMesaDevice(OsMesaContext context) : context_(context) {}
  OsMesaDevice(const OsMesaDevice&) = delete;
  OsMesaDevice& operator=(const OsMesaDevice&) = delete;
  ~OsMesaDevice() override {
    if (osmesa().current() == context_) osmesa().make_current(nullptr, nullptr, kUnsignedByte, 0, 0);
    osmesa().destroy(context_);
  }

  bool make_current() override {
    if (osmesa().current() == context_) return true;
    return osmesa().make_current(context_, buffer_.data(), kUnsignedByte, kSide, kSide) != 0;
  }
  void* function(const char* name) const override { return osmesa().function(name); }

 private:
  static constexpr int kSide = 4;
  OsMesaContext context_;
  std::array<std::uint8_t, std::size_t{4} * kSide * kSide> buffer_{};
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context(std::string& error) {
  if (!osmesa().error.empty()) {
    error = osmesa().error;
    return nullptr;
  }
  constexpr std::array<int, 11> attributes = {kFormat,       kRgba, kDepthBits,    24, kProfile, kCoreProfile,
                                              kMajorVersion, 3,     kMinorVersion, 3,  0};
  auto* const context = osmesa().create(attributes.data(), nullptr);
  if (context == nullptr) {
    error = "OSMesa has no OpenGL 3.3 core profile";
    return nullptr;
  }
  return std::make_unique<OsMesaDevice>(context);
}

}  // namespace plugc::gl

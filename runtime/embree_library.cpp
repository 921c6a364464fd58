#ifdef PLUGC_EMBREE

#include "runtime/embree_library.h"

#include <dlfcn.h>

namespace plugc {
namespace {

bool is_there = false;  // outlives all objects

struct Loaded {
  EmbreeLibrary functions;
  std::string error;

  Loaded();
  ~Loaded() { is_there = false; }  // was made after the library's objects, so it goes before them
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;
};

Loaded::Loaded() {
  void* const library = dlopen("libembree3.so.3", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    error = "libembree3.so.3 cannot be loaded (Debian: libembree3-3)";
    return;
  }
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (function == nullptr) error = "libembree3.so.3 has no function " + std::string(name);
  };
#define PLUGC_EMBREE_FUNCTION(name) find(functions.name, #name);
#include "runtime/embree_functions.def"
#undef PLUGC_EMBREE_FUNCTION
  is_there = error.empty();
}

}  // namespace

const EmbreeLibrary* embree_library(std::string& error) {
  static const Loaded loaded;
  error = loaded.error;
  return loaded.error.empty() ? &loaded.functions : nullptr;
}

bool embree_is_there() {
  return is_there;
}

}  // namespace plugc

#endif

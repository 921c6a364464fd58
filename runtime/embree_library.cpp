#ifdef PLUGC_EMBREE

#include "runtime/embree_library.h"

#include <dlfcn.h>

namespace plugc {
namespace {

struct Loaded {
  EmbreeLibrary functions;
  std::string error;
};

Loaded load() {
  Loaded loaded;
  void* const library = dlopen("libembree3.so.3", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    loaded.error = "libembree3.so.3 cannot be loaded (Debian: libembree3-3)";
    return loaded;
  }
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (function == nullptr) loaded.error = "libembree3.so.3 has no function " + std::string(name);
  };
#define PLUGC_EMBREE_FUNCTION(name) find(loaded.functions.name, #name);
#include "runtime/embree_functions.def"
#undef PLUGC_EMBREE_FUNCTION
  return loaded;
}

}  // namespace

const EmbreeLibrary* embree_library(std::string& error) {
  static const Loaded loaded = load();
  error = loaded.error;
  return loaded.error.empty() ? &loaded.functions : nullptr;
}

}  // namespace plugc

#endif

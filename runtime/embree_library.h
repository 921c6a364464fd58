#pragma once
// Embree's functions, looked up when the first ray is traced: a program that traces none does not load the library. Only where
// Embree was there when plugc was built.

#ifdef PLUGC_EMBREE

#include <embree3/rtcore.h>

#include <string>

namespace plugc {

struct EmbreeLibrary {
#define PLUGC_EMBREE_FUNCTION(name) decltype(&::name) name = nullptr;
#include "runtime/embree_functions.def"
#undef PLUGC_EMBREE_FUNCTION
};

/// Null, with `error`, where the machine has no Embree 3. Loaded once a process.
const EmbreeLibrary* embree_library(std::string& error);

/// Whether its functions may be called. Not at the very end of a process: what was made before the library was loaded (a
/// Renderer in a static variable) goes after the library's own objects.
bool embree_is_there();

}  // namespace plugc

#endif

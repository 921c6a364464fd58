#pragma once
// Checks that guard plugc's own invariants. A failed check is a bug in plugc, never a mistake in the input: it aborts.

#include <cstdio>
#include <cstdlib>

#define PLUGC_CHECK(condition, message)                                                                         \
  do {                                                                                                          \
    if (!(condition)) {                                                                                         \
      std::fprintf(stderr, "%s:%d: internal check failed: %s (%s)\n", __FILE__, __LINE__, message, #condition); \
      std::abort();                                                                                             \
    }                                                                                                           \
  } while (false)

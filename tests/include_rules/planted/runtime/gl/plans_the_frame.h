// Planted for the test of the include rules; never compiled.
#include "runtime/gl/objects.h"  // allowed
#include "runtime/render.h"

// Planted for the test of the include rules; never compiled.
#include "../scene/node_table.h"
#include "base/source.h"  // allowed
#include "scene/scene.h"

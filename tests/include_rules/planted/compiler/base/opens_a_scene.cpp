// Planted for the test of the include rules; never compiled.
#include "scene/scene.h"

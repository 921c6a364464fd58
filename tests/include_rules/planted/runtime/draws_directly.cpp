// Planted for the test of the include rules; never compiled.
#include <GL/glcorearb.h>
#include "package/assemble_package.h"
#include "package/package_file.h"  // allowed

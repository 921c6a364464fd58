#pragma once
// Planted for the test of the include rules; never compiled.
#include <glslang/Public/ShaderLang.h>
#include "compile.h"
#include "glsl/edit.h"  // allowed
#include "validate/validate.h"

// How many numbers a value of a slot or of a uniform has.

#include "package/package_file.h"

namespace plugc {

std::uint32_t component_count(PackedValueType type) {
  switch (type) {
    case PackedValueType::bool_:
    case PackedValueType::int_:
    case PackedValueType::float_: return 1;
    case PackedValueType::vec2: return 2;
    case PackedValueType::vec3: return 3;
    case PackedValueType::vec4:
    case PackedValueType::rotation: return 4;
    case PackedValueType::mat3: return 9;
    case PackedValueType::mat4: return 16;
  }
  return 0;
}

std::uint32_t component_count(PackedUniformType type) {
  switch (type) {
    case PackedUniformType::bool_:
    case PackedUniformType::int_:
    case PackedUniformType::float_: return 1;
    case PackedUniformType::vec2:
    case PackedUniformType::ivec2: return 2;
    case PackedUniformType::vec3:
    case PackedUniformType::ivec3: return 3;
    case PackedUniformType::vec4:
    case PackedUniformType::ivec4: return 4;
    case PackedUniformType::mat3: return 9;
    case PackedUniformType::mat4: return 16;
    case PackedUniformType::sampler2D:
    case PackedUniformType::sampler3D:
    case PackedUniformType::samplerCube:
    case PackedUniformType::sampler2DShadow:
    case PackedUniformType::samplerCubeShadow: return 0;
  }
  return 0;
}

}  // namespace plugc

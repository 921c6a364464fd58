#pragma once
// Textures as GLSL sees them.

#include <string_view>

#include "scene/scene.h"

namespace plugc {

/// The type of the sampler that reads such a texture; "" for one that is code alone.
constexpr std::string_view sampler_type(TextureKind kind) {
  constexpr std::string_view kTypes[] = {"sampler2D", "sampler3D", "samplerCube", "sampler2DShadow", "", "samplerCubeShadow"};
  return kTypes[static_cast<std::size_t>(kind)];
}

constexpr bool is_sampler(std::string_view type) {
  return type.find("sampler") != std::string_view::npos;
}

}  // namespace plugc

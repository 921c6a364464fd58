#pragma once
// How large the textures may be that a scene draws for itself.

#include <cstdint>

namespace plugc {

inline constexpr std::uint32_t kMaxRenderedSide = 8'192;          ///< Texels along a side of a RenderedTexture.
inline constexpr std::uint32_t kMaxRenderedCubeSide = 4'096;      ///< The same of a GeneratedCubeMapTexture.
inline constexpr std::uint64_t kMaxRenderedTexels = 1ULL << 27U;  ///< Of all in a scene: 1 GiB with their depths.

}  // namespace plugc

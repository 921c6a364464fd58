#include "package/pack_texture.h"

#include <algorithm>

namespace plugc {

std::unique_ptr<PackedBorder> pack_border(const SceneTexture& texture) {
  const auto shows = [](Wrap wrap) { return wrap == Wrap::clamp_to_border; };
  if (!shows(texture.wrap_s) && !shows(texture.wrap_t) && !shows(texture.wrap_r)) return nullptr;
  const auto part = [&](std::size_t i) { return static_cast<float>(std::clamp(texture.border_color[i], 0.0, 1.0)); };
  if (texture.border_color == decltype(texture.border_color){}) return nullptr;
  return std::make_unique<PackedBorder>(part(0), part(1), part(2), part(3));
}

}  // namespace plugc

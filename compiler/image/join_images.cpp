// All pictures get as many channels as the richest of them has. OpenGL looks at the sides of a cube map from outside and
// counts rows from the top: from a picture that is seen from inside and counts from the bottom, that is half a turn, so the
// texels of a side are written in reverse. The top and the bottom picture need no turn.

#include "image/join_images.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {
namespace {

constexpr std::size_t kTop = 2, kBottom = 3;  // among the faces of a cube

/// A texel with another number of channels: grey spreads to RGB, missing alpha is opaque.
std::array<std::uint8_t, 4> rgba(const std::uint8_t* texel, std::size_t channels) {
  const bool grey = channels < 3;
  const std::uint8_t alpha = channels % 2 == 0 ? texel[channels - 1] : 255;
  return {texel[0], grey ? texel[0] : texel[1], grey ? texel[0] : texel[2], alpha};
}

void append_texel(Image& image, const std::uint8_t* texel, std::size_t channels) {
  const std::array<std::uint8_t, 4> all = rgba(texel, channels);
  if (image.channels < 3) {
    image.pixels.push_back(all[0]);
    if (image.channels == 2) image.pixels.push_back(all[3]);
  } else {
    image.pixels.insert(image.pixels.end(), all.begin(), all.begin() + image.channels);
  }
}

std::uint32_t common_channels(std::span<const Image* const> images) {
  const auto any = [&](auto test) {
    return std::ranges::any_of(images, [&](const Image* image) { return test(image->channels); });
  };
  const bool color = any([](std::uint32_t channels) { return channels >= 3; });
  const bool alpha = any([](std::uint32_t channels) { return channels % 2 == 0; });
  return (color ? 3U : 1U) + (alpha ? 1U : 0U);
}

std::string sizes_problem(std::span<const Image* const> images) {
  for (const Image* image : images) {
    if (image->width != images[0]->width || image->height != images[0]->height)
      return fmt::format("its pictures have different sizes: {} x {} and {} x {}", images[0]->width, images[0]->height,
                         image->width, image->height);
  }
  const std::size_t texels = std::size_t{images[0]->width} * images[0]->height * images.size();
  if (texels > kMaxJoinedTexels) return fmt::format("it has {} texels; plugc joins at most {}", texels, kMaxJoinedTexels);
  return {};
}

/// The images behind one another; `turned(i)` says whether image i gets half a turn.
Image join(std::span<const Image* const> images, auto turned) {
  Image joined;
  joined.width = images[0]->width;
  joined.height = images[0]->height;
  joined.depth = static_cast<std::uint32_t>(images.size());
  joined.channels = common_channels(images);
  for (const Image* image : images) joined.alpha = std::max(joined.alpha, image->alpha);
  const std::size_t count = std::size_t{joined.width} * joined.height;
  if (!images[0]->pixels.empty()) joined.pixels.reserve(count * joined.depth * joined.channels);
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (images[i]->pixels.empty()) continue;  // only facts are wanted
    for (std::size_t texel = 0; texel < count; ++texel) {
      const std::size_t from = turned(i) ? count - 1 - texel : texel;
      append_texel(joined, images[i]->pixels.data() + from * images[i]->channels, images[i]->channels);
    }
  }
  return joined;
}

}  // namespace

DecodedImage volume_of_slices(std::span<const Image* const> slices) {
  if (slices.empty()) return {};
  if (std::string problem = sizes_problem(slices); !problem.empty()) return {{}, std::move(problem)};
  return {join(slices, [](std::size_t) { return false; }), {}};
}

DecodedImage cube_of_faces(std::span<const Image* const> faces) {
  if (std::string problem = sizes_problem(faces); !problem.empty()) return {{}, std::move(problem)};
  if (faces[0]->width != faces[0]->height) return {{}, "its pictures are not square"};
  return {join(faces, [](std::size_t face) { return face != kTop && face != kBottom; }), {}};
}

}  // namespace plugc

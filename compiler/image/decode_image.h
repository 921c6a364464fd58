#pragma once
// What the decoders share. Each fills an Image from bytes, or says in one clause what is wrong with them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "image/image.h"

namespace plugc {

/// An image, or why there is none.
struct DecodedImage {
  std::optional<Image> image;
  std::string problem;
};

DecodedImage decode_png(std::string_view bytes);
/// A PNG of the usual kind (8 bits a channel, no palette, no interlacing) without its pixels, several times faster; nullopt
/// where only decode_png() can tell, among them everything that is broken.
std::optional<Image> scan_png(std::string_view bytes);
DecodedImage decode_jpeg(std::string_view bytes, ImageDetail detail);
/// Pictures, volumes and cube maps in DirectDraw surfaces of 8 bits a channel. Mipmaps are passed over.
DecodedImage decode_dds(std::string_view bytes);
/// The first picture of a GIF.
DecodedImage decode_gif(std::string_view bytes);
DecodedImage decode_bmp(std::string_view bytes);
/// Whether the bytes may be a TGA picture of a kind that is read: the format has no signature, so all others are asked first.
bool is_tga(std::string_view bytes);
DecodedImage decode_tga(std::string_view bytes);

/// Why an image of this size must not be allocated for a file of `file_bytes`, or "". No encoder packs pixels so tightly
/// that a few bytes could stand for gigabytes, so a file that says so is broken or hostile.
std::string size_problem(std::size_t width, std::size_t height, std::size_t channels, std::size_t file_bytes);

void set_size(Image& image, std::size_t width, std::size_t height, std::size_t channels, std::size_t depth = 1);
/// Gives the image its size and zeroed pixels.
void allocate(Image& image, std::size_t width, std::size_t height, std::size_t channels, std::size_t depth = 1);

/// How these pixels use alpha.
AlphaUse alpha_use(const Image& image);

}  // namespace plugc

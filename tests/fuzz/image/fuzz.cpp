// Any bytes decode to an image whose pixels are as many as it says, or to one diagnostic; and to the same without pixels.

#include <cstdint>
#include <cstdlib>

#include "image/image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const plugc::SourceSet sources;
  plugc::Diagnostics diagnostics(sources);
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::optional<plugc::Image> image = plugc::decode_image(bytes, "fuzzed", {}, diagnostics);
  if (image.has_value() == diagnostics.has_errors()) std::abort();
  plugc::Diagnostics of_facts(sources);
  const std::optional<plugc::Image> facts = plugc::decode_image(bytes, "fuzzed", {}, of_facts, plugc::ImageDetail::facts);
  if (facts.has_value() != image.has_value()) std::abort();
  if (!facts && of_facts.all()[0].message != diagnostics.all()[0].message) std::abort();
  if (!image) return 0;
  if (image->pixels.size() != std::size_t{image->width} * image->height * image->depth * image->channels) std::abort();
  if (image->channels < 1 || image->channels > 4) std::abort();
  if (facts->width != image->width || facts->height != image->height || facts->depth != image->depth) std::abort();
  if (facts->channels != image->channels || facts->alpha != image->alpha || !facts->pixels.empty()) std::abort();
  return 0;
}

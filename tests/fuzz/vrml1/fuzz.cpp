// Any bytes behind a VRML 1.0 header.

#include <cstdint>

#include "../classic/check_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string body(reinterpret_cast<const char*>(data), size);
  plugc::read_and_check("#VRML V1.0 ascii\n" + body, plugc::read_vrml1);
  return 0;
}

// Any bytes behind a VRML 2.0 header.

#include <cstdint>

#include "../classic/check_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string body(reinterpret_cast<const char*>(data), size);
  plugc::read_and_check("#VRML V2.0 utf8\n" + body, plugc::read_classic);
  return 0;
}

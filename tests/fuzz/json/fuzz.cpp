// Any bytes as a JSON file.

#include <cstdint>

#include "../classic/check_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plugc::read_and_check(std::string(reinterpret_cast<const char*>(data), size), plugc::read_json);
  return 0;
}

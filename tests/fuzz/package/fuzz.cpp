// The package reader against bytes made to harm. Input that starts with the magic is taken as a package file; any other is
// a list of patches (u16 place, u8 value) to a good package, which reaches deeper. Either way the hash is mended, as an
// attacker would; what then opens must survive being read whole.

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstring>

#include "../../support/package_sample.h"

namespace {

std::vector<std::uint8_t> patched(std::vector<std::uint8_t> bytes, const std::uint8_t* data, std::size_t size) {
  for (std::size_t i = 0; i + 3 <= size; i += 3) {
    const std::size_t place = data[i] | data[i + 1] << 8;
    bytes[plugc::kPackageHeaderBytes + place % (bytes.size() - plugc::kPackageHeaderBytes)] = data[i + 2];
  }
  return bytes;
}

void mend_header(std::vector<std::uint8_t>& bytes) {
  const std::uint64_t size = bytes.size() - plugc::kPackageHeaderBytes;
  const std::uint64_t hash = XXH3_64bits(bytes.data() + plugc::kPackageHeaderBytes, size);
  std::memcpy(bytes.data() + 16, &hash, sizeof hash);
  std::memcpy(bytes.data() + 24, &size, sizeof size);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<std::uint8_t> good = plugc::write_package(plugc::sample_package());
  const bool is_file = size >= plugc::kPackageHeaderBytes && std::memcmp(data, "PLUGPACK", 8) == 0;
  std::vector<std::uint8_t> bytes = is_file ? std::vector<std::uint8_t>(data, data + size) : patched(good, data, size);
  mend_header(bytes);
  const plugc::PackageView view = plugc::open_package(bytes);
  if (view.package == nullptr) return 0;
  plugc::dump_package(*view.package);
  const std::unique_ptr<plugc::PackageT> unpacked(view.package->UnPack());
  plugc::write_package(*unpacked);
  return 0;
}

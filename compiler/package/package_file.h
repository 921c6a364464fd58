#pragma once
// A package as bytes. Depends on base and the schema only: this header and its library are all that the runtime sees.
// Layout: 8 bytes "PLUGPACK", u32 version, u32 zero, u64 XXH3-64 of the buffer, u64 its size, then the FlatBuffer,
// all little-endian. Reading checks, in this order: magic, version, size, hash, FlatBuffers structure, then every index.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "package_generated.h"

namespace plugc {

inline constexpr std::uint32_t kPackageVersion = 1;
inline constexpr std::uint32_t kNoSlot = 0xFFFFFFFF;

/// A verified view of package bytes, or why they are none. Does not own the bytes; copies nothing.
struct PackageView {
  const Package* package = nullptr;
  std::string error;  ///< "content hash differs: the file is damaged", empty when fine.
};
PackageView open_package(std::span<const std::uint8_t> bytes);

/// The package as bytes, header included. Deterministic: equal content gives equal bytes.
std::vector<std::uint8_t> write_package(const PackageT& package);

/// `plugc inspect --dump package`.
std::string dump_package(const Package& package);

}  // namespace plugc

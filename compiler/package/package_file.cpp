// Writing: pack the object API's structs into a FlatBuffer, put the 32-byte header before it. FlatBuffers writes its
// objects in the order in which they are built, so equal content gives equal bytes.
// Reading: the header (magic, version, size), the content hash over the buffer, then FlatBuffers' verifier, which follows
// every offset, then check_package(), which follows every index. Nothing is decoded or copied.
// A hostile buffer may point at the same list many times and so be small but endless. The verifier counts tables, which
// leaves one hole: lists of strings inside tables. StringListBudget closes it before the verifier runs.

#include "package/package_file.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>

#include <cstring>
#include <initializer_list>

namespace plugc {
namespace {

constexpr char kMagic[] = {'P', 'L', 'U', 'G', 'P', 'A', 'C', 'K'};
constexpr std::size_t kAlignment = 16;

struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t zero;
  std::uint64_t hash;
  std::uint64_t size;
};
static_assert(sizeof(Header) == kPackageHeaderBytes);
static_assert(FLATBUFFERS_LITTLEENDIAN, "the header is copied as it lies in memory");

/// The error in a header, or "".
std::string check_header(const Header& header, std::size_t buffer_size) {
  if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0) return "is no plugc package";
  if (header.version != kPackageVersion) {
    return fmt::format("is version {}, this plugc reads version {}", header.version, kPackageVersion);
  }
  if (header.zero != 0) return "header is damaged";
  if (header.size > buffer_size) {
    return fmt::format("is cut short: {} bytes are missing", header.size - buffer_size);
  }
  if (header.size < buffer_size) {
    return fmt::format("has {} bytes behind its end", buffer_size - header.size);
  }
  return {};
}

/// A program or an effect, seen only as far as its lists of strings.
struct StringLists : private flatbuffers::Table {
  /// Adds the strings of all those lists to `count`.
  bool count(flatbuffers::Verifier& verifier, std::initializer_list<flatbuffers::voffset_t> fields, std::size_t& count) const {
    using Strings = flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>;
    if (!VerifyTableStart(verifier)) return false;
    for (const flatbuffers::voffset_t field : fields) {
      const auto* list = VerifyOffset(verifier, field) ? GetPointer<const Strings*>(field) : nullptr;
      if (!verifier.VerifyVector(list)) return false;
      count += list != nullptr ? list->size() : 0;
    }
    return verifier.EndTable();
  }
};

/// Stands in for the root table in a first, narrow pass of the verifier. As no list is shared, the entries of all lists of
/// strings together must fit into the buffer.
struct StringListBudget : private flatbuffers::Table {
  bool Verify(flatbuffers::Verifier& verifier) const {
    std::size_t count = 0;
    return VerifyTableStart(verifier) &&
           add(verifier, Package::VT_PROGRAMS, {PackedProgram::VT_PLUGS_FILLED, PackedProgram::VT_PLUGS_EMPTY}, count) &&
           add(verifier, Package::VT_EFFECTS, {PackedEffect::VT_NEEDS, PackedEffect::VT_OFFERS}, count) && verifier.EndTable();
  }

 private:
  bool add(flatbuffers::Verifier& verifier, flatbuffers::voffset_t field, std::initializer_list<flatbuffers::voffset_t> lists,
           std::size_t& count) const {
    using Owners = flatbuffers::Vector<flatbuffers::Offset<StringLists>>;
    if (!VerifyOffset(verifier, field)) return false;
    const auto* owners = GetPointer<const Owners*>(field);
    if (owners == nullptr || !verifier.VerifyVector(owners)) return false;
    for (const auto* owner : *owners) {
      if (!owner->count(verifier, lists, count)) return false;
      if (!verifier.Verify(0, count * sizeof(flatbuffers::uoffset_t))) return false;
    }
    return true;
  }
};

bool has_valid_structure(std::span<const std::uint8_t> buffer) {
  flatbuffers::Verifier::Options limits;
  limits.max_depth = 8;  // the schema nests four tables
  limits.max_tables = static_cast<flatbuffers::uoffset_t>(buffer.size() / sizeof(flatbuffers::uoffset_t));
  flatbuffers::Verifier strings(buffer.data(), buffer.size(), limits);
  flatbuffers::Verifier all(buffer.data(), buffer.size(), limits);
  return strings.VerifyBuffer<StringListBudget>(PackageIdentifier()) && all.VerifyBuffer<Package>(PackageIdentifier());
}

/// The error in a whole package file, or "".
std::string check_bytes(std::span<const std::uint8_t> bytes) {
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % kAlignment != 0) {
    return fmt::format("lies in memory at no multiple of {} bytes", kAlignment);
  }
  if (bytes.size() < sizeof(Header)) return "is no plugc package";
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  const std::span<const std::uint8_t> buffer = bytes.subspan(sizeof header);
  if (std::string error = check_header(header, buffer.size()); !error.empty()) return error;
  if (XXH3_64bits(buffer.data(), buffer.size()) != header.hash) return "content hash differs: the file is damaged";
  if (buffer.size() >= FLATBUFFERS_MAX_BUFFER_SIZE || !has_valid_structure(buffer)) {
    return "has an invalid structure: no plugc wrote it";
  }
  return check_package(*GetPackage(buffer.data()), buffer.size());
}

}  // namespace

ShapePrograms shape_programs(const PackedShape& shape, std::uint8_t variant) {
  if (variant == 0) {
    return {shape.program(),
            shape.bindings(),
            shape.depth_program(),
            shape.depth_bindings(),
            shape.point_depth_program(),
            shape.point_depth_bindings()};
  }
  const PackedVariant& other = *shape.variants()->Get(variant - 1U);
  return {other.program(),
          other.bindings(),
          other.depth_program(),
          other.depth_bindings(),
          other.point_depth_program(),
          other.point_depth_bindings()};
}

PackageView open_package(std::span<const std::uint8_t> bytes) {
  PackageView view;
  view.error = check_bytes(bytes);
  if (view.error.empty()) view.package = GetPackage(bytes.data() + sizeof(Header));
  return view;
}

std::vector<std::uint8_t> write_package(const PackageT& package) {
  flatbuffers::FlatBufferBuilder builder;
  FinishPackageBuffer(builder, Package::Pack(builder, &package));

  Header header{};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  header.version = kPackageVersion;
  header.hash = XXH3_64bits(builder.GetBufferPointer(), builder.GetSize());
  header.size = builder.GetSize();

  std::vector<std::uint8_t> bytes(sizeof header + builder.GetSize());
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, builder.GetBufferPointer(), builder.GetSize());
  return bytes;
}

}  // namespace plugc

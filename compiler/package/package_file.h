#pragma once
// A package as bytes. Depends on base and the schema only: this header and its library are all that the runtime sees.
// Layout: 8 bytes "PLUGPACK", u32 version, u32 zero, u64 XXH3-64 of the buffer, u64 its size, then the FlatBuffer,
// all little-endian. Reading checks, in this order: magic, version, size, hash, FlatBuffers structure, then every index.
//
// What holds of a package that open_package() returned, so that nobody asks again:
// - every string and list is present, and every enumerator is one of the schema's;
// - every index lies in its list, or is -1 or kNoSlot where the schema has a default; the slot `a` of the sources `slot`,
//   `slot_scaled` and `slot_product` is never kNoSlot; a slot has at least as many numbers as the field that names it reads;
// - no two slots share values, and no two owners a list or a text: all that is named is no more than what the file holds;
// - a program has a target, a target a vertex stage, its stages are in pipeline order, SPIR-V is there where it is due;
// - a binding feeds a sampler from a texture, a map or a picture that is there while it is drawn, and any other uniform from
//   anything else; an array has at most kMaxUniformElements elements;
// - a mesh has its bounds and one position a vertex, its streams lie within the stride and its indices within the vertices;
//   pixels fill their image;
// - a shape has a variant for every combination of its switches;
// - an event node has the slots of its kind; both ends of a route hold as many numbers; routes ascend, by where they
//   start and end; the variables and steps that a script names exist, whatever its steps do;
// - transforms come behind their parents; texels and vertices are aligned to 16 bytes, slot values to 8.
// Numbers themselves (NaN, infinities, a singular scale) are not judged, but for the ranges of levels of detail.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "package_generated.h"

namespace plugc {

inline constexpr std::uint32_t kPackageVersion = 4;
inline constexpr std::uint32_t kNoSlot = 0xFFFFFFFF;
inline constexpr std::size_t kPackageHeaderBytes = 32;

/// A verified view of package bytes, or why they are none. Does not own the bytes; copies nothing.
struct PackageView {
  const Package* package = nullptr;
  std::string error;  ///< "content hash differs: the file is damaged", empty when fine.
};
/// `bytes` must start at a multiple of 16, as a std::vector's do, and must outlive the view.
PackageView open_package(std::span<const std::uint8_t> bytes);

/// The package as bytes, header included. Deterministic: equal content gives equal bytes.
std::vector<std::uint8_t> write_package(const PackageT& package);

/// Why the runtime could not trust this package, with the place ("scene 0, shape 3: ..."), or "". Part of open_package().
/// Requires that FlatBuffers' own verifier has passed the buffer of `buffer_size` bytes that holds it.
std::string check_package(const Package& package, std::size_t buffer_size);

/// Whether maps of that method keep moments of their depths.
constexpr bool keeps_moments(PackedShadowMethod method) {
  return method >= PackedShadowMethod::vsm;
}

/// What a shape is drawn with in one of its states. Points into the package.
struct ShapePrograms {
  std::uint32_t program = 0;
  const flatbuffers::Vector<const PackedBinding*>* bindings = nullptr;
  std::int32_t depth_program = -1;
  const flatbuffers::Vector<const PackedBinding*>* depth_bindings = nullptr;
  std::int32_t point_depth_program = -1;
  const flatbuffers::Vector<const PackedBinding*>* point_depth_bindings = nullptr;  ///< Null: there are none.

  /// Whether it stands in the way of some light: casters under point lights alone have the second depth program only.
  bool casts() const { return depth_program >= 0 || point_depth_program >= 0; }
};
/// `variant` as the shape's `states` have it: 0 for its own programs.
ShapePrograms shape_programs(const PackedShape& shape, std::uint8_t variant);

/// Numbers in one element of a slot: 3 for a vec3.
std::uint32_t component_count(PackedValueType type);
/// Numbers in one element of a uniform; 0 for a sampler.
std::uint32_t component_count(PackedUniformType type);

/// `plugc inspect --dump package`: stable text, one fact a line. Long data is told by its size and hash.
std::string dump_package(const Package& package);

}  // namespace plugc

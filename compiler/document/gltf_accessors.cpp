// An accessor is a strided walk over a buffer view, then a few elements put over it by two more views (glTF 2.0, 5.1). All
// sizes are below 2^31 (gltf_rules.cpp), so their products fit 64 bits. How many numbers one file may unfold to is bounded by
// its bytes: accessors may overlap, and may stand for zeros that are stored nowhere.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "document/gltf_file.h"

namespace plugc {
namespace {

template <typename T>
double read_as(const char* at, bool normalized) {
  T value;
  std::memcpy(&value, at, sizeof value);  // glTF and every machine that plugc runs on are little-endian
  if constexpr (std::is_floating_point_v<T>) return value;
  if (!normalized) return static_cast<double>(value);
  return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
}

double read_component(const char* at, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return read_as<std::int8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return read_as<std::uint8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return read_as<std::int16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return read_as<std::uint16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return read_as<std::uint32_t>(at, normalized);
    default: return read_as<float>(at, normalized);
  }
}

std::size_t component_bytes(int type) {
  return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
}

/// A walk over the elements of a view.
struct Elements {
  std::string_view bytes;
  std::uint64_t offset = 0, stride = 0, count = 0, element_bytes = 0;

  bool fit() const {
    if (count == 0) return true;
    return stride >= element_bytes && offset + (count - 1) * stride + element_bytes <= bytes.size();
  }
  const char* at(std::uint64_t index) const { return bytes.data() + offset + index * stride; }
};

}  // namespace

std::optional<std::vector<double>> GltfFile::numbers(int index) {
  const GltfAt at = item("accessors", index);
  if (!at.valid() || is_refused(at)) return std::nullopt;
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const auto components = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  if (!spend_numbers(accessor, components, at)) return std::nullopt;
  std::vector<double> numbers;
  if (accessor.bufferView < 0) {
    numbers.resize(accessor.count * components);
  } else if (!read_dense(accessor, components, at, numbers)) {
    return std::nullopt;
  }
  if (accessor.sparse.isSparse && !read_sparse(accessor, components, at, numbers)) return std::nullopt;
  replace_odd_floats(numbers, at);
  return numbers;
}

/// glTF 2.0, 3.6.2.2: no number is infinite or NaN.
void GltfFile::replace_odd_floats(std::vector<double>& numbers, GltfAt at) {
  std::size_t odd = 0;
  for (double& number : numbers) {
    if (std::isfinite(number)) continue;
    number = 0;
    ++odd;
  }
  if (odd > 0) text.mistake(at, fmt::format("{} of its numbers are infinite or NaN; each is read as 0", odd));
}

bool GltfFile::spend_numbers(const tinygltf::Accessor& accessor, std::size_t components, GltfAt at) {
  if (accessor.bufferView >= 0) view_bytes(accessor.bufferView);  // so that its buffer's bytes count
  const std::size_t wanted = accessor.count * components;
  if (wanted <= numbers_left_) {
    numbers_left_ -= wanted;
    return true;
  }
  if (!std::exchange(numbers_are_spent_, true)) {
    build.diagnostics.report(
        DiagnosticId::scene_limit, text.place(at),
        fmt::format("`{}`: {} numbers are more than plugc reads from a file of this size", text.path(at), wanted));
  }
  return false;
}

bool GltfFile::read_dense(const tinygltf::Accessor& accessor, std::size_t components, GltfAt at, std::vector<double>& numbers) {
  const auto bytes = view_bytes(accessor.bufferView);
  if (!bytes) return false;
  const std::size_t size = component_bytes(accessor.componentType);
  Elements elements{*bytes, accessor.byteOffset, 0, accessor.count, components * size};
  elements.stride = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
  if (elements.stride == 0) elements.stride = elements.element_bytes;
  if (!elements.fit()) {
    text.mistake(
        at, fmt::format("{} elements of {} bytes, {} bytes apart from byte {} on, do not fit the {} bytes of buffer view {}",
                        elements.count, elements.element_bytes, elements.stride, elements.offset, bytes->size(),
                        accessor.bufferView));
    return false;
  }
  numbers.reserve(accessor.count * components);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      numbers.push_back(read_component(elements.at(i) + c * size, accessor.componentType, accessor.normalized));
    }
  }
  return true;
}

bool GltfFile::read_sparse(const tinygltf::Accessor& accessor, std::size_t components, GltfAt at,
                           std::vector<double>& numbers) {
  const auto& sparse = accessor.sparse;
  const GltfAt written = text.member(at, "sparse");
  const auto index_bytes = view_bytes(sparse.indices.bufferView), value_bytes = view_bytes(sparse.values.bufferView);
  if (!index_bytes || !value_bytes) return false;
  const std::size_t index_size = component_bytes(sparse.indices.componentType);
  const std::size_t size = component_bytes(accessor.componentType);
  const auto count = static_cast<std::uint64_t>(sparse.count);
  const Elements indices{*index_bytes, static_cast<std::uint64_t>(sparse.indices.byteOffset), index_size, count, index_size};
  const Elements values{*value_bytes, static_cast<std::uint64_t>(sparse.values.byteOffset), components * size, count,
                        components * size};
  if (!indices.fit() || !values.fit()) {
    text.mistake(written, fmt::format("{} elements do not fit their buffer views", count));
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    const double index = read_component(indices.at(i), sparse.indices.componentType, false);
    if (!(index >= 0 && index < static_cast<double>(accessor.count))) {
      text.mistake(written, fmt::format("element {} is replaced, but there are {}", index, accessor.count));
      return false;
    }
    for (std::size_t c = 0; c < components; ++c) {
      numbers[static_cast<std::size_t>(index) * components + c] =
          read_component(values.at(i) + c * size, accessor.componentType, accessor.normalized);
    }
  }
  return true;
}

}  // namespace plugc

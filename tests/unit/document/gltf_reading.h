#pragma once
// glTF made in memory, read, and given back as what a test compares.

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "base/data_url.h"
#include "base/file_access.h"
#include "document/read_document.h"
#include "document/read_gltf.h"

namespace plugc {

/// Numbers one behind the other, as bytes.
template <typename T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

inline std::string gltf_data_url(const std::string& bytes) {
  return "data:application/octet-stream;base64," + base64_encode(bytes);
}

/// A triangle: nine floats of positions from byte 0 on, then three indices of 16 bits.
inline std::string triangle_bytes() {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2});
}

/// A file that shows one mesh with one primitive; its buffer holds `bytes`, view 0 all of them. Accessor 0 is positions,
/// accessor 1 indices; `accessors` are those behind, `more` further members of the file.
inline std::string gltf_of(const std::string& primitive, const std::string& more = "", const std::string& accessors = "",
                           const std::string& bytes = triangle_bytes()) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[)" +
         primitive + R"(]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":0,"byteOffset":36,"componentType":5123,"count":3,"type":"SCALAR"})" +
         accessors + R"(],
"bufferViews":[{"buffer":0,"byteLength":)" +
         std::to_string(bytes.size()) + R"(}],"buffers":[{"byteLength":)" + std::to_string(bytes.size()) + R"(,"uri":")" +
         gltf_data_url(bytes) + R"("}])" + more + "}";
}

inline std::string little_endian(std::uint32_t number) {
  return bytes_of<std::uint32_t>({number});
}

inline std::string glb_of(std::string json, const std::string& binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string chunks = little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json +
                             little_endian(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
  return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

struct GltfReading {
  SourceSet sources;
  Diagnostics diagnostics{sources};
  MemoryFiles files;
  Document document;

  explicit GltfReading(std::string bytes, std::map<std::string, std::string> beside = {}) {
    files.files = std::move(beside);
    const SourceId source = sources.add("s.gltf", std::move(bytes));
    document = read_document(source, "s.gltf", files, sources, diagnostics);
  }
  GltfReading(const GltfReading&) = delete;

  /// `line:column message` of each diagnostic.
  std::string messages() const {
    std::string all;
    for (const Diagnostic& one : diagnostics.all()) {
      const Position at = sources.position(one.span.source, one.span.begin);
      all += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + one.message + "\n";
    }
    return all;
  }

  /// The dump without its places and its first line.
  std::string dump() const {
    const std::string dump = dump_document(document, sources);
    std::string text;
    std::size_t at = dump.find('\n') + 1;
    while (at < dump.size()) {
      const std::size_t end = dump.find('\n', at);
      const std::size_t place = dump.find_first_not_of(' ', at);
      const std::size_t words = dump.find(' ', place) + 1;
      text += dump.substr(at, place - at) + dump.substr(words, end + 1 - words);
      at = end + 1;
    }
    return text;
  }

  bool holds(const std::string& line) const { return dump().find(line) != std::string::npos; }
};

inline std::string gltf_messages(const std::string& text) {
  return GltfReading(text).messages();
}

}  // namespace plugc

// The JSON is read twice: into a tree with places, on which every rule is checked, and by the library, which is shown only
// what keeps the rules. The library opens no file and decodes no image: buffers are read here, when something asks for them,
// as any other file that a scene names.

#include "document/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>

#include <fmt/format.h>

#include "base/data_url.h"
#include "base/limits.h"

namespace plugc {
namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kGlbHeaderBytes = 12, kChunkHeaderBytes = 8;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Extensions that are read, and those that change only how a surface glows, reflects or lets light through.
constexpr std::array<std::string_view, 5> kKnownExtensions = {"KHR_lights_punctual", "KHR_materials_unlit",
                                                              "KHR_texture_transform", "KHR_mesh_quantization",
                                                              "KHR_materials_emissive_strength"};

}  // namespace

bool is_gltf(std::string_view bytes, const std::filesystem::path& path) {
  if (bytes.starts_with(kMagic)) return true;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  if (!bytes.starts_with('{') || bytes.find("\"X3D\"") != std::string_view::npos) return false;
  return path.extension() == ".gltf" || bytes.find("\"asset\"") != std::string_view::npos;
}

std::optional<GlbChunks> split_glb(std::string_view bytes, std::string& problem) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  if (bytes.size() < kGlbHeaderBytes + kChunkHeaderBytes) {
    problem = "this .glb file is cut short in its header";
    return std::nullopt;
  }
  if (little_endian(bytes, 4) != 2) {
    problem = fmt::format("this .glb file is of version {}; plugc reads glTF 2.0", little_endian(bytes, 4));
    return std::nullopt;
  }
  GlbChunks chunks;
  for (std::size_t at = kGlbHeaderBytes; at + kChunkHeaderBytes <= bytes.size();) {
    const std::uint32_t length = little_endian(bytes, at), type = little_endian(bytes, at + 4);
    at += kChunkHeaderBytes;
    if (length > bytes.size() - at) {
      problem =
          fmt::format("a chunk of this .glb file has {} bytes, but the file ends after {} of them", length, bytes.size() - at);
      return std::nullopt;
    }
    if (type == kJson && chunks.json.empty()) chunks.json = bytes.substr(at, length);
    if (type == kBinary && chunks.binary.empty()) chunks.binary = bytes.substr(at, length);
    at += (std::size_t{length} + 3) / 4 * 4;
  }
  if (!chunks.json.empty()) return chunks;
  problem = "this .glb file has no chunk of JSON";
  return std::nullopt;
}

GltfFile::GltfFile(const GltfInput& input, FileAccess& files, const SourceSet& sources, Diagnostics& diagnostics)
    : build(input.source, Encoding::gltf, sources, diagnostics), text(build), input_(input), files_(files) {
  constexpr std::size_t kNumbersOfSmallFile = 1'000'000;
  numbers_left_ = kNumbersOfSmallFile + 2 * sources.text(input.source).size() + 2 * input.binary.size();
  if (!text.sound() || !is_version_2()) return;
  report_extensions();
  check_ = check_gltf(text);
  load_model();
  buffers_.resize(text.size(text.member(text.root(), "buffers")));
}

bool GltfFile::is_version_2() {
  const GltfAt version = text.member(text.member(text.root(), "asset"), "version");
  if (!version.valid() || text[version].kind != GltfKind::string || text[version].text.starts_with("2.")) return true;
  build.diagnostics.report(DiagnosticId::encoding_unknown, text.place(version),
                           fmt::format("this is glTF {}; plugc reads glTF 2.0", shown(text[version].text)));
  return false;
}

void GltfFile::report_extensions() {
  const GltfAt required = text.member(text.root(), "extensionsRequired");
  for (std::size_t i = 0; i < text.size(required); ++i) {
    const GltfAt at = text.child(required, i);
    const std::string_view name = text[at].text;
    if (std::ranges::find(kKnownExtensions, name) != kKnownExtensions.end()) continue;
    build.diagnostics.report(
        DiagnosticId::encoding_unknown, text.place(at),
        fmt::format("this file needs the extension `{}`, which plugc does not read; export it without", shown(name)));
  }
}

void GltfFile::load_model() {
  const std::string json = text_for_library(text, check_, build.sources.text(input_.source));
  tinygltf::TinyGLTF library;
  library.SetFsCallbacks({});
  library.RemoveImageLoader();
  std::string problem, warning;
  try {
    readable_ = library.LoadASCIIFromString(&model, &problem, &warning, json.data(), static_cast<unsigned>(json.size()), "",
                                            tinygltf::NO_REQUIRE);
  } catch (const std::exception& exception) {
    problem = exception.what();
  }
  if (readable_) return;
  std::ranges::replace(problem, '\n', ' ');
  text.mistake(text.root(), fmt::format("this file cannot be read: {}", problem));
}

GltfAt GltfFile::item(std::string_view section, int index) const {
  return index < 0 ? GltfAt() : text.item(text.member(text.root(), section), static_cast<std::size_t>(index));
}

std::optional<std::string_view> GltfFile::buffer_bytes(int index) {
  Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
  if (!buffer.loaded) buffer = {true, load_buffer(item("buffers", index))};
  return buffer.bytes;
}

std::optional<std::string_view> GltfFile::load_buffer(GltfAt at) {
  if (is_refused(at)) return std::nullopt;
  const GltfAt uri = text.member(at, "uri");
  std::string_view bytes = input_.binary;
  if (uri.valid()) {
    const std::string_view url = text[uri].text;
    std::optional<std::string> read =
        is_data_url(url) ? data_url_bytes(url) : read_url(files_, url, input_.path, text.place(uri), build.diagnostics);
    if (!read && is_data_url(url)) text.mistake(uri, "this `data:` url holds no readable base64");
    if (!read) return std::nullopt;
    bytes = buffer_texts_.emplace_back(std::move(*read));
    numbers_left_ += 2 * bytes.size();
  }
  const GltfAt length = text.member(at, "byteLength");
  const std::size_t promised = std::stoul(std::string(text[length].text));  // checked to be a whole number
  if (promised <= bytes.size()) return bytes.substr(0, promised);
  text.mistake(length, fmt::format("{} bytes are promised, but there are {}", promised, bytes.size()));
  return std::nullopt;
}

std::optional<std::string_view> GltfFile::view_bytes(int index) {
  const GltfAt at = item("bufferViews", index);
  if (!at.valid() || is_refused(at)) return std::nullopt;
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
  const auto bytes = buffer_bytes(view.buffer);
  if (!bytes) return std::nullopt;
  if (view.byteOffset <= bytes->size() && view.byteLength <= bytes->size() - view.byteOffset) {
    return bytes->substr(view.byteOffset, view.byteLength);
  }
  text.mistake(at, fmt::format("bytes {} to {} are meant, but buffer {} has {}", view.byteOffset,
                               view.byteOffset + view.byteLength, view.buffer, bytes->size()));
  return std::nullopt;
}

}  // namespace plugc

#pragma once
// A glTF file taken apart: its JSON with places, what the library makes of it, and the bytes of its buffers.

#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

#include <tiny_gltf.h>

#include "base/file_access.h"
#include "document/gltf_rules.h"
#include "document/read_gltf.h"

namespace plugc {

/// The chunks of a .glb file; the views point into its bytes.
struct GlbChunks {
  std::string_view json, binary;
};
/// nullopt, with the reason, when the container is broken. Source: glTF 2.0, 4.4.
std::optional<GlbChunks> split_glb(std::string_view bytes, std::string& problem);

struct GltfInput {
  SourceId source;          ///< The JSON.
  std::string_view binary;  ///< The second chunk of a .glb.
  std::filesystem::path path;
};

/// The items of the JSON have the same numbers in the model; refused ones are empty there.
class GltfFile {
 public:
  GltfFile(const GltfInput& input, FileAccess& files, const SourceSet& sources, Diagnostics& diagnostics);

  /// Whether there is a model.
  bool readable() const { return readable_; }

  /// An item of `meshes`, `nodes` and so on.
  GltfAt item(std::string_view section, int index) const;
  bool is_refused(GltfAt at) const { return check_.is_refused(at); }

  /// The bytes of a buffer view; nullopt when it or its buffer is not as it should be, which was reported.
  std::optional<std::string_view> view_bytes(int view);

  /// The elements of an accessor one behind the other, sparse ones put in, normalized ones as fractions; nullopt when they
  /// cannot be had, which was reported.
  std::optional<std::vector<double>> numbers(int accessor);

  DocumentBuilder build;
  GltfText text;
  tinygltf::Model model;

 private:
  struct Buffer {
    bool loaded = false;
    std::optional<std::string_view> bytes;
  };
  bool is_version_2();
  void report_extensions();
  void load_model();
  std::optional<std::string_view> buffer_bytes(int buffer);
  std::optional<std::string_view> load_buffer(GltfAt at);
  void replace_odd_floats(std::vector<double>& numbers, GltfAt at);
  bool spend_numbers(const tinygltf::Accessor& accessor, std::size_t components, GltfAt at);
  bool read_dense(const tinygltf::Accessor& accessor, std::size_t components, GltfAt at, std::vector<double>& numbers);
  bool read_sparse(const tinygltf::Accessor& accessor, std::size_t components, GltfAt at, std::vector<double>& numbers);

  const GltfInput& input_;
  FileAccess& files_;
  GltfCheck check_;
  bool readable_ = false;
  std::vector<Buffer> buffers_;
  std::deque<std::string> buffer_texts_;  // what the buffers view
  std::size_t numbers_left_;
  bool numbers_are_spent_ = false;
};

}  // namespace plugc

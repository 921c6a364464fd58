#pragma once
// The JSON of a glTF file as a tree of values with their places. The library that reads glTF keeps no places; this tree has
// one for every value, so that what is wrong with `meshes[0].primitives[1].attributes.POSITION` is told there.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "document/json_scanner.h"

namespace plugc {

enum class GltfKind : std::uint8_t { null, boolean, number, string, list, object };

struct GltfValue {
  GltfKind kind = GltfKind::null;
  Name key;               ///< In an object.
  Span span;              ///< The whole value.
  std::string_view text;  ///< A number or a word as written, a string without its quotes and escapes.
  std::uint32_t parent = 0;
  Range<GltfValue> items;  ///< Of an object or a list, in the order of the text.
};

/// Names a value of a GltfText. The default value names none; asking for a part of it gives none again.
struct GltfAt {
  std::uint32_t index = UINT32_MAX;
  bool valid() const { return index != UINT32_MAX; }
  friend bool operator==(GltfAt, GltfAt) = default;
};

class GltfText {
 public:
  /// Reads the source of the builder's document. Mistakes in the JSON are reported to the builder.
  explicit GltfText(DocumentBuilder& builder);

  /// Whether it is all there: JSON without a mistake, within the limits.
  bool sound() const { return sound_; }
  /// Not valid when the text is no object.
  GltfAt root() const { return root_; }
  /// Of a key that stands twice the last one, as in the library.
  GltfAt member(GltfAt object, std::string_view key) const;
  GltfAt item(GltfAt list, std::size_t index) const;
  std::size_t size(GltfAt list) const { return list.valid() ? (*this)[list].items.count : 0; }
  GltfAt child(GltfAt at, std::size_t index) const { return {(*this)[at].items.first + static_cast<std::uint32_t>(index)}; }
  const GltfValue& operator[](GltfAt at) const { return values_[at.index]; }

  /// Where a message about the value belongs: a list or an object is shown by its opening bracket.
  Span place(GltfAt at) const;
  /// `meshes[0].primitives`; "" for the root.
  std::string path(GltfAt at) const;
  /// Reports `gltf-invalid` at the value, its path first; after kMaxSyntaxMistakes of them nothing more.
  void mistake(GltfAt at, std::string_view message);

 private:
  GltfValue read_value(std::uint32_t depth);
  Range<GltfValue> read_items(std::uint32_t depth);
  std::string_view read_string(const Span& place);
  bool admit(const Span& place);
  Range<GltfValue> close(std::size_t mark);

  DocumentBuilder& build_;
  JsonScanner scan_;
  OpenLists<GltfValue> open_;
  std::vector<GltfValue> values_;
  GltfAt root_;
  std::size_t count_ = 0;
  std::size_t mistakes_ = 0;
  bool full_ = false;
  bool sound_ = false;
};

}  // namespace plugc

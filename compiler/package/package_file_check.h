#pragma once
// What the checks of a package share. A Place is a chain of (word, index) on the stack, turned into text only when something is
// wrong: a large scene is checked without making a string. Internal to the package room.

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "package/package_file.h"

namespace plugc {

/// Where we are: `scene 0, shape 3, binding 1`.
struct Place {
  const Place* outer = nullptr;
  const char* word = "";
  std::size_t index = 0;
};

std::string to_text(const Place& place);

template <typename Enum>
bool is_enumerator(Enum value) {
  return value <= Enum::MAX;
}

/// An index into a list of `size`, or -1 for none.
inline bool is_index_or_none(std::int32_t index, std::size_t size) {
  return index == -1 || (index >= 0 && static_cast<std::size_t>(index) < size);
}

bool is_aligned(const void* data, std::size_t alignment);

/// The first error, and how many bytes of lists may still be visited: no honest package shares a list or a text between two
/// owners, so all together fit into the buffer, and a small buffer whose lists overlap can keep nobody busy for ever, neither
/// us nor who uploads or copies what they hold.
struct PackageCheck {
  const Package& package;
  std::size_t bytes_left;
  std::string error;

  /// Notes that `what` is wrong at `place`; returns false, so that a check reads `ok || check.fail(...)`.
  bool fail(const Place& place, std::string_view what) {
    error = fmt::format("{}: {}", to_text(place), what);
    return false;
  }

  bool require_index(const Place& place, const char* what, std::size_t index, std::size_t size) {
    return index < size || fail(place, fmt::format("{} {} does not exist, there are {}", what, index, size));
  }

  /// Takes the list's or the text's bytes from those that are left. Every one that `each` does not visit has to be charged.
  template <typename T>
  bool charge(const Place& place, const flatbuffers::Vector<T>& list) {
    const std::size_t bytes = list.size() * flatbuffers::IndirectHelper<T>::element_stride;
    if (bytes > bytes_left) return fail(place, "its list overlaps others");
    bytes_left -= bytes;
    return true;
  }

  /// Calls `function(element, place)` for every element until one returns false.
  template <typename T, typename Function>
  bool each(const Place* outer, const char* word, const flatbuffers::Vector<T>& list, Function function) {
    if (!charge({outer, word, 0}, list)) return false;
    for (flatbuffers::uoffset_t i = 0; i < list.size(); ++i) {
      if (!function(list.Get(i), Place{outer, word, i})) return false;
    }
    return true;
  }
};

/// A scene's lists, at hand for all that points into them.
struct SceneCheck {
  PackageCheck& check;
  const PackedScene& scene;

  /// Numbers that a slot holds; 0 for none.
  std::uint64_t slot_size(std::uint32_t index) const {
    if (index >= scene.slots()->size()) return 0;
    const PackedSlot& slot = *scene.slots()->Get(index);
    return std::uint64_t{slot.count()} * component_count(slot.type());
  }

  /// `field` may name a slot with at least `numbers` numbers, or none.
  bool slot(const Place& place, const char* field, std::uint32_t index, std::uint32_t numbers) {
    return index == kNoSlot || present_slot(place, field, index, numbers);
  }

  bool present_slot(const Place& place, const char* field, std::uint32_t index, std::uint32_t numbers) {
    if (index >= scene.slots()->size())
      return check.fail(place, fmt::format("{} is slot {}, which does not exist", field, index));
    const std::uint64_t held = slot_size(index);
    return held >= numbers ||
           check.fail(place, fmt::format("{} is slot {}, which has {} numbers, not {}", field, index, held, numbers));
  }

  /// Two slots that hold as many numbers.
  bool same_size(const Place& place, std::uint32_t from, std::uint32_t to) {
    if (!present_slot(place, "its start", from, 1) || !present_slot(place, "its end", to, 1)) return false;
    return slot_size(from) == slot_size(to) ||
           check.fail(place, fmt::format("{} numbers lead to {}", slot_size(from), slot_size(to)));
  }

  bool transform(const Place& place, std::int32_t index) {
    return is_index_or_none(index, scene.transforms()->size()) ||
           check.fail(place, fmt::format("transform {} does not exist", index));
  }
};

// Each is true where all is well; else the first mistake is noted in `check`.
bool check_origin(PackageCheck& check, const PackedLineOrigin& origin, const Place& place);
bool check_program(PackageCheck& check, const PackedProgram& program, const Place& place);
bool check_mesh(PackageCheck& check, const PackedMesh& mesh, const Place& place);
bool check_image(PackageCheck& check, const PackedImage& image, const Place& place);
bool check_texture(PackageCheck& check, const PackedTexture& texture, const Place& place);
bool check_scene(PackageCheck& check, const PackedScene& scene, const Place& place);

/// What is drawn with a program, which decides what its uniforms may be fed from.
enum class Drawn : std::uint8_t { shape, moments, blur, screen_effect, screen_effect_with_depth };

/// Of one program: -1 for none, which nothing may feed. `word` names a binding.
bool check_bindings(SceneCheck& scene, Drawn drawn, const char* word, const flatbuffers::Vector<const PackedBinding*>& bindings,
                    std::int32_t program, const Place& place);
/// The code of a node of the kind script, whose slots are checked.
bool check_script(PackageCheck& check, const PackedEventNode& node, const Place& place);
/// Event nodes and routes of the scene, whose slots are checked.
bool check_events(SceneCheck& scene, const Place& place);
/// Rendered textures and screen effects.
bool check_offscreen(SceneCheck& scene, const Place& place);
bool check_shape(SceneCheck& scene, const PackedShape& shape, const Place& place);
/// Meshes whose vertices follow slots.
bool check_live_meshes(SceneCheck& scene, const Place& place);

}  // namespace plugc

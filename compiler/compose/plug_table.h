#pragma once
// The plugs that the template shaders offer, from stdlib_plugs/plugs.tsv.

#include <span>
#include <string_view>
#include <vector>

namespace plugc {

/// Where a plug is called. `lighting` is the fragment stage under Phong shading and the vertex stage under Gouraud.
enum class PlugStage : unsigned char { vertex, geometry, fragment, lighting };
std::string_view to_text(PlugStage stage);

struct PlugParameter {
  bool is_const = false;
  std::string_view direction;  ///< `in` or `inout`.
  std::string_view type;       ///< `samplerT` stands for the sampler of the texture.
  std::string_view name;
  bool keeps_changes = false;  ///< Const, but what a function makes of it counts: the template reads the variable afterwards.
};

struct PlugInfo {
  std::string_view name;
  PlugStage stage = PlugStage::vertex;
  std::string_view signature;  ///< The parameters as text.
  std::vector<PlugParameter> parameters;
  std::string_view replaced_by;  ///< For an old name: the plug to use instead.
  std::string_view when;
};

std::span<const PlugInfo> plug_table();
const PlugInfo* find_plug(std::string_view name);
/// All names, for suggestions.
std::span<const std::string_view> plug_names();

}  // namespace plugc

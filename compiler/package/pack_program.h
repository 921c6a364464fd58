#pragma once
// Validated programs in packed form, and the bindings that feed their uniforms for one shape.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "package/assemble_package.h"

namespace plugc {

/// Source files by their place in the package's list.
class SourceList {
 public:
  SourceList(const SourceSet& sources, std::vector<std::string>& names) : sources_(&sources), names_(&names) {}
  std::vector<PackedLineOrigin> origins(const MappedText& text);
  PackedLineOrigin origin(const Span& span);
  /// Where columns differ from those of the lines that `origins` names.
  std::vector<PackedColumnOrigin> columns(const MappedText& text, const std::vector<PackedLineOrigin>& origins);

 private:
  std::uint32_t index(SourceId source);
  const SourceSet* sources_;
  std::vector<std::string>* names_;
  std::map<std::uint32_t, std::uint32_t> known_;
};

/// A ValidRecipe that has at least one target.
std::unique_ptr<PackedProgramT> pack_program(const ValidRecipe& recipe, std::string name, SourceList& sources);
/// All that makes two programs the same program: targets, stages, texts, and which targets share a uniform.
std::string program_content(const ValidRecipe& recipe);

/// What a shape's bindings refer to, by number in its recipe.
struct BindingContext {
  const Scene& scene;
  const SceneShape& shape;
  const std::vector<std::uint32_t>& package_textures;  ///< By texture of the scene; UINT32_MAX for none.
  int shadow_map = -1;                                 ///< Whose texels the program is drawn over; then `shape` has nothing.
};
/// PackedShape::projected_coords of a shape with a ComposedShader: for the units that some program's vertex stage reads.
std::vector<PackedBinding> pack_projected_coords(const BindingContext& context, std::uint32_t units_read);
std::vector<PackedBinding> pack_bindings(const ValidRecipe& recipe, const BindingContext& context);

}  // namespace plugc

#pragma once
// The depth maps of a scene's lights: their textures, and what each light sees. When they are drawn: update_shadow_map.h.

#include <cstdint>
#include <vector>

#include "base/limits.h"
#include "runtime/binding_readers.h"
#include "runtime/gl/target.h"
#include "runtime/gl/texture.h"
#include "runtime/messages.h"
#include "runtime/tight_fit.h"

namespace plugc {

struct ShadowMap {
  gl::Texture texture;  ///< None when the map is never drawn: whoever reads it is lit. Traced: see traced_shadows.h.
  gl::Framebuffer framebuffer;
  gl::Texture moments, unblurred;  ///< Of a method that keeps moments; the second one is blurred along rows alone.
  gl::Framebuffer moments_target, unblurred_target;
  std::vector<gl::Framebuffer> faces;  ///< Of a point light, in place of `framebuffer`: +x -x +y -y +z -z.
  std::vector<unsigned> read_faces;    ///< Of those: into which some receiver may look. Found with `fit`.
  GLsizei size = 0;
  bool reversed = false;             ///< Stores depths that fall from 1 to 0: nobody but the renderer's own code reads them.
  std::vector<MapReader> readers;    ///< Whose programs look into it.
  bool only_projects = false;        ///< Never drawn, but some shape's texture coordinates are what its light sees.
  bool in_use = false;               ///< In this frame; who looks into one that is not is lit.
  View view;                         ///< What the light sees in the map.
  std::uint64_t drawn_revision = 0;  ///< Of the slots, when it was drawn last; 0: never, or not as it has to be now.
  std::vector<float> drawn_with;     ///< Every number that its content came from.
  TightFit fit;                      ///< Made for these:
  std::uint64_t fitted_revision = 0;
  std::uint64_t fitted_drawings = 0;  ///< Of the textures that the scene draws for itself.
  View fitted_camera;
  FitMemory memory;
  glm::dvec2 shift{0};  ///< Texels that it is moved under the scene: measurements average over several.
};

/// Whether a shape that is there now is drawn with a program that looks into the map.
bool is_looked_into(const ShadowMap& map, const World& world);

/// The view with the map moved by its `shift`.
View shifted(const View& view, const ShadowMap& map);

/// One per PackedShadowMap; no texture for one that the driver or `bytes_left`, of all maps, has no place for: it is reported,
/// as are sizes beyond what can be made. `readers`: as find_binding_readers() gives them, by map.
std::vector<ShadowMap> make_shadow_maps(const gl::Functions& functions, const PackedScene& scene,
                                        std::vector<std::vector<MapReader>> readers, Messages& messages,
                                        std::uint64_t bytes_left = kMaxShadowMapBytes);

/// Whether the map is a cube: that of a point light.
bool is_cube(const PackedScene& scene, const PackedShadowMap& map);

/// How many texels a side map `index` may have.
std::uint32_t largest_map_size(const PackedScene& scene, std::uint32_t index);

/// Makes map `index`, which is drawn, anew with another number of texels a side; the next frame draws it.
void resize_shadow_map(const gl::Functions& functions, const PackedScene& scene, std::uint32_t index, std::uint32_t size,
                       ShadowMap& map, Messages& messages);

/// What draws a shape into the map of a point light, or of another; -1: it casts no shadow there.
std::int32_t depth_program(const ShapePrograms& use, bool of_point_light);
const flatbuffers::Vector<const PackedBinding*>& depth_bindings(const ShapePrograms& use, bool of_point_light);

/// The maps that see what map `index` sees. All of a light that authors see share a frustum: coordinates that the light
/// projects serve each of them.
std::vector<std::uint32_t> maps_in_one_frustum(const PackedScene& scene, std::uint32_t index);

/// The boxes of all casters, and of the shapes that a map in the same frustum shadows or whose texture coordinates its light
/// projects.
FitInput fit_input(const PackedScene& scene, const World& world, std::uint32_t index);

}  // namespace plugc

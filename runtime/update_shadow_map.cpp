// A map's content comes from numbers alone: its projection, the faces of a cube that anybody looks into, the offsets, and for
// each caster its program and its uniforms. They are compared with those of the last time. So a slot that changes costs a pass
// only where a caster, the light, or an effect that moves a caster sees it; what moves together with its light costs none.

#include "runtime/update_shadow_map.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include "runtime/cube_map.h"
#include "runtime/draw_shape.h"
#include "runtime/gl/program.h"
#include "runtime/uniforms.h"

namespace plugc {
namespace {

/// A map that authors see may be looked at where its light does not shine.
bool matters(const LoadedScene& scene, const PackedShadowMap& packed, const ShadowMap& map) {
  if (!map.texture || !is_looked_into(map, scene.world)) return false;
  return packed.author_visible() || shadow_shows(packed, *scene.packed, scene.slots, scene.world);
}

void append(std::vector<float>& numbers, const glm::dmat4& matrix) {
  const glm::mat4 floats(matrix);
  numbers.insert(numbers.end(), glm::value_ptr(floats), glm::value_ptr(floats) + 16);
}

/// That floats tell apart.
constexpr std::uint32_t kVersions = 1U << 24;

/// How often the scene has drawn the textures that casters may read.
std::uint64_t drawings(const LoadedScene& scene) {
  std::uint64_t count = 0;
  for (const RenderedTexture& made : scene.rendered_textures) count += made.times_drawn;
  return count;
}

/// Of one caster: what draw_shape will set, but for the depth range of the pass.
void append_caster(std::vector<float>& numbers, const LoadedScene& scene, const View& light, std::uint32_t index) {
  const ShapePrograms use = scene.programs_of(index);
  const std::int32_t program = depth_program(use, light.all_around);
  const auto& uniforms = *scene.package->programs()->Get(static_cast<std::uint32_t>(program))->uniforms();
  const UniformInputs inputs{.scene = *scene.packed,
                             .slots = scene.slots,
                             .world = scene.world,
                             .view = light,
                             .depth_pass_view = &light,
                             .object_to_world = scene.world.at(scene.shape(index).transform()).matrix};
  numbers.push_back(static_cast<float>(index));
  numbers.push_back(static_cast<float>(program));
  if (const LiveMesh* const live = scene.live_meshes.find(scene.shape(index).mesh()))
    numbers.push_back(static_cast<float>(live->version % kVersions));
  for (const PackedBinding* binding : depth_bindings(use, light.all_around)) {
    const PackedUniform& uniform = *uniforms.Get(binding->uniform());
    const std::vector<float> values = evaluate(*binding, uniform.type(), uniform.count(), inputs);
    numbers.insert(numbers.end(), values.begin(), values.end());
    if (binding->source() == PackedSource::rendered_texture)
      numbers.push_back(static_cast<float>(scene.rendered_textures[binding->a()].times_drawn % kVersions));
  }
}

std::vector<float> content_numbers(const LoadedScene& scene, const PackedShadowMap& packed, const ShadowMap& map) {
  const View& light = map.view;
  std::vector<float> numbers(map.read_faces.begin(), map.read_faces.end());  // the others stay empty
  append(numbers, light.projection);
  numbers.push_back(static_cast<float>(scene.slots.number(packed.scale(), 0)));
  numbers.push_back(static_cast<float>(scene.slots.number(packed.bias(), 0) * map.fit.coarseness));
  if (keeps_moments(packed.method()) || light.all_around) {
    numbers.push_back(static_cast<float>(light.near));
    numbers.push_back(static_cast<float>(light.far));
  }
  for (const std::uint32_t shape : caster_order(scene, light, light.all_around)) append_caster(numbers, scene, light, shape);
  return numbers;
}

std::vector<unsigned> find_read_faces(const ShadowMap& map, const FitInput& input) {
  std::vector<unsigned> faces;
  for (unsigned face = 0; face < map.faces.size(); ++face) {
    if (face_is_read(map.fit.view, face, map.size, input)) faces.push_back(face);
  }
  return faces;
}

/// Equal to the bit: not a number is equal to itself here.
bool are_equal(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) { return x == y || (x != x && y != y); });
}

bool same_view(const View& a, const View& b) {
  return a.world_to_eye == b.world_to_eye && a.projection == b.projection;
}

/// Texels along a side: as many as it could be made with.
std::uint32_t size_of(const LoadedScene& scene, std::uint32_t map) {
  const GLsizei made = scene.shadow_maps[map].size;
  return made > 0 ? static_cast<std::uint32_t>(made) : scene.packed->shadow_maps()->Get(map)->size();
}

void fit(LoadedScene& scene, std::uint32_t index, const View* camera, Messages& messages) {
  ShadowMap& map = scene.shadow_maps[index];
  const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
  LightFrame light = light_frame(*scene.packed, packed, scene.slots, scene.world, messages);
  light.map_size = size_of(scene, index);
  for (const std::uint32_t other : maps_in_one_frustum(*scene.packed, index))
    light.map_size = std::min(light.map_size, size_of(scene, other));
  FitInput input = fit_input(*scene.packed, scene.world, index);
  input.camera = camera;
  const bool matters = packed.author_visible() || !(input.casters.empty() || input.receivers.empty());
  map.fit = map.reversed ? fit_tightly(light, input, map.memory) : TightFit{fit_light(light, input), matters};
  map.read_faces = find_read_faces(map, input);
  map.fitted_revision = scene.slots.revision();
  map.fitted_drawings = drawings(scene);
}

/// Never drawn: only where its light looks from matters.
void update_projection(LoadedScene& scene, std::uint32_t index, Messages& messages) {
  ShadowMap& map = scene.shadow_maps[index];
  if (map.fitted_revision == scene.slots.revision()) return;
  fit(scene, index, nullptr, messages);
  map.view = map.fit.view;
}

}  // namespace

bool update_shadow_map(LoadedScene& scene, std::uint32_t index, const View& camera, Messages& messages) {
  ShadowMap& map = scene.shadow_maps[index];
  const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
  if (packed.method() == PackedShadowMethod::traced) return false;
  if (map.only_projects) update_projection(scene, index, messages);
  map.in_use = matters(scene, packed, map);
  if (!map.in_use) return false;
  const bool follows = packed.update() == PackedShadowUpdate::always;
  const bool drawn = map.drawn_revision != 0;
  const bool stale = map.fitted_revision != scene.slots.revision() || map.fitted_drawings != drawings(scene) ||
                     !same_view(map.fitted_camera, camera);
  if (!drawn || (follows && stale)) {
    fit(scene, index, follows && !camera.all_around ? &camera : nullptr, messages);
    map.fitted_camera = camera;
  }
  map.in_use = map.fit.needed;
  if (drawn && !(follows && stale)) return false;
  if (!follows) map.drawn_revision = scene.slots.revision();  // its one frame is this, also when nothing casts
  if (!map.in_use) return false;
  map.view = shifted(map.fit.view, map);
  std::vector<float> numbers = content_numbers(scene, packed, map);
  const bool changed = !drawn || !are_equal(numbers, map.drawn_with);
  map.drawn_with = std::move(numbers);
  map.drawn_revision = scene.slots.revision();
  return changed;
}

}  // namespace plugc

// Bindings say which uniform takes which value; numbers go to the driver as they are computed, samplers get their texture
// bound to the unit that the program reserved. A sampler that no binding feeds gets a stand-in: an unset one would read
// unit 0, where a texture of another kind may be bound, and that makes the whole draw an error.
// The depth pass draws both faces, also of shapes that cull: of a closed solid the nearer face wins the depth test anyway,
// and an open one casts its shadow from either side.

#include "runtime/draw_shape.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "runtime/gl/mesh.h"
#include "runtime/gl/program.h"
#include "runtime/uniforms.h"

namespace plugc {
namespace {

using Bindings = flatbuffers::Vector<const PackedBinding*>;

constexpr float kMaxLineWidth = 255;

struct BoundTexture {
  GLuint texture = 0;
  GLuint sampler = 0;  ///< 0: the texture's own settings.
};

bool compares(PackedUniformType type) {
  return type == PackedUniformType::sampler2DShadow || type == PackedUniformType::samplerCubeShadow;
}

BoundTexture shadow_texture(LoadedScene& scene, const Pass& pass, const PackedBinding& binding, PackedUniformType type) {
  const ShadowMap& map = scene.shadow_maps[binding.a()];
  const gl::Texture& texture = map.texture;
  const bool drawn = texture && map.in_use && pass.shadows && !pass.depth_only;
  if (scene.packed->shadow_maps()->Get(binding.a())->method() == PackedShadowMethod::traced)
    return {drawn ? texture.id() : scene.resources.stand_in(type).id()};
  const bool cube = gl::texture_target(type) == GL_TEXTURE_CUBE_MAP;
  if (drawn && compares(type) && cube == map.view.all_around) {
    const bool greater = binding.source() == PackedSource::shadow_map_greater;
    return {texture.id(), greater ? scene.resources.greater_sampler().id() : 0};
  }
  const bool picture = type == PackedUniformType::sampler2D || type == PackedUniformType::samplerCube;
  if (drawn && picture && cube == map.view.all_around) return {texture.id(), scene.resources.depth_picture_sampler().id()};
  return {scene.resources.stand_in(type, map.reversed).id()};
}

/// The moments, or what they are made from. A map that is not drawn has none: at a depth plane of zeros, all is lit.
BoundTexture moments_texture(LoadedScene& scene, const Pass& pass, const PackedBinding& binding, PackedUniformType type) {
  const ShadowMap& map = scene.shadow_maps[binding.a()];
  if (type != PackedUniformType::sampler2D) return {scene.resources.stand_in(type).id()};
  const bool drawn = map.moments && map.in_use;
  if (drawn && binding.source() == PackedSource::shadow_depths)
    return {map.texture.id(), scene.resources.depth_texel_sampler().id()};
  if (drawn && binding.source() == PackedSource::shadow_unblurred) return {map.unblurred.id()};
  if (drawn && binding.source() == PackedSource::shadow_moments && pass.shadows && !pass.depth_only) return {map.moments.id()};
  return {scene.resources.stand_in(type).id()};
}

bool is_of_moments(PackedSource source) {
  return source == PackedSource::shadow_moments || source == PackedSource::shadow_depths ||
         source == PackedSource::shadow_unblurred;
}

/// White before it has been drawn, and while it is unless there are two: nobody may read what he draws into.
BoundTexture rendered_texture(LoadedScene& scene, const PackedBinding& binding, PackedUniformType type) {
  const RenderedTexture& made = scene.rendered_textures[binding.a()];
  const bool cube = scene.packed->rendered_textures()->Get(binding.a())->kind() == PackedRenderedKind::cube;
  const bool fits = type == (cube ? PackedUniformType::samplerCube : PackedUniformType::sampler2D);
  const bool can_be_read = made.times_drawn != 0 && (!made.being_drawn || made.next.texture);
  if (fits && can_be_read) return {made.shown.texture.id()};
  return {scene.resources.stand_in(type).id()};
}

/// The picture so far, or its depths, which only an effect that asks for them sees.
BoundTexture screen_texture(LoadedScene& scene, PackedSource source, PackedUniformType type) {
  const ScreenTargets& screen = scene.screen;
  const gl::Texture& texture = source == PackedSource::screen_depth ? screen.depth : screen.colors[screen.shown];
  if (texture && type == PackedUniformType::sampler2D) return {texture.id()};
  return {scene.resources.stand_in(type).id()};
}

BoundTexture find_texture(LoadedScene& scene, const Pass& pass, const PackedBinding& binding, PackedUniformType type,
                          Messages& messages) {
  const bool of_map = binding.source() == PackedSource::shadow_map || binding.source() == PackedSource::shadow_map_greater;
  if (of_map) return shadow_texture(scene, pass, binding, type);
  if (is_of_moments(binding.source())) return moments_texture(scene, pass, binding, type);
  if (binding.source() == PackedSource::rendered_texture) return rendered_texture(scene, binding, type);
  if (binding.source() == PackedSource::screen_color || binding.source() == PackedSource::screen_depth)
    return screen_texture(scene, binding.source(), type);
  if (binding.source() == PackedSource::texture && !compares(type)) {
    return {scene.resources.texture(binding.a(), type, messages).id()};
  }
  return {scene.resources.stand_in(type).id()};
}

void bind_sampler(const gl::Functions& gl, const LoadedUniform& uniform, std::uint32_t element, const BoundTexture& bound) {
  gl::bind_texture(gl, uniform.unit + static_cast<GLint>(element), gl::texture_target(uniform.type), bound.texture,
                   bound.sampler);
}

void set_numbers(const gl::Functions& gl, const LoadedUniform& uniform, const PackedBinding& binding,
                 const UniformInputs& inputs) {
  const std::vector<float> values = evaluate(binding, uniform.type, uniform.count, inputs);
  gl::set_uniform(gl, uniform.location, uniform.type, static_cast<GLsizei>(uniform.count), values);
}

/// Samplers that nothing feeds read a texel of their kind.
void bind_stand_ins(const gl::Functions& gl, const LoadedUniform& uniform, const std::set<GLint>& fed_units,
                    LoadedScene& scene) {
  for (std::uint32_t element = 0; element < uniform.count; ++element) {
    if (fed_units.contains(uniform.unit + static_cast<GLint>(element))) continue;
    bind_sampler(gl, uniform, element, {scene.resources.stand_in(uniform.type).id()});
  }
}

void apply_bindings(const gl::Functions& gl, LoadedScene& scene, const Pass& pass, const LoadedProgram& program,
                    const Bindings& bindings, const UniformInputs& inputs, Messages& messages) {
  std::vector<bool> fed(program.uniforms.size(), false);
  std::set<GLint> fed_units;
  for (const PackedBinding* packed : bindings) {
    const PackedBinding& binding = *packed;
    const LoadedUniform& uniform = program.uniforms[binding.uniform()];
    if (uniform.location < 0) continue;
    fed[binding.uniform()] = true;
    if (gl::is_sampler(uniform.type)) {
      fed_units.insert(uniform.unit + static_cast<GLint>(binding.b()));
      bind_sampler(gl, uniform, binding.b(), find_texture(scene, pass, binding, uniform.type, messages));
    } else {
      set_numbers(gl, uniform, binding, inputs);
    }
  }
  for (std::size_t i = 0; i < program.uniforms.size(); ++i) {
    const LoadedUniform& uniform = program.uniforms[i];
    if (uniform.unit >= 0) {
      bind_stand_ins(gl, uniform, fed_units, scene);
    } else if (!fed[i] && uniform.location >= 0 && !uniform.initial.empty()) {  // another shape of this program may have set it
      gl::set_uniform(gl, uniform.location, uniform.type, static_cast<GLsizei>(uniform.count), uniform.initial);
    }
  }
}

double distance_from_eye(const Box& bounds, const View& view) {
  if (bounds.empty()) return 0;
  const glm::dvec3 seen(view.world_to_eye * glm::dvec4(bounds.center(), 1));
  return is_orthographic(view) ? -seen.z : glm::length(seen);
}

/// Null for the mesh's own: the program reads no attribute of an author's, and no coordinates are projected before the vertex
/// shader (there are none, or no memory for them, or it is a depth pass, which reads none).
const gl::VertexArray* vertex_array_of(const gl::Functions& functions, LoadedScene& scene, const Pass& pass,
                                       std::uint32_t index, std::uint32_t program, const UniformInputs& inputs,
                                       Messages& messages) {
  const PackedShape& shape = scene.shape(index);
  const auto* bindings = shape.projected_coords();
  if (bindings == nullptr || bindings->size() == 0 || pass.depth_only)
    return scene.resources.custom_attributes(shape.mesh(), program);
  const PackedMesh& mesh = *scene.package->meshes()->Get(shape.mesh());
  ProjectedCoords* const coords =
      find_projected_coords(scene.projected_coords, {index, program}, mesh, bindings->size(), messages);
  if (coords == nullptr) return scene.resources.custom_attributes(shape.mesh(), program);
  update_projected_coords(functions, scene.resources.mesh(shape.mesh()), mesh, scene.live_meshes.find(shape.mesh()), *bindings,
                          *scene.package->programs()->Get(program)->attributes(), inputs, *coords);
  return &coords->vertex_array;
}

UniformInputs uniform_inputs(const LoadedScene& scene, const Pass& pass, const glm::dmat4& object_to_world,
                             const PackedWindow* mirror = nullptr) {
  UniformInputs inputs{*scene.packed, scene.slots, scene.world, pass.view, pass.shadow_views};
  if (pass.depth_only) inputs.depth_pass_view = &pass.view;
  inputs.object_to_world = object_to_world;
  inputs.depth_range = pass.depth_range;
  inputs.bound_viewpoint = pass.bound_viewpoint;
  inputs.wearer = pass.wearer;
  inputs.target_size = pass.target_size;
  inputs.mirror = mirror;
  return inputs;
}

const Bindings& bindings_in(const ShapePrograms& use, const Pass& pass) {
  return pass.depth_only ? depth_bindings(use, pass.of_point_light) : *use.bindings;
}

/// By their keys, each looked up once; those with equal keys keep the order of the scene.
template <typename Key>
void sort_by(std::vector<std::uint32_t>& shapes, const Key& key) {
  std::vector<std::pair<decltype(key(0)), std::uint32_t>> keyed;
  keyed.reserve(shapes.size());
  for (const std::uint32_t shape : shapes) keyed.emplace_back(key(shape), shape);
  std::ranges::sort(keyed);
  std::ranges::transform(keyed, shapes.begin(), [](const auto& entry) { return entry.second; });
}

bool may_be_seen(const LoadedScene& scene, std::uint32_t shape, const glm::dmat4& world_to_clip) {
  return !scene.shape(shape).bounds_known() || !outside_sideways(scene.world.shape_bounds[shape], world_to_clip);
}

}  // namespace

bool draw_shape(const gl::Functions& functions, LoadedScene& scene, Pass& pass, std::uint32_t index, Messages& messages) {
  const PackedShape& shape = scene.shape(index);
  const gl::Mesh& mesh = scene.resources.mesh(shape.mesh());
  if (mesh.index_count == 0) return false;
  const ShapePrograms use = scene.programs_of(index);
  const std::uint32_t program_index =
      pass.depth_only ? static_cast<std::uint32_t>(depth_program(use, pass.of_point_light)) : use.program;
  const LoadedProgram& program = scene.programs.get(program_index, messages);
  if (!program.program) return false;
  gl::use_program(functions, program.program);
  const glm::dmat4& placed = scene.world.at(shape.transform()).matrix;
  const bool turns_only = shape.layer() == PackedLayer::backdrop;  // X3D 4.1, 24.2.1
  const glm::dmat4 object_to_world = turns_only ? glm::dmat4(rotation_of(placed)) : placed;
  const UniformInputs inputs = uniform_inputs(scene, pass, object_to_world, shape.mirror());
  apply_bindings(functions, scene, pass, program, bindings_in(use, pass), inputs, messages);
  if (!pass.depth_only) gl::set_draw_state(functions, draw_state_of(shape, scene.slots, object_to_world));
  gl::draw_mesh(functions, mesh, vertex_array_of(functions, scene, pass, index, program_index, inputs, messages));
  pass.programs.insert(program_index);
  return true;
}

bool draw_over_target(const gl::Functions& functions, LoadedScene& scene, Pass& pass, std::uint32_t program_index,
                      const Bindings& bindings, Messages& messages) {
  const LoadedProgram& program = scene.programs.get(program_index, messages);
  if (!program.program) return false;
  gl::use_program(functions, program.program);
  const UniformInputs inputs = uniform_inputs(scene, pass, glm::dmat4(1.0));
  apply_bindings(functions, scene, pass, program, bindings, inputs, messages);
  gl::draw_whole(functions, scene.resources.whole_target());
  pass.programs.insert(program_index);
  return true;
}

gl::DrawState draw_state_of(const PackedShape& shape, const Slots& slots, const glm::dmat4& object_to_world) {
  const bool mirrored = glm::determinant(glm::dmat3(object_to_world)) < 0;
  gl::DrawState state{shape.blended(),   shape.blend_source(),         shape.blend_destination(),
                      shape.cull_back(), shape.front_cw() != mirrored, shape.wireframe()};
  const glm::dvec3 color = slots.vector3(shape.blend_color(), glm::dvec3(1));
  const double alpha = 1 - slots.number(shape.blend_transparency(), 0);
  state.blend_color = {finite_float(color.r), finite_float(color.g), finite_float(color.b), finite_float(alpha)};
  state.line_width = std::clamp(finite_float(slots.number(shape.line_width(), 1)), 1.0F, kMaxLineWidth);
  state.program_sizes_points = shape.sized_points();
  return state;
}

std::vector<std::uint32_t> draw_order(const LoadedScene& scene, const View& view) {
  const glm::dmat4 world_to_clip = view.projection * view.world_to_eye;
  std::vector<std::uint32_t> order;
  std::vector<double> distance(scene.shape_count(), 0);
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) {
    if (scene.shape(i).layer() != PackedLayer::world) continue;
    if (!scene.world.shape_visible[i] || !may_be_seen(scene, i, world_to_clip)) continue;
    distance[i] = scene.shape(i).blended() ? distance_from_eye(scene.world.shape_bounds[i], view) : 0;
    order.push_back(i);
  }
  const auto key = [&](std::uint32_t i) {
    const PackedShape& shape = scene.shape(i);
    const bool blended = shape.blended();
    return std::tuple(blended, -distance[i], blended ? 0 : scene.programs_of(i).program, !blended && shape.cull_back(),
                      !blended && shape.wireframe(), blended ? 0 : shape.mesh());
  };
  sort_by(order, key);
  return order;
}

std::vector<std::uint32_t> caster_order(const LoadedScene& scene, const View& view, bool of_point_light) {
  const glm::dmat4 world_to_clip = view.projection * view.world_to_eye;
  const auto program = [&](std::uint32_t i) { return depth_program(scene.programs_of(i), of_point_light); };
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) {
    if (scene.world.shape_visible[i] && program(i) >= 0 && may_be_seen(scene, i, world_to_clip)) order.push_back(i);
  }
  sort_by(order, [&](std::uint32_t i) { return std::pair(program(i), scene.shape(i).mesh()); });
  return order;
}

}  // namespace plugc

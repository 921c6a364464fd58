// One context for all stages of the process, with one target a size. Whatever the renderer or OpenGL has to say fails the test.

#include "stage.h"

#include <gtest/gtest.h>

#include <map>

#include "runtime/draw_frame.h"
#include "runtime/gl/context.h"
#include "runtime/gl/pass.h"
#include "runtime/projection.h"

namespace plugc {
namespace {

struct FloatTarget {
  gl::Framebuffer framebuffer;
  gl::Renderbuffer color;
  gl::Renderbuffer depth;
};

struct Device {
  std::unique_ptr<gl::Context> context;
  gl::Functions gl;
  std::map<std::uint32_t, FloatTarget> targets;  ///< By side.
};

Device& device() {
  static Device& made = *[] {
    auto* const one = new Device;  // never destroyed: its objects would need a current context
    std::string error;
    one->context = gl::make_context({true, PLUGC_BINARY_DIR "/test_cache/mesa"}, error);
    EXPECT_TRUE(one->context != nullptr && one->context->make_current() && gl::load_functions(*one->context, one->gl, error))
        << error;
    gl::set_context_defaults(one->gl);
    return one;
  }();
  return made;
}

gl::Renderbuffer attach(const gl::Functions& gl, GLenum attachment, GLenum format, GLsizei side) {
  gl::Renderbuffer buffer = gl::generate<gl::Renderbuffer>(gl, gl.GenRenderbuffers);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, side, side);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
  return buffer;
}

FloatTarget& target_of(std::uint32_t side) {
  const gl::Functions& gl = device().gl;
  FloatTarget& target = device().targets[side];
  if (target.framebuffer) return target;
  target.framebuffer = gl::generate<gl::Framebuffer>(gl, gl.GenFramebuffers);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  target.color = attach(gl, GL_COLOR_ATTACHMENT0, GL_RGBA32F, static_cast<GLsizei>(side));
  target.depth = attach(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, static_cast<GLsizei>(side));
  return target;
}

std::vector<glm::dvec3> positions(const PackedMesh& mesh) {
  std::vector<glm::dvec3> points;
  for (const PackedStream* stream : *mesh.streams()) {
    if (stream->semantic() != PackedSemantic::position) continue;
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
      std::array<float, 3> point{};
      std::memcpy(point.data(), mesh.vertices()->data() + std::size_t{i} * mesh.stride() + stream->offset(), sizeof(point));
      points.emplace_back(point[0], point[1], point[2]);
    }
  }
  return points;
}

std::vector<Triangle> triangles_of(const Package& package, const PackedScene& scene, const World& world) {
  std::vector<Triangle> triangles;
  for (std::uint32_t shape = 0; shape < scene.shapes()->size(); ++shape) {
    if (!world.shape_visible[shape]) continue;
    const PackedShape& packed = *scene.shapes()->Get(shape);
    const PackedMesh& mesh = *package.meshes()->Get(packed.mesh());
    std::vector<glm::dvec3> points = positions(mesh);
    for (glm::dvec3& point : points) point = glm::dvec3(world.at(packed.transform()).matrix * glm::dvec4(point, 1));
    const auto& indices = *mesh.indices();
    for (std::uint32_t i = 0; i + 2 < indices.size(); i += 3)
      triangles.push_back({points[indices[i]], points[indices[i + 1]], points[indices[i + 2]]});
  }
  return triangles;
}

/// The only light with a shadow map.
struct Lamp {
  LightFrame frame;
  double cut_off = 0;
  bool spot() const { return frame.kind == PackedLightKind::spot; }
};

Lamp find_lamp(const PackedScene& scene, const Slots& slots, const World& world) {
  Messages ignored;
  const PackedShadowMap& map = *scene.shadow_maps()->Get(0);
  const PackedLight& light = *scene.lights()->Get(map.light());
  return {light_frame(scene, map, slots, world, ignored), slots.number(light.cut_off_angle(), 10)};
}

TruthPixel judge_point(const std::vector<Triangle>& triangles, const Hit& hit, const glm::dvec3& point, const glm::dvec3& ray,
                       const Lamp& lamp, double size) {
  const Triangle& triangle = triangles[hit.triangle];
  glm::dvec3 normal = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
  if (glm::dot(normal, ray) > 0) normal = -normal;
  const glm::dvec3 axis = glm::normalize(lamp.frame.direction);
  const glm::dvec3 way = lamp.spot() ? lamp.frame.location - point : -axis;
  const double distance = lamp.spot() ? glm::length(way) : 1e3 * size;
  const glm::dvec3 to_light = glm::normalize(way);
  TruthPixel pixel;
  pixel.cosine = glm::dot(normal, to_light);
  pixel.counts = pixel.cosine > 0.01 && (!lamp.spot() || glm::dot(-to_light, axis) > std::cos(lamp.cut_off) + 1e-3);
  pixel.lit = !is_blocked(triangles, point, to_light, 1e-5 * size, distance, hit.triangle);
  return pixel;
}

}  // namespace

namespace {

/// What SmallTextures says; one at a time.
struct Limits {
  int side = 0;
  int cube_side = 0;
  decltype(gl::Functions::GetIntegerv) real = nullptr;
};
Limits limits;

void APIENTRY get_limited(GLenum name, GLint* value) {
  limits.real(name, value);
  if (name == GL_MAX_TEXTURE_SIZE) *value = limits.side;
  if (name == GL_MAX_CUBE_MAP_TEXTURE_SIZE) *value = limits.cube_side;
}

}  // namespace

SmallTextures::SmallTextures(int side, int cube_side) {
  gl::Functions& gl = device().gl;
  limits = {side, cube_side, gl.GetIntegerv};
  gl.GetIntegerv = get_limited;
}

SmallTextures::~SmallTextures() {
  device().gl.GetIntegerv = limits.real;
}

IncompleteTargets::IncompleteTargets() : real_(device().gl.CheckFramebufferStatus) {
  device().gl.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_UNSUPPORTED; };
}

IncompleteTargets::~IncompleteTargets() {
  device().gl.CheckFramebufferStatus = real_;
}

struct Stage::Drawn {
  LoadedScene scene;
  Messages messages;
};

Stage::Stage(std::string_view scene, const std::vector<std::string>& dynamic, std::uint32_t side, bool odd) : odd_(odd) {
  CompileOptions options;
  options.dynamic = dynamic;
  compiled_ = compile_text(scene, options);
  frame_.width = frame_.height = side;
  load();
}

Stage::Stage(Compiled compiled) : compiled_(std::move(compiled)) {
  frame_.width = frame_.height = 128;
  load();
}

void Stage::load() {
  said_ = compiled_.messages();
  EXPECT_TRUE(odd_ || said_.empty()) << said_[0];
  drawn_ = std::make_unique<Drawn>();
  drawn_->scene = load_scene(device().gl, *compiled_.package, *compiled_.package->scenes()->Get(0), drawn_->messages);
}

Stage::~Stage() = default;

const PackedScene& Stage::scene() const {
  return *drawn_->scene.packed;
}
const Slots& Stage::slots() const {
  return drawn_->scene.slots;
}
World Stage::world() const {
  return place(*compiled_.package, scene(), slots());
}
View Stage::camera() const {
  Messages ignored;
  return make_camera(scene(), slots(), world(), frame_.viewpoint, 1.0, ignored);
}

void Stage::set(std::string_view field, const std::vector<double>& values) {
  bool found = false;
  for (const PackedSlotName* slot : *scene().slot_names()) {
    if (slot->name()->string_view() != field) continue;
    found = true;
    EXPECT_TRUE(drawn_->scene.slots.set(slot->slot(), values)) << field;
  }
  EXPECT_TRUE(found) << field;
}

FloatPicture Stage::draw(bool shadows) {
  const gl::Functions& gl = device().gl;
  const FloatTarget& target = target_of(frame_.width);
  const auto side = static_cast<GLsizei>(frame_.width);
  frame_.shadows = shadows;
  statistics_ = draw_frame(gl, drawn_->scene, {target.framebuffer, side, side}, frame_, drawn_->messages);
  FloatPicture picture{frame_.width, frame_.height, std::vector<float>(std::size_t{frame_.width} * frame_.height * 4)};
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  gl.ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, picture.values.data());
  for (const std::string& error : gl::take_errors(gl)) ADD_FAILURE() << "OpenGL error " << error;
  for (const std::string& message : drawn_->messages.list()) {
    EXPECT_TRUE(odd_) << message;
    said_.push_back(message);
  }
  drawn_->messages = {};
  return picture;
}

std::vector<double> Stage::visibility() {
  const FloatPicture lit = draw(false);
  const FloatPicture shadowed = draw(true);
  std::vector<double> visible;
  for (std::size_t i = 0; i < lit.values.size(); i += 4) {
    const double most = lit.values[i];
    visible.push_back(most > 1e-4 ? static_cast<double>(shadowed.values[i]) / most : -1);
  }
  return visible;
}

Truth Stage::trace() const {
  const World placed = world();
  const std::vector<Triangle> triangles = triangles_of(*compiled_.package, scene(), placed);
  const View view = camera();
  const Lamp lamp = find_lamp(scene(), slots(), placed);
  const glm::dmat4 to_eye = glm::inverse(view.projection);
  const double size = glm::length(placed.bounds.size());
  Truth truth(std::size_t{frame_.width} * frame_.height);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double x = (static_cast<double>(i % frame_.width) + 0.5) / frame_.width * 2 - 1;
    const double y = (static_cast<double>(i / frame_.width) + 0.5) / frame_.height * 2 - 1;
    const auto unproject = [&](double z) {
      const glm::dvec4 point = to_eye * glm::dvec4(x, y, z, 1);
      return glm::dvec3(view.eye_to_world * glm::dvec4(glm::dvec3(point) / point.w, 1));
    };
    const glm::dvec3 near = unproject(-1);
    const glm::dvec3 ray = unproject(1) - near;
    const auto hit = first_hit(triangles, near, ray, 0, 2);
    if (hit) truth[i] = judge_point(triangles, *hit, near + ray * hit->distance, ray, lamp, size);
  }
  return truth;
}

Verdict Stage::judge(const Truth& truth) {
  const std::vector<double> visible = visibility();
  Verdict verdict;
  double weight = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i].counts || visible[i] < 0) continue;
    ++verdict.pixels;
    weight += truth[i].cosine;
    const bool lit = visible[i] > 0.5;
    if (lit == truth[i].lit) continue;
    (lit ? verdict.false_lit : verdict.false_shadow) += 1;
    verdict.weighted += truth[i].cosine;
  }
  EXPECT_GT(verdict.pixels, 0U);
  verdict.false_lit *= 100.0 / static_cast<double>(verdict.pixels);
  verdict.false_shadow *= 100.0 / static_cast<double>(verdict.pixels);
  verdict.weighted *= 100.0 / weight;
  return verdict;
}

double difference(const Truth& a, const Truth& b) {
  std::size_t counted = 0;
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].counts || !b[i].counts) continue;
    ++counted;
    unlike += a[i].lit != b[i].lit ? 1 : 0;
  }
  return counted == 0 ? 0 : 100.0 * static_cast<double>(unlike) / static_cast<double>(counted);
}

}  // namespace plugc

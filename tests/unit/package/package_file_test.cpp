#include "package/package_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>

#include "tests/support/package_sample.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace plugc {
namespace {

std::string error_of(const std::vector<std::uint8_t>& bytes) {
  return open_package(bytes).error;
}

/// What open_package() says of the sample after `change`.
std::string error_after(const std::function<void(PackageT&)>& change) {
  PackageT package = sample_package();
  change(package);
  return error_of(write_package(package));
}

PackedTransform child_of(std::int32_t parent) {
  return {parent, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kNoSlot, 0};
}

/// Writes the hash that fits the buffer, as somebody who means harm would.
void mend_hash(std::vector<std::uint8_t>& bytes) {
  const std::uint64_t hash = XXH3_64bits(bytes.data() + kPackageHeaderBytes, bytes.size() - kPackageHeaderBytes);
  std::memcpy(bytes.data() + 16, &hash, sizeof hash);
}

TEST(PackageFile, OpensWhatItWrote) {
  const std::vector<std::uint8_t> bytes = write_package(sample_package());
  const PackageView view = open_package(bytes);
  ASSERT_EQ(view.error, "");
  EXPECT_EQ(view.package->programs()->Get(0)->name()->str(), "phong + Fresnel");
  EXPECT_EQ(view.package->scenes()->Get(0)->slot_values()->Get(3), 0.25);
  EXPECT_EQ(view.package->scenes()->Get(0)->shapes()->Get(0)->bindings()->Get(1)->source(), PackedSource::texture);
}

TEST(PackageFile, WritesEqualBytesForEqualContent) {
  EXPECT_EQ(write_package(sample_package()), write_package(sample_package()));
}

TEST(PackageFile, KeepsEveryFieldOverARoundTrip) {
  const std::vector<std::uint8_t> bytes = write_package(sample_package());
  const std::unique_ptr<PackageT> read(open_package(bytes).package->UnPack());
  EXPECT_EQ(write_package(*read), bytes);
}

/// A seed of an older schema would be refused at its first bytes, and the fuzzer would never come deeper.
/// PLUGC_REWRITE=1 writes it anew.
TEST(PackageFile, TheFuzzersSeedIsOfThisSchema) {
  const char* const path = PLUGC_SOURCE_DIR "/tests/fuzz/package/corpus/sample.plugpack";
  const std::vector<std::uint8_t> expected = write_package(sample_package());
  if (std::getenv("PLUGC_REWRITE") != nullptr)
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(expected.data()), std::ssize(expected));
  std::ifstream stream(path, std::ios::binary);
  const std::vector<char> seed(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(std::vector<std::uint8_t>(seed.begin(), seed.end()), expected);
}

TEST(PackageFile, OpensAPackageOfNothingWithEveryListPresent) {
  const std::vector<std::uint8_t> bytes = write_package(PackageT{});
  const PackageView view = open_package(bytes);
  ASSERT_EQ(view.error, "");
  EXPECT_EQ(view.package->scenes()->size(), 0u);
  EXPECT_EQ(view.package->generator()->str(), "");
}

TEST(PackageFile, AlignsVerticesPixelsAndValues) {
  const std::vector<std::uint8_t> bytes = write_package(sample_package());
  const Package& package = *open_package(bytes).package;
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(package.meshes()->Get(0)->vertices()->data()) % 16, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(package.images()->Get(0)->pixels()->data()) % 16, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(package.scenes()->Get(0)->slot_values()->data()) % 8, 0u);
}

TEST(PackageFile, SaysWhatIsWrongWithAHeader) {
  const std::vector<std::uint8_t> good = write_package(sample_package());
  EXPECT_EQ(error_of({}), "is no plugc package");
  EXPECT_EQ(error_of({good.begin(), good.begin() + 31}), "is no plugc package");
  std::vector<std::uint8_t> bytes = good;
  bytes[0] = 'B';
  EXPECT_EQ(error_of(bytes), "is no plugc package");
  bytes = good;
  bytes[8] = 99;
  EXPECT_EQ(error_of(bytes), "is version 99, this plugc reads version 4");
  bytes = good;
  bytes[12] = 1;
  EXPECT_EQ(error_of(bytes), "header is damaged");
  bytes = good;
  bytes.push_back(0);
  EXPECT_EQ(error_of(bytes), "has 1 bytes behind its end");
  bytes.resize(bytes.size() - 5);
  EXPECT_EQ(error_of(bytes), "is cut short: 4 bytes are missing");
}

TEST(PackageFile, NoticesEveryFlippedByte) {
  std::vector<std::uint8_t> bytes = write_package(sample_package());
  for (std::size_t i = kPackageHeaderBytes; i < bytes.size(); ++i) {
    bytes[i] ^= 0x10;
    ASSERT_EQ(error_of(bytes), "content hash differs: the file is damaged") << "byte " << i;
    bytes[i] ^= 0x10;
  }
}

TEST(PackageFile, AsksForAlignedBytes) {
  const std::vector<std::uint8_t> good = write_package(sample_package());
  std::vector<std::uint8_t> shifted(good.size() + 1);
  std::memcpy(shifted.data() + 1, good.data(), good.size());
  EXPECT_EQ(open_package(std::span(shifted).subspan(1)).error, "lies in memory at no multiple of 16 bytes");
}

TEST(PackageFile, RejectsABufferOfNoise) {
  std::vector<std::uint8_t> bytes = write_package(sample_package());
  std::memset(bytes.data() + kPackageHeaderBytes, 0x7E, bytes.size() - kPackageHeaderBytes);
  mend_hash(bytes);
  EXPECT_EQ(error_of(bytes), "has an invalid structure: no plugc wrote it");
}

TEST(PackageFile, ChecksPrograms) {
  EXPECT_EQ(error_after([](PackageT& p) { p.programs[1]->targets.clear(); }), "program 1: it has no target");
  EXPECT_EQ(error_after([](PackageT& p) { p.programs[0]->targets[0]->stages.clear(); }),
            "program 0, target 0: it has no vertex stage");
  EXPECT_EQ(error_after([](PackageT& p) {
              auto& stages = p.programs[0]->targets[0]->stages;
              std::swap(stages[0], stages[1]);
            }),
            "program 0, target 0, stage 1: stages are out of pipeline order");
  EXPECT_EQ(error_after([](PackageT& p) { p.programs[0]->targets[0]->target = PackedTarget::spirv; }),
            "program 0, target 0, stage 0: its SPIR-V does not start with the magic number");
  EXPECT_EQ(error_after([](PackageT& p) { p.programs[0]->targets[0]->stages[0]->origins[1] = PackedLineOrigin(9, 1); }),
            "program 0, target 0, stage 0, origin 1: source 9 does not exist, there are 2");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.programs[0]->targets.push_back(std::make_unique<PackedTargetProgramT>(*p.programs[0]->targets[0]));
            }),
            "program 0, target 1: its target is there twice");
  EXPECT_EQ(error_after([](PackageT& p) { p.programs[0]->uniforms[1]->type = PackedUniformType{99}; }),
            "program 0, uniform 1: its type is unknown");
  for (const std::uint32_t count : {0U, 4097U, 4294967295U}) {
    EXPECT_EQ(error_after([&](PackageT& p) { p.programs[0]->uniforms[1]->count = count; }),
              "program 0, uniform 1: its array has " + std::to_string(count) + " elements");
  }
  EXPECT_EQ(error_after([](PackageT& p) { p.programs[0]->attributes[0]->semantic = PackedSemantic{99}; }),
            "program 0, attribute 0: its semantic is unknown");
}

TEST(PackageFile, ChecksMeshes) {
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->indices[2] = 3; }),
            "mesh 0, index 2: vertex 3 does not exist, there are 3");
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->indices.pop_back(); }), "mesh 0: its last primitive is cut short");
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->vertex_count = 4; }), "mesh 0: its vertices take 60 bytes, not 80");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.meshes[0]->streams[1] = {PackedSemantic::tex_coord, 0, 2, 16};
            }),
            "mesh 0, stream 1: bytes 16 to 24 do not fit into a vertex of 20");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.meshes[0]->streams[1] = {PackedSemantic::tex_coord, 0, 5, 0};
            }),
            "mesh 0, stream 1: it has not 1 to 4 components");
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->bounds_max.reset(); }), "mesh 0: it has no bounds");
}

TEST(PackageFile, ChecksThatVerticesHaveOnePlace) {
  const auto after = [](std::vector<PackedStream> streams) {
    return error_after([&](PackageT& p) { p.meshes[0]->streams = streams; });
  };
  const PackedStream position{PackedSemantic::position, 0, 3, 0}, coord{PackedSemantic::tex_coord, 0, 2, 12};
  EXPECT_EQ(after({coord}), "mesh 0: its vertices have no position");
  EXPECT_EQ(after({position, coord, position}), "mesh 0, stream 2: it is there twice");
  EXPECT_EQ(after({position, coord, coord}), "mesh 0, stream 2: it is there twice");
  EXPECT_EQ(after({position, {PackedSemantic::position, 1, 3, 0}}), "mesh 0, stream 1: only texture coordinates are numbered");
  EXPECT_EQ(after({position, coord, {PackedSemantic::tex_coord, 1, 2, 12}}), "");
}

TEST(PackageFile, ChecksAttributesOfAuthors) {
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->attributes[0]->offset = 20; }),
            "mesh 0, attribute 0: bytes 20 to 24 do not fit into a vertex of 20");
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->attributes[0]->offset = 2; }),
            "mesh 0, attribute 0: bytes 2 to 6 do not fit into a vertex of 20");
  EXPECT_EQ(error_after([](PackageT& p) { p.meshes[0]->attributes[0]->columns = 5; }),
            "mesh 0, attribute 0: it has not 1 to 4 columns of 1 to 4 components");
}

TEST(PackageFile, ChecksClipPlanesAndStyles) {
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->clip_planes = {{7, kSampleRotation, kSampleScalar}};
            }),
            "scene 0, clip plane 0: transform 7 does not exist");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->clip_planes = {{-1, kSampleColor, kSampleScalar}};
            }),
            "scene 0, clip plane 0: plane is slot 0, which has 3 numbers, not 4");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->clip_planes = {{-1, kSampleRotation, kNoSlot}};
            }),
            "scene 0, clip plane 0: enabled is slot 4294967295, which does not exist");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->shapes[0]->bindings[0] = {0, 1, 0, 1, PackedSource::clip_plane};
            }),
            "scene 0, shape 0, binding 0: clip plane 1 does not exist, there are 1");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shapes[0]->line_width = 9; }),
            "scene 0, shape 0: line width is slot 9, which does not exist");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shapes[0]->blend_color = kSampleScalar; }),
            "scene 0, shape 0: blend color is slot 1, which has 1 numbers, not 3");
}

TEST(PackageFile, ChecksImagesAndTextures) {
  EXPECT_EQ(error_after([](PackageT& p) { p.images[0]->height = 4; }), "image 0: its pixels take 18 bytes, not 24");
  EXPECT_EQ(error_after([](PackageT& p) { p.images[0]->depth = 0; }), "image 0: its size 2 x 3 x 0 is out of range");
  EXPECT_EQ(error_after([](PackageT& p) { p.textures[0]->image = 1; }), "texture 0: image 1 does not exist, there are 1");
  EXPECT_EQ(error_after([](PackageT& p) { p.textures[0]->magnification = PackedFilter::linear_mipmap_linear; }),
            "texture 0: its filter is unknown");
}

TEST(PackageFile, ChecksSlots) {
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->slots[2] = {4, 2, PackedValueType::rotation};
            }),
            "scene 0, slot 2: it ends at value 12 of 8");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->slots[2] = {0xFFFFFFFF, 1, PackedValueType::rotation};
            }),
            "scene 0, slot 2: it ends at value 4294967299 of 8");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->slots[1] = {2, 1, PackedValueType::float_};
            }),
            "scene 0, slot 1: it begins at value 2, in the slot before");
  EXPECT_EQ(error_after([](PackageT& p) { std::swap(p.scenes[0]->slots[1], p.scenes[0]->slots[2]); }),
            "scene 0, slot 2: it begins at value 3, in the slot before");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->slot_names[0]->slot = 3; }),
            "scene 0, slot name 0: it is slot 3, which does not exist");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->lights[0]->color = kSampleScalar; }),
            "scene 0, light 0: color is slot 1, which has 1 numbers, not 3");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->background_color = 7; }),
            "scene 0: background color is slot 7, which does not exist");
}

TEST(PackageFile, ChecksThatParentsComeBeforeChildren) {
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->transforms[1] = child_of(1); }),
            "scene 0, transform 1: its parent 1 does not come before it");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->transforms[0] = child_of(-2); }),
            "scene 0, transform 0: its parent -2 does not come before it");
}

TEST(PackageFile, ChecksLevelsOfDetail) {
  const auto after = [](const PackedLodLevel& level) {
    return error_after([&](PackageT& p) { p.scenes[0]->lod_levels = {level}; });
  };
  const std::string place = "scene 0, level of detail 0: ";
  EXPECT_EQ(after({0, 0, 1, std::numeric_limits<double>::infinity()}), "");
  EXPECT_EQ(after({2, 0, 0, 1}), place + "transform 2 does not exist, there are 2");
  EXPECT_EQ(after({0, kNoSlot, 0, 1}), place + "center is slot 4294967295, which does not exist");
  EXPECT_EQ(after({0, kSampleScalar, 0, 1}), place + "center is slot 1, which has 1 numbers, not 3");
  EXPECT_EQ(after({0, 0, 2, 1}), place + "2 to 1 is no range");
  EXPECT_EQ(after({0, 0, -1, 1}), place + "-1 to 1 is no range");
  EXPECT_EQ(after({0, 0, 0, std::nan("")}), place + "0 to nan is no range");
}

TEST(PackageFile, ChecksTheBoundViewpointAndLayers) {
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->bound_viewpoint = -1; }), "");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->bound_viewpoint = 1; }),
            "scene 0: its bound viewpoint 1 does not exist");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->bound_viewpoint = -2; }),
            "scene 0: its bound viewpoint -2 does not exist");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shapes[0]->layer = PackedLayer::backdrop; }), "");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shapes[0]->layer = PackedLayer{9}; }),
            "scene 0, shape 0: its layer is unknown");
}

TEST(PackageFile, ChecksLightsAndShadowMaps) {
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->lights[0]->transform = 2; }),
            "scene 0, light 0: transform 2 does not exist");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shadow_maps[0]->light = 1; }),
            "scene 0, shadow map 0: light 1 does not exist, there are 1");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shadow_maps[0]->size = 0; }),
            "scene 0, shadow map 0: its size 0 is out of range");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shadow_maps[0]->method = PackedShadowMethod{99}; }),
            "scene 0, shadow map 0: its method is unknown");
}

TEST(PackageFile, ChecksThatMapsHaveTheProgramsOfTheirMethod) {
  const auto after = [](PackedShadowMethod method, std::int32_t moments, std::int32_t blur, std::uint32_t size = 512) {
    return error_after([&](PackageT& p) {
      PackedShadowMapT& map = *p.scenes[0]->shadow_maps[0];
      map.method = method;
      map.moments_program = moments;
      map.blur_program = blur;
      map.size = size;
    });
  };
  EXPECT_EQ(after(PackedShadowMethod::vsm, 0, 1), "");
  EXPECT_EQ(after(PackedShadowMethod::vsm, 0, -1), "scene 0, shadow map 0: program -1 does not fit its method");
  EXPECT_EQ(after(PackedShadowMethod::vsm, 2, 1), "scene 0, shadow map 0: program 2 does not fit its method");
  EXPECT_EQ(after(PackedShadowMethod::pcf3, 0, 1), "scene 0, shadow map 0: program 0 does not fit its method");
  EXPECT_EQ(after(PackedShadowMethod::msm, 0, 1, 8192), "scene 0, shadow map 0: its size 8192 is out of range for moments");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->shadow_maps[0]->blur_bindings.emplace_back(0, 0, 0, 1.0F, PackedSource::shadow_unblurred);
            }),
            "scene 0, shadow map 0, blur binding 0: there is no program that it could feed");
}

TEST(PackageFile, ChecksShapes) {
  const auto after = [](const std::function<void(PackedShapeT&)>& change) {
    return error_after([&](PackageT& p) { change(*p.scenes[0]->shapes[0]); });
  };
  EXPECT_EQ(after([](PackedShapeT& s) { s.mesh = 2; }), "scene 0, shape 0: mesh 2 does not exist, there are 2");
  EXPECT_EQ(after([](PackedShapeT& s) { s.program = 2; }), "scene 0, shape 0: program 2 does not exist, there are 2");
  EXPECT_EQ(after([](PackedShapeT& s) { s.depth_program = -2; }), "scene 0, shape 0: depth program -2 does not exist");
  EXPECT_EQ(after([](PackedShapeT& s) { s.depth_program = -1; }),
            "scene 0, shape 0, depth binding 0: there is no program that it could feed");
  EXPECT_EQ(after([](PackedShapeT& s) { s.bounds_min = std::make_unique<PackedVec3>(0, 0, 0); }),
            "scene 0, shape 0: its bounds have one corner alone");
  EXPECT_EQ(after([](PackedShapeT& s) {
              s.projected_coords = {{2, 0, 0, 1, PackedSource::projector_matrix}, {2, 0, 0, 1, PackedSource::projector_matrix}};
            }),
            "scene 0, shape 0, projected coordinates 1: it is out of order");
  EXPECT_EQ(after([](PackedShapeT& s) { s.receives = {1}; }),
            "scene 0, shape 0, receives 0: shadow map 1 does not exist, there are 1");
}

TEST(PackageFile, ChecksThatEveryStateHasPrograms) {
  const auto after = [](const std::function<void(PackedShapeT&)>& change) {
    return error_after([&](PackageT& p) { change(*p.scenes[0]->shapes[0]); });
  };
  EXPECT_EQ(after([](PackedShapeT& s) {
              s.states = {0, 1, 0, 2};
            }),
            "scene 0, shape 0, state 3: variant 2 does not exist, there are 1");
  EXPECT_EQ(after([](PackedShapeT& s) { s.states = {0, 1, 0}; }), "scene 0, shape 0: it has 3 states, not 4");
  EXPECT_EQ(after([](PackedShapeT& s) { s.switches.clear(); }), "scene 0, shape 0: it has 4 states, not 0");
  EXPECT_EQ(after([](PackedShapeT& s) { s.switches.resize(9); }), "scene 0, shape 0: it has 9 switches");
  EXPECT_EQ(after([](PackedShapeT& s) {
              while (s.variants.size() < 256) s.variants.push_back(std::make_unique<PackedVariantT>(*s.variants[0]));
            }),
            "scene 0, shape 0: it has 256 variants");
  EXPECT_EQ(after([](PackedShapeT& s) {
              s.switches[0] = {3, PackedSwitchKind::slot};
            }),
            "scene 0, shape 0, switch 0: it is slot 3, which does not exist");
  EXPECT_EQ(after([](PackedShapeT& s) {
              s.switches[1] = {1, PackedSwitchKind::light};
            }),
            "scene 0, shape 0, switch 1: light 1 does not exist, there are 1");
  EXPECT_EQ(after([](PackedShapeT& s) {
              s.switches[1] = {0, PackedSwitchKind{2}};
            }),
            "scene 0, shape 0, switch 1: its kind is unknown");
}

TEST(PackageFile, ChecksVariantsAsItDoesShapes) {
  const auto after = [](const std::function<void(PackedVariantT&)>& change) {
    return error_after([&](PackageT& p) { change(*p.scenes[0]->shapes[0]->variants[0]); });
  };
  EXPECT_EQ(after([](PackedVariantT& v) { v.program = 2; }),
            "scene 0, shape 0, variant 0: program 2 does not exist, there are 2");
  EXPECT_EQ(after([](PackedVariantT& v) { v.depth_program = 2; }),
            "scene 0, shape 0, variant 0: depth program 2 does not exist");
  EXPECT_EQ(after([](PackedVariantT& v) {
              v.bindings = {{3, 0, 0, 1, PackedSource::slot}};
            }),
            "scene 0, shape 0, variant 0, binding 0: uniform 3 does not exist, there are 3");
  EXPECT_EQ(after([](PackedVariantT& v) { v.depth_bindings = v.bindings; }),
            "scene 0, shape 0, variant 0, depth binding 0: there is no program that it could feed");
}

TEST(PackageFile, ChecksRenderedTextures) {
  const auto texture = [](PackageT& package) -> PackedRenderedTextureT& { return *package.scenes[0]->rendered_textures[0]; };
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).kind = static_cast<PackedRenderedKind>(9); }),
            "scene 0, rendered texture 0: its kind is unknown");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).width = 0; }),
            "scene 0, rendered texture 0: its size 0 x 32 is out of range");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).height = 8193; }),
            "scene 0, rendered texture 0: its size 64 x 8193 is out of range");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).kind = PackedRenderedKind::cube; }),
            "scene 0, rendered texture 0: its size 64 x 32 is out of range");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).viewpoint = 0; }),
            "scene 0, rendered texture 0: viewpoint 0 does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).rendering_slots = {7}; }),
            "scene 0, rendered texture 0, rendering slot 0: it is slot 7, which does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).magnification = PackedFilter::linear_mipmap_linear; }),
            "scene 0, rendered texture 0: its filter is unknown");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).distance_from_shape = 7; }),
            "scene 0, rendered texture 0: distance from shape is slot 7, which does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).viewing_slots = {kSampleColor}; }),
            "scene 0, rendered texture 0, viewing slot 0: it is slot 0, which has 3 numbers, not 16");
  EXPECT_EQ(error_after([&](PackageT& p) { texture(p).projection_slots = {7}; }),
            "scene 0, rendered texture 0, projection slot 0: it is slot 7, which does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) {
              texture(p).loans = {{kSampleScalar, kSampleColor}};
            }),
            "scene 0, rendered texture 0, loan 0: 1 numbers lead to 3");
  EXPECT_EQ(error_after([&](PackageT& p) {
              texture(p).loans.assign(9, {kSampleScalar, kSampleScalar});
            }),
            "scene 0, rendered texture 0, loan 8: more is lent than there is");
  EXPECT_EQ(error_after([](PackageT& p) { p.scenes[0]->shapes[0]->own_scene_of = 1; }),
            "scene 0, shape 0: rendered texture 1 does not exist");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->shapes[0]->bindings = {{2, 1, 0, 1, PackedSource::rendered_texture}};
            }),
            "scene 0, shape 0, binding 0: rendered texture 1 does not exist, there are 1");
}

TEST(PackageFile, ChecksScreenEffects) {
  const auto effect = [](PackageT& package) -> PackedScreenEffectT& { return *package.scenes[0]->screen_effects[0]; };
  EXPECT_EQ(error_after([&](PackageT& p) { effect(p).program = 2; }),
            "scene 0, screen effect 0: program 2 does not exist, there are 2");
  EXPECT_EQ(error_after([&](PackageT& p) { effect(p).enabled = 9; }),
            "scene 0, screen effect 0: enabled is slot 9, which does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) { effect(p).transform = 2; }), "scene 0, screen effect 0: transform 2 does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) {
              effect(p).bindings = {{0, 0, 0, 1, PackedSource::screen_depth}};
            }),
            "scene 0, screen effect 0, binding 0: its source does not fit the uniform `color`");
}

/// Nobody may read what he draws into, or what nobody has drawn.
TEST(PackageFile, ChecksThatWhatIsReadIsThere) {
  const auto of_shape = [](PackedSource source) {
    return error_after([&](PackageT& p) { p.scenes[0]->shapes[0]->bindings = {{2, 0, 0, 1, source}}; });
  };
  for (const PackedSource source :
       {PackedSource::screen_color, PackedSource::screen_depth, PackedSource::shadow_depths, PackedSource::shadow_unblurred})
    EXPECT_EQ(of_shape(source), "scene 0, shape 0, binding 0: its source is not there for what is drawn");
  EXPECT_EQ(of_shape(PackedSource::shadow_map), "");
  const auto of_effect = [](bool needs_depth) {
    return error_after([&](PackageT& p) {
      p.scenes[0]->screen_effects[0]->needs_depth = needs_depth;
      p.scenes[0]->screen_effects[0]->bindings = {{2, 0, 0, 1, PackedSource::screen_depth}};
    });
  };
  EXPECT_EQ(of_effect(true), "");
  EXPECT_EQ(of_effect(false), "scene 0, screen effect 0, binding 0: its source is not there for what is drawn");
  const auto of_map = [](PackedSource of_moments, PackedSource of_blur) {
    return error_after([&](PackageT& p) {
      PackedShadowMapT& map = *p.scenes[0]->shadow_maps[0];
      map.method = PackedShadowMethod::vsm;
      map.moments_program = map.blur_program = 0;
      map.moments_bindings = {{2, 0, 0, 1, of_moments}};
      map.blur_bindings = {{2, 0, 0, 1, of_blur}};
    });
  };
  EXPECT_EQ(of_map(PackedSource::shadow_depths, PackedSource::shadow_unblurred), "");
  EXPECT_EQ(of_map(PackedSource::shadow_unblurred, PackedSource::shadow_unblurred),
            "scene 0, shadow map 0, moments binding 0: its source is not there for what is drawn");
  EXPECT_EQ(of_map(PackedSource::shadow_depths, PackedSource::screen_color),
            "scene 0, shadow map 0, blur binding 0: its source is not there for what is drawn");
}

TEST(PackageFile, ChecksEffectsOfALibrary) {
  const auto after = [](const std::function<void(PackedEffectT&)>& change) {
    return error_after([&](PackageT& p) { change(*p.effects[0]); });
  };
  EXPECT_EQ(after([](PackedEffectT& e) { e.scene = 1; }), "effect 0: scene 1 does not exist, there are 1");
  EXPECT_EQ(after([](PackedEffectT& e) { *e.origin = {2, 1}; }), "effect 0: source 2 does not exist, there are 2");
  EXPECT_EQ(after([](PackedEffectT& e) { e.fields[0]->slot = 3; }), "effect 0, field 0: it is slot 3, which does not exist");
  EXPECT_EQ(after([](PackedEffectT& e) { e.kinds[0]->program = 2; }),
            "effect 0, kind 0: program 2 does not exist, there are 2");
}

TEST(PackageFile, ChecksBindings) {
  const auto after = [](PackedBinding binding) {
    return error_after([&](PackageT& p) { p.scenes[0]->shapes[0]->bindings = {binding}; });
  };
  const std::string place = "scene 0, shape 0, binding 0: ";
  EXPECT_EQ(after({3, 0, 0, 1, PackedSource::slot}), place + "uniform 3 does not exist, there are 3");
  EXPECT_EQ(after({0, 0, 0, 1, PackedSource{200}}), place + "its source is unknown");
  EXPECT_EQ(after({0, 0, 0, 1, PackedSource::texture}), place + "its source does not fit the uniform `color`");
  EXPECT_EQ(after({2, 0, 0, 1, PackedSource::slot}), place + "its source does not fit the uniform `texture0`");
  EXPECT_EQ(after({0, kNoSlot, 0, 1, PackedSource::slot}), place + "a is slot 4294967295, which does not exist");
  EXPECT_EQ(after({0, kSampleScalar, 0, 1, PackedSource::slot}), place + "a is slot 1, which has 1 numbers, not 3");
  EXPECT_EQ(after({2, 1, 0, 1, PackedSource::texture}), place + "texture 1 does not exist, there are 1");
  EXPECT_EQ(after({2, 1, 0, 1, PackedSource::shadow_map}), place + "shadow map 1 does not exist, there are 1");
  EXPECT_EQ(after({0, 1, 0, 1, PackedSource::light_color}), place + "light 1 does not exist, there are 1");
  EXPECT_EQ(after({0, 1, 0, 1, PackedSource::light_on}), place + "light 1 does not exist, there are 1");
  EXPECT_EQ(after({0, kNoSlot, kNoSlot, 1, PackedSource::color_and_transparency}), "");
}

TEST(PackageFile, DumpsOneFactALine) {
  const std::vector<std::uint8_t> bytes = write_package(sample_package());
  const std::string dump = dump_package(*open_package(bytes).package);
  const std::string program_start = "package by `plugc`\nsource 0 ``\nsource 1 `kettle.x3dv`\nprogram 0 `phong + Fresnel`\n";
  EXPECT_EQ(dump.substr(0, program_start.size()), program_start);
  for (const std::string line :
       {"  uniform float weights[4]\n", "  attribute position: position 0\n", "  plugs filled: `texture_color`\n",
        "mesh 0: triangles, 3 vertices of 20 bytes, 3 indices\n  stream position 0: 3 floats at 0\n",
        "  bounds -1 -1 0 to 1 0.5 0\n", "texture 0: image 0, wrap repeat repeat repeat, filter linear_mipmap_linear linear\n",
        "  slot 0: vec3[1] 1 0.5 0\n", "  slot 0 is `Paint.diffuseColor`, the host may change it\n", "    while slot 1 is 2\n",
        "  light 0 `Lamp`: spot, transform -1\n    slots: on -, color 0,",
        "  shape 0 `Kettle`: transform 1, mesh 0, program 0\n", "      color = slot a 0 b 0 scale 1\n", "    depth program 1\n",
        "    switch slot 1\n    switch light 0\n    variants by state 1 0 1 0\n    variant 1: program 1\n",
        "  viewpoint 0 `Front` `from the front`: transform -1\n",
        "  event node 3 script: 1 - -> - 0\n    variable 0, field 1: 0 0 0\n",
        "    function of field 0: steps 0 to 5, value 1, time -\n    step 0: load 1\n",
        "effect 0 `Fresnel`: scene 0, source 1 line 7\n  needs: `fragment_modify`\n  offers: `fresnel_change`\n"
        "  field `power`: slot 1\n  kind `phong`: choice 0, program 0\n"}) {
    EXPECT_NE(dump.find(line), std::string::npos) << line << "is not in\n" << dump;
  }
}

TEST(PackageFile, DumpsNamesWithoutBreakingTheLine) {
  PackageT package;
  package.sources = {"a\nb"};
  const std::vector<std::uint8_t> bytes = write_package(package);
  EXPECT_EQ(dump_package(*open_package(bytes).package), "package by ``\nsource 0 `a\\x0ab`\n");
}

TEST(PackageFile, ChecksScripts) {
  const auto error = [](auto change) { return error_after([&](PackageT& p) { change(*p.scenes[0]->event_nodes.back()); }); };
  const std::string place = "scene 0, event node 3";
  EXPECT_EQ(error([](PackedEventNodeT& n) { n.script = nullptr; }), place + ": it has no script");
  EXPECT_EQ(error([](PackedEventNodeT& n) { n.outputs.pop_back(); }), place + ": it has not the slots of its kind");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.kind = PackedEventKind::boolean_filter;
              n.inputs = {kSampleScalar};
              n.outputs = {kSampleScalar, kNoSlot, kNoSlot};
            }),
            place + ": its kind has no script");
  EXPECT_EQ(error([](PackedEventNodeT& n) { n.script->origin = std::make_unique<PackedLineOrigin>(2, 9); }),
            place + ": source 2 does not exist, there are 2");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.script->variables[2] = {2, 2, 5};
            }),
            place + ", variable 2: its value does not lie in the list, each in a place of its own");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.script->variables[2] = {3, 1, 2};
            }),
            place + ", variable 2: field 2 does not exist");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.script->functions[0] = {0, 3, kNoSlot, 0, 5};
            }),
            place + ", function 0: variable 3 does not exist, there are 3");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.script->functions[0] = {0, 1, kNoSlot, 2, 6};
            }),
            place + ", function 0: its steps do not exist");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.script->steps[3] = {3, 10, PackedScriptOp::store};
            }),
            place + ", step 3: variable 3 does not exist, there are 3");
  EXPECT_EQ(error([](PackedEventNodeT& n) {
              n.script->steps[3] = {0, 10, PackedScriptOp{200}};
            }),
            place + ", step 3: its kind is unknown");
}

TEST(PackageFile, ChecksEvents) {
  const auto node = [](PackageT& p) -> PackedEventNodeT& { return *p.scenes[0]->event_nodes[0]; };
  EXPECT_EQ(error_after([&](PackageT& p) { node(p).kind = PackedEventKind{99}; }),
            "scene 0, event node 0: its kind is unknown");
  EXPECT_EQ(error_after([&](PackageT& p) { node(p).inputs.pop_back(); }),
            "scene 0, event node 0: it has not the slots of its kind");
  EXPECT_EQ(error_after([&](PackageT& p) { node(p).inputs[1] = 9; }),
            "scene 0, event node 0, input 1: it is slot 9, which does not exist");
  EXPECT_EQ(error_after([&](PackageT& p) { node(p).kind = PackedEventKind::interpolate_rotation; }),
            "scene 0, event node 0: output 0 holds 3 numbers, not 4");
  EXPECT_EQ(error_after([&](PackageT& p) { node(p).subject = 0; }), "scene 0, event node 0: its kind has no subject");
  EXPECT_EQ(error_after([&](PackageT& p) {
              node(p).kind = PackedEventKind::camera;
              node(p).inputs.clear();
              node(p).outputs.assign(4, kNoSlot);
              node(p).subject = 4;
            }),
            "scene 0, event node 0: viewpoint 4 does not exist");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->routes[0] = {kSampleColor, 9};
            }),
            "scene 0, route 0: its end is slot 9, which does not exist");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->routes[0] = {kSampleColor, kSampleScalar};
            }),
            "scene 0, route 0: 3 numbers lead to 1");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->routes = {{kSampleScalar, kSampleScalar}, {kSampleColor, kSampleColor}};
            }),
            "scene 0, route 1: it is out of order");
  EXPECT_EQ(error_after([](PackageT& p) {
              p.scenes[0]->routes = {{kSampleColor, kSampleColor}, {kSampleColor, kSampleColor}};
            }),
            "scene 0, route 1: it is out of order");
}

}  // namespace
}  // namespace plugc

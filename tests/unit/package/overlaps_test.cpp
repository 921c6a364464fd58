// A small file whose lists overlap is refused, whichever list it is that many own: else each of its owners would be uploaded,
// compiled or copied with what belongs to another.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "tests/support/package_sample.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace plugc {
namespace {

using TableOf = std::function<const void*(const Package&, flatbuffers::uoffset_t)>;

std::uint8_t* field_of(const void* table, flatbuffers::voffset_t field) {
  auto* const found = static_cast<flatbuffers::Table*>(const_cast<void*>(table));
  return found->GetAddressOf(field);
}

/// What is said of the package where `field` of the second table leads to what that of the first one holds. Tables come in
/// front of what they hold, and later ones in front of earlier ones, so that all offsets stay positive.
std::string error_when_shared(const PackageT& package, const TableOf& table, flatbuffers::voffset_t field) {
  std::vector<std::uint8_t> bytes = write_package(package);
  const Package& written = *GetPackage(bytes.data() + kPackageHeaderBytes);
  const std::uint8_t* const first = field_of(table(written, 0), field);
  std::uint8_t* const second = field_of(table(written, 1), field);
  const std::uint8_t* const target = first + flatbuffers::ReadScalar<flatbuffers::uoffset_t>(first);
  flatbuffers::WriteScalar(second, static_cast<flatbuffers::uoffset_t>(target - second));
  const std::uint64_t hash = XXH3_64bits(bytes.data() + kPackageHeaderBytes, bytes.size() - kPackageHeaderBytes);
  std::memcpy(bytes.data() + 16, &hash, sizeof hash);
  return open_package(bytes).error;
}

constexpr std::size_t kMany = 100'000;

TEST(OverlappingLists, OfVerticesAndPixelsAreRefused) {
  PackageT package = sample_package();
  package.meshes.resize(1);
  package.scenes[0]->live_meshes.clear();
  package.meshes.push_back(std::make_unique<PackedMeshT>(sample_mesh()));
  for (const auto& mesh : package.meshes) mesh->vertex_count = kMany / mesh->stride;
  package.meshes[0]->vertices.resize(kMany);
  package.meshes[1]->vertices.clear();
  EXPECT_EQ(
      error_when_shared(
          package, [](const Package& p, flatbuffers::uoffset_t i) { return p.meshes()->Get(i); }, PackedMesh::VT_VERTICES),
      "mesh 1: its list overlaps others");
  package = sample_package();
  package.images.push_back(std::make_unique<PackedImageT>(sample_image()));
  for (const auto& image : package.images) image->width = image->height = image->channels * 50;
  package.images[0]->pixels.resize(std::size_t{150} * 150 * 3);
  EXPECT_EQ(error_when_shared(
                package, [](const Package& p, flatbuffers::uoffset_t i) { return p.images()->Get(i); }, PackedImage::VT_PIXELS),
            "image 1: its list overlaps others");
}

const PackedStage* first_stage(const Package& package, flatbuffers::uoffset_t program) {
  return package.programs()->Get(program)->targets()->Get(0)->stages()->Get(0);
}

TEST(OverlappingLists, OfStagesAreRefused) {
  const auto error = [](const std::function<void(PackedStageT&)>& fill, flatbuffers::voffset_t field) {
    PackageT package = sample_package();
    PackedStageT& stage = *package.programs[0]->targets[0]->stages[0];
    stage.columns = {{1, 1, 1}};
    package.programs[1]->targets[0]->stages[0]->columns = stage.columns;
    fill(stage);
    return error_when_shared(package, first_stage, field);
  };
  const std::string refused = "program 1, target 0, stage 0: its list overlaps others";
  EXPECT_EQ(error([](PackedStageT& stage) { stage.text.resize(kMany, ' '); }, PackedStage::VT_TEXT), refused);
  EXPECT_EQ(error([](PackedStageT& stage) { stage.spirv.resize(kMany); }, PackedStage::VT_SPIRV), refused);
  EXPECT_EQ(error([](PackedStageT& stage) { stage.columns.resize(kMany); }, PackedStage::VT_COLUMNS), refused);
}

const PackedUniform* second_uniform(const Package& package, flatbuffers::uoffset_t program) {
  return package.programs()->Get(program)->uniforms()->Get(1);
}

TEST(OverlappingLists, OfUniformsAreRefused) {
  PackageT package = sample_package();
  for (const auto& program : package.programs) program->uniforms[1]->count = 4096;
  package.programs[0]->uniforms[1]->initial.resize(4096);
  EXPECT_EQ(error_when_shared(package, second_uniform, PackedUniform::VT_INITIAL),
            "program 1, uniform 1: its list overlaps others");
  package.programs[0]->uniforms[1]->name.resize(kMany, 'x');
  EXPECT_EQ(error_when_shared(package, second_uniform, PackedUniform::VT_NAME),
            "program 1, uniform 1: its list overlaps others");
}

TEST(OverlappingLists, OfSlotValuesAreRefused) {
  PackageT package = sample_package();
  package.scenes.push_back(std::make_unique<PackedSceneT>(sample_scene()));
  package.scenes[0]->slot_values.resize(kMany);
  EXPECT_EQ(
      error_when_shared(
          package, [](const Package& p, flatbuffers::uoffset_t i) { return p.scenes()->Get(i); }, PackedScene::VT_SLOT_VALUES),
      "scene 1: its list overlaps others");
}

}  // namespace
}  // namespace plugc

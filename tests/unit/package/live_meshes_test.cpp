// What is checked of meshes that follow slots, and of what is bound, when a package is opened.

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "support/package_sample.h"

namespace plugc {
namespace {

std::string mistake_after(const std::function<void(PackedLiveMeshT&, PackedSceneT&)>& change) {
  PackageT package = sample_package();
  change(*package.scenes[0]->live_meshes[0], *package.scenes[0]);
  return open_package(write_package(package)).error;
}

std::string mistake_of(const std::function<void(PackedLiveMeshT&)>& change) {
  return mistake_after([&](PackedLiveMeshT& live, PackedSceneT&) { change(live); });
}

std::string mistake_of_events(const std::function<void(std::vector<std::unique_ptr<PackedEventNodeT>>&)>& change) {
  return mistake_after([&](PackedLiveMeshT&, PackedSceneT& scene) { change(scene.event_nodes); });
}

TEST(LiveMeshFile, FollowsSlotsThatHoldAllItsElements) {
  EXPECT_EQ(mistake_of([](PackedLiveMeshT&) {}), "");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.mesh = 2; }),
            "scene 0, live mesh 0: mesh 2 does not exist, there are 2");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.feeds[0]->semantic = PackedSemantic::color; }),
            "scene 0, live mesh 0, feed 0: its mesh has no such stream");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.feeds[0]->width = 0; }),
            "scene 0, live mesh 0, feed 0: its elements have no numbers");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.feeds[0]->slot = kSampleScalar; }),
            "scene 0, live mesh 0, feed 0: it is slot 1, which has 1 numbers, not 3");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.feeds[0]->elements[1] = 1; }),
            "scene 0, live mesh 0, feed 0, element 1: number 1 does not exist, there are 1");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.feeds[0]->elements.pop_back(); }),
            "scene 0, live mesh 0, feed 0: 2 entries are for 3 vertices");
  EXPECT_EQ(mistake_after([](PackedLiveMeshT& live, PackedSceneT& scene) {
              scene.live_meshes.push_back(std::make_unique<PackedLiveMeshT>(live));
            }),
            "scene 0, live mesh 1: it is out of order");
}

TEST(LiveMeshFile, MakesNormalsOfFacesThatAreThere) {
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.normals->face_ends = {4}; }),
            "scene 0, live mesh 0, face 0: it cannot end at corner 4");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) {
              live.normals->face_ends = {2, 1, 3};
            }),
            "scene 0, live mesh 0, face 1: it cannot end at corner 1");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.normals->face_ends = {2}; }),
            "scene 0, live mesh 0: its last corners are in no face");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.normals->corners[0] = 3; }),
            "scene 0, live mesh 0, corner 0: vertex 3 does not exist, there are 3");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.normals->vertex_faces[2] = 1; }),
            "scene 0, live mesh 0, face of vertex 2: number 1 does not exist, there are 1");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.normals->vertex_points[2] = UINT32_MAX; }),
            "scene 0, live mesh 0, place of vertex 2: number 4294967295 does not exist, there are 3");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.mesh = 0; }), "scene 0, live mesh 0: its mesh has no normals");
}

TEST(LiveMeshFile, LaysCoordinatesAndTangentsWhereThereAreAny) {
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) {
              live.box_coords = {{1, PackedBoxLayout::all_sides}};
            }),
            "scene 0, live mesh 0, box coordinates 0: its mesh has no such coordinates");
  EXPECT_EQ(mistake_of([](PackedLiveMeshT& live) { live.tangent_unit = 1; }),
            "scene 0, live mesh 0: its mesh has not what tangents need");
}

TEST(BindingsFile, AreChecked) {
  EXPECT_EQ(mistake_of_events([](auto& nodes) { nodes[1]->outputs.pop_back(); }),
            "scene 0, event node 1: it has not the slots of its kind");
  EXPECT_EQ(mistake_of_events([](auto& nodes) { nodes[1]->subject = 1; }),
            "scene 0, event node 1: node 1 of the stack does not exist");
  EXPECT_EQ(mistake_of_events([](auto& nodes) { nodes[2]->inputs.resize(1); }),
            "scene 0, event node 2: it has not the slots of its kind");
  EXPECT_EQ(mistake_of_events([](auto& nodes) { nodes[2]->inputs[2] = kSampleScalar; }),
            "scene 0, event node 2: choice 2 has 1 numbers, not 3");
  EXPECT_EQ(mistake_after([](PackedLiveMeshT&, PackedSceneT& scene) { scene.bound_viewpoint_now = 7; }),
            "scene 0: bound viewpoint is slot 7, which does not exist");
}

}  // namespace
}  // namespace plugc

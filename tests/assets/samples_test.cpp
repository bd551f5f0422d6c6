// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "assets/make/sample_meshes.h"
#include "assets/make/sample_scenes.h"
#include "core/files/mesh_io.h"
#include "core/scene/scene_io.h"
#include "tests/support/mesh_measures.h"

namespace foldless {
namespace {

const std::filesystem::path kAssets = FOLDLESS_ASSETS_DIR;
constexpr std::string_view kMethods[] = {"foldless", "paper", "paper-flip", "paper-noflip"};

std::set<std::string> stems_in(const std::filesystem::path& folder) {
  std::set<std::string> stems;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    stems.insert(entry.path().stem().string());
  return stems;
}

double largest_difference(const Points& a, const Points& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

void expect_same_motion(const Scene& file, const Scene& made) {
  ASSERT_EQ(file.animation == nullptr, made.animation == nullptr);
  if (!made.animation) return;
  ASSERT_EQ(file.animation->cycle, made.animation->cycle);
  for (int frame = 0; frame <= made.animation->cycle.frames; ++frame) {
    const auto of_file = handles_at(*file.animation, file.handles, frame);
    const auto of_made = handles_at(*made.animation, made.handles, frame);
    for (std::size_t i = 0; i < of_made.size(); ++i)
      EXPECT_LT((of_file[i].target - of_made[i].target).norm(), 1e-9) << frame;
  }
}

TEST(SampleMeshes, FilesAreWhatTheMakerMakes) {
  std::set<std::string> names;
  for (const samples::SampleMesh& mesh : samples::sample_meshes()) {
    SCOPED_TRACE(mesh.name);
    names.insert(mesh.name);
    const LoadedMesh file = read_mesh(kAssets / "meshes" / (mesh.name + ".obj"));
    EXPECT_TRUE(file.notices.empty());
    EXPECT_EQ(file.triangles, mesh.shape.triangles);
    ASSERT_EQ(file.points.cols(), mesh.shape.rest.cols());
    EXPECT_LT(largest_difference(file.points, mesh.shape.rest), 1e-9);
  }
  EXPECT_EQ(stems_in(kAssets / "meshes"), names);
}

TEST(SampleMeshes, HaveTheSizesOfThePapersTable) {
  const std::map<std::string, std::pair<int, int>> sizes{
      {"disk_coarse", {293, 542}}, {"disk_dense", {2483, 4844}}, {"grid_coarse", {36, 50}},
      {"grid_dense", {121, 200}},  {"alligator", {928, 1236}},   {"cowboy", {200, 333}}};
  for (const samples::SampleMesh& mesh : samples::sample_meshes())
    if (const auto size = sizes.find(mesh.name); size != sizes.end()) {
      EXPECT_EQ(mesh.shape.rest.cols(), size->second.first) << mesh.name;
      EXPECT_EQ(mesh.shape.triangles.cols(), size->second.second) << mesh.name;
    }
}

TEST(SampleMeshes, HaveNoNeedles) {
  for (const samples::SampleMesh& mesh : samples::sample_meshes())
    EXPECT_GT(test::min_angle(mesh.shape), 10) << mesh.name;
}

TEST(SampleScenes, FilesAreWhatTheMakerMakes) {
  std::set<std::string> names;
  for (const auto& [name, scene] : samples::sample_scenes(samples::sample_meshes())) {
    SCOPED_TRACE(name);
    names.insert(name);
    const LoadedScene file = load_scene(kAssets / "scenes" / (name + ".json"), kMethods);
    EXPECT_TRUE(file.notices.empty());
    EXPECT_EQ(file.scene.energy, scene.energy);
    EXPECT_EQ(file.scene.parameters, scene.parameters);
    EXPECT_EQ(file.scene.description, scene.description);
    EXPECT_EQ(file.scene.triangles, scene.triangles);
    EXPECT_LT(largest_difference(file.scene.rest, scene.rest), 1e-9);
    expect_same_motion(file.scene, scene);
    ASSERT_EQ(file.scene.handles.size(), scene.handles.size());
    for (std::size_t i = 0; i < scene.handles.size(); ++i) {
      EXPECT_EQ(file.scene.handles[i].vertex, scene.handles[i].vertex);
      EXPECT_EQ(file.scene.handles[i].kind, scene.handles[i].kind);
      EXPECT_LT(largest_difference(file.scene.handles[i].target, scene.handles[i].target), 1e-9);
    }
  }
  EXPECT_EQ(stems_in(kAssets / "scenes"), names);
}

TEST(SampleScenes, EachSaysWhatToLookAtInOneLine) {
  for (const auto& [name, scene] : samples::sample_scenes(samples::sample_meshes())) {
    EXPECT_FALSE(scene.description.empty()) << name;
    EXPECT_EQ(scene.description.find('\n'), std::string::npos) << name;
    EXPECT_LE(scene.description.size(), 120u) << name;
  }
}

TEST(SampleScenes, TheWelcomeRests) {
  const auto scenes = samples::sample_scenes(samples::sample_meshes());
  ASSERT_EQ(scenes.front().name, "welcome");
  const Scene& scene = scenes.front().scene;
  EXPECT_GE(scene.handles.size(), 4u);
  for (const Handle& handle : scene.handles)
    EXPECT_EQ(handle.target, scene.rest.col(handle.vertex));
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/random_suite.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "core/run/run.h"
#include "core/scene/scene_io.h"

namespace foldless {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr int kScenes = 30;

/// The area of the image of a tiny triangle at p over its own: about det ∇f.
double local_area_ratio(const PlaneMap& map, const Vec2& p) {
  constexpr double kSize = 1e-9;
  const Vec2 x = p + Vec2(kSize, 0);
  const Vec2 y = p + Vec2(0, kSize);
  return signed_area(map(p), map(x), map(y)) / signed_area(p, x, y);
}

TEST(RandomSuite, ItsMapsKeepOrientationEverywhere) {
  for (int i = 0; i < kScenes; ++i) {
    const RandomDeformation deformation = random_deformation(kSeed, i);
    RandomNumbers random(kSeed);
    const Shape& shape = deformation.mesh.shape;
    for (int sample = 0; sample < 4000; ++sample) {
      const auto t = shape.triangles.col(static_cast<Eigen::Index>(
          random.below(static_cast<std::size_t>(shape.triangles.cols()))));
      const double a = random.between(0, 1);
      const double b = random.between(0, 1 - a);
      const Vec2 p =
          (1 - a - b) * shape.rest.col(t[0]) + a * shape.rest.col(t[1]) + b * shape.rest.col(t[2]);
      EXPECT_GT(local_area_ratio(deformation.map, p), 0) << "scene " << i << ", seed " << kSeed;
    }
  }
}

TEST(RandomSuite, AFixedBoundaryStaysBitForBitAndIsAllHandles) {
  for (int i = 0; i < 2 * kScenes; ++i) {
    const BenchScene scene = random_scene(kSeed, i);
    if (scene.difficulty != "fixed-boundary" && scene.difficulty != "swirl") continue;
    const RandomDeformation deformation = random_deformation(kSeed, i);
    std::map<int, Vec2> targets;
    for (const Handle& handle : scene.scene.handles) targets[handle.vertex] = handle.target;
    std::size_t boundary = 0;
    for (int v = 0; v < scene.scene.rest.cols(); ++v) {
      if (!deformation.mesh.is_boundary[static_cast<std::size_t>(v)]) continue;
      ++boundary;
      ASSERT_EQ(targets.count(v), 1u) << scene.name;
      EXPECT_EQ(targets[v], scene.scene.rest.col(v)) << scene.name;
    }
    EXPECT_GE(scene.scene.handles.size(), boundary + 3) << scene.name;
  }
}

TEST(RandomSuite, TheSameSeedGivesTheSameScenesBitForBit) {
  for (int i = 0; i < kScenes; ++i) {
    const Scene a = random_scene(kSeed, i).scene;
    const Scene b = random_scene(kSeed, i).scene;
    EXPECT_EQ(scene_text(a, "/"), scene_text(b, "/"));
  }
  EXPECT_NE(scene_text(random_scene(kSeed, 0).scene, "/"),
            scene_text(random_scene(kSeed + 1, 0).scene, "/"));
}

TEST(RandomSuite, CoordinatesDoNotHangOnLastDigits) {
  for (int i = 0; i < kScenes; ++i) {
    const Scene scene = random_scene(kSeed, i).scene;
    for (const double x : scene.rest.reshaped()) EXPECT_EQ(x, suite_coordinate(x));
    for (const Handle& handle : scene.handles)
      for (const double x : handle.target) EXPECT_EQ(x, suite_coordinate(x));
  }
}

TEST(RandomSuite, ScenesAreValid) {
  std::set<std::string> names;
  for (int i = 0; i < 2 * kScenes; ++i) {
    const auto [name, difficulty, scene, drag] = random_scene(kSeed, i);
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(is_injective(scene.triangles, scene.rest)) << name;
    EXPECT_LE(scene.triangles.cols(), 5000) << name;
    EXPECT_GE(scene.triangles.cols(), 90) << name;
    EXPECT_GE(scene.handles.size(), 3u) << name;
    std::set<int> vertices;
    std::set<std::pair<double, double>> targets;
    double farthest = 0;
    for (const Handle& handle : scene.handles) {
      EXPECT_TRUE(vertices.insert(handle.vertex).second) << name;
      EXPECT_TRUE(targets.emplace(handle.target.x(), handle.target.y()).second) << name;
      farthest = std::max(farthest, (handle.target - scene.rest.col(handle.vertex)).norm());
    }
    EXPECT_GT(farthest, 0.01) << name << " has next to nothing to do";
    EXPECT_NO_THROW(foldless::Run(
        {MeshPair(scene.triangles, scene.rest), scene.energy, scene.handles, scene.parameters}))
        << name;
  }
}

TEST(RandomSuite, ThirtyScenesHaveEveryEnergyAtEveryDifficulty) {
  std::set<std::pair<std::string_view, std::string>> pairs;
  for (int i = 0; i < 30; ++i) {
    const BenchScene scene = random_scene(kSeed, i);
    pairs.emplace(scene.scene.energy->name, scene.difficulty);
  }
  EXPECT_EQ(pairs.size(), densities().size() * difficulties().size());
}

}  // namespace
}  // namespace foldless

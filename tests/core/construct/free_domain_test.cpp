// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/free_domain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/construct/pinned_map.h"
#include "core/mesh/boundary.h"
#include "core/mesh/generate.h"
#include "tests/support/mesh_measures.h"
#include "tests/support/sanitizers.h"
#include "tests/support/spiral.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

/// A mesh at rest, and the vertices and targets of a construction.
struct Scene {
  MeshPair mesh;
  PinnedDomain domain;
  Points targets;
};

std::vector<std::vector<int>> loops_of(const MeshPair& mesh) {
  const auto neighbours = boundary_neighbours(mesh.triangles(), mesh.vertex_count());
  std::vector<std::vector<int>> loops;
  std::vector<bool> is_met(static_cast<std::size_t>(mesh.vertex_count()), false);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_boundary_vertex(v) || is_met[static_cast<std::size_t>(v)]) continue;
    loops.push_back(boundary_loop(neighbours, v));
    for (const int other : loops.back()) is_met[static_cast<std::size_t>(other)] = true;
  }
  return loops;
}

/// So many vertices at random, at the boundary or inside, that go to each other's places.
Scene trading(const Shape& shape, std::uint64_t seed, std::size_t count) {
  Scene scene{{shape.triangles, shape.rest}, {}, {}};
  scene.domain.loops = loops_of(scene.mesh);
  std::mt19937_64 random(seed);
  std::vector<int> vertices(static_cast<std::size_t>(scene.mesh.vertex_count()));
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = static_cast<int>(i);
  for (std::size_t left = vertices.size(); left > 1; --left)
    std::swap(vertices[left - 1], vertices[random() % left]);
  vertices.resize(count);
  scene.domain.pinned = vertices;
  std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
  scene.targets = shape.rest(Eigen::all, vertices);
  return scene;
}

Shape round_shape() {
  return disk({.rings = 5, .boundary_vertices = 30, .vertices = 91, .radius = 1});
}

void expect_placed(const MeshPair& mesh, const Scene& scene) {
  EXPECT_TRUE(test::is_valid(mesh));
  EXPECT_EQ(mesh.rest().leftCols(scene.mesh.vertex_count()), scene.mesh.rest());
  EXPECT_EQ(Points(mesh.deformed()(Eigen::all, scene.domain.pinned)), scene.targets);
  EXPECT_NEAR(test::area_of({mesh.triangles(), mesh.rest()}),
              test::area_of({scene.mesh.triangles(), scene.mesh.rest()}), 1e-6);
  EXPECT_EQ(loops_of(mesh).size(), loops_of(scene.mesh).size());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_FALSE(mesh.is_isolated(v)) << v;
    if (v < scene.mesh.vertex_count()) {
      EXPECT_EQ(mesh.is_boundary_vertex(v), scene.mesh.is_boundary_vertex(v)) << v;
    }
  }
}

TEST(FreeDomain, VerticesAtTheBoundaryAndInsideTradePlaces) {
  int at_the_boundary = 0, inside = 0;
  for (std::uint64_t seed = 1; seed <= test::seeds(40); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Scene scene =
        trading(seed % 2 ? round_shape() : grid({.columns = 7, .rows = 6}), seed, 2 + seed % 7);
    const auto mesh = with_free_domain(scene.mesh, scene.domain, scene.targets);
    ASSERT_TRUE(mesh);
    expect_placed(*mesh, scene);
    for (const int v : scene.domain.pinned)
      ++(scene.mesh.is_boundary_vertex(v) ? at_the_boundary : inside);
  }
  EXPECT_GT(std::min(at_the_boundary, inside), 3) << "the claim would be empty";
}

TEST(FreeDomain, MayHaveAHole) {
  for (std::uint64_t seed = 1; seed <= test::seeds(10); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Scene scene = trading(annulus({.sectors = 24, .layers = 4}), seed, 4);
    ASSERT_EQ(scene.domain.loops.size(), 2U);
    const auto mesh = with_free_domain(scene.mesh, scene.domain, scene.targets);
    ASSERT_TRUE(mesh);
    expect_placed(*mesh, scene);
  }
}

TEST(FreeDomain, HasAMapOfEveryClass) {
  const Scene scene = trading(round_shape(), 3, 5);
  for (int choice = 0; choice < kClassesOfPinnedDisks; ++choice) {
    const auto mesh = with_free_domain(scene.mesh, scene.domain, scene.targets, choice);
    ASSERT_TRUE(mesh) << choice;
    expect_placed(*mesh, scene);
  }
  EXPECT_FALSE(with_free_domain(scene.mesh, scene.domain, scene.targets, kClassesOfPinnedDisks));
}

TEST(FreeDomain, TargetsMayBeFarAway) {
  Scene scene = trading(round_shape(), 5, 4);
  scene.targets = scene.targets.array() * 30 + 200;
  const auto mesh = with_free_domain(scene.mesh, scene.domain, scene.targets);
  ASSERT_TRUE(mesh);
  expect_placed(*mesh, scene);
}

TEST(FreeDomain, IsNothingWhereTwoTargetsAreOneOrTheMeshLiesOverItself) {
  Scene scene = trading(round_shape(), 1, 3);
  scene.targets.col(1) = scene.targets.col(0);
  EXPECT_FALSE(with_free_domain(scene.mesh, scene.domain, scene.targets));
  const Scene wound = trading(test::wound_strip(24, 2, 1.3), 1, 3);
  EXPECT_FALSE(with_free_domain(wound.mesh, wound.domain, wound.targets));
}

}  // namespace
}  // namespace foldless

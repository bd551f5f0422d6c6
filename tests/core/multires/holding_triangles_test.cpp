// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/holding_triangles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"
#include "core/threads/team.h"
#include "tests/support/random_scene.h"
#include "tests/support/spiral.h"

namespace foldless {
namespace {

MeshPair shape_as_mesh(const Shape& shape) { return {shape.triangles, shape.rest}; }

/// Exact, the boundary included.
bool holds(const MeshPair& mesh, int triangle, const Vec2& p) {
  const Eigen::Vector3i t = mesh.triangles().col(triangle);
  for (int side = 0; side < 3; ++side)
    if (orientation(mesh.rest().col(t[side]), mesh.rest().col(t[(side + 1) % 3]), p) < 0)
      return false;
  return true;
}

TEST(HoldingTriangles, HoldTheirVerticesExactly) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair fine = shape_as_mesh(test::random_shape(random));
    const CoarseMesh coarse = coarsened(fine, {}, fine.vertex_count() / 3);
    const std::vector<int> triangles = holding_triangles(coarse, fine);
    for (int v = 0; v < fine.vertex_count(); ++v)
      EXPECT_TRUE(holds(coarse.mesh, triangles[static_cast<std::size_t>(v)], fine.rest().col(v)))
          << "vertex " << v;
  }
}

TEST(HoldingTriangles, OfVerticesOnCoarseEdgesTouchThem) {
  // Rounding puts vertices of a turned grid off the coarse edges that pass through them.
  Shape shape = grid({.columns = 40, .rows = 40, .diagonal = Diagonal::alternating});
  shape.rest = Eigen::Rotation2Dd(0.3).toRotationMatrix() * shape.rest;
  const MeshPair fine = shape_as_mesh(shape);
  const CoarseMesh coarse = coarsened(fine, {}, 300);
  const std::vector<int> triangles = holding_triangles(coarse, fine);
  for (int v = 0; v < fine.vertex_count(); ++v)
    EXPECT_TRUE(holds(coarse.mesh, triangles[static_cast<std::size_t>(v)], fine.rest().col(v)))
        << "vertex " << v;
}

TEST(HoldingTriangles, AreOfTheSheetOfTheirVertexWhereTheDomainLiesOverItself) {
  const int columns = 240, rows = 12;
  const MeshPair fine = shape_as_mesh(test::wound_strip(columns, rows, 3));
  ASSERT_TRUE(is_injective(fine.triangles(), fine.rest()));
  const CoarseMesh coarse = coarsened(fine, {}, 900);
  ASSERT_LT(coarse.mesh.vertex_count(), fine.vertex_count() / 2);
  const std::vector<int> triangles = holding_triangles(coarse, fine);
  for (int v = 0; v < fine.vertex_count(); ++v) {
    const int triangle = triangles[static_cast<std::size_t>(v)];
    EXPECT_TRUE(holds(coarse.mesh, triangle, fine.rest().col(v))) << "vertex " << v;
    // The next sheet is a third of the strip away.
    for (const int corner : coarse.mesh.triangles().col(triangle)) {
      const int of_fine = coarse.vertices[static_cast<std::size_t>(corner)];
      EXPECT_LT(std::abs(of_fine % (columns + 1) - v % (columns + 1)), columns / 6)
          << "vertex " << v;
    }
  }
}

TEST(HoldingTriangles, AreFoundAfterTheCoarseMeshWasFlippedAndSplit) {
  std::mt19937_64 random(5);
  const MeshPair fine = shape_as_mesh(grid({.columns = 30, .rows = 30}));
  CoarseMesh coarse = coarsened(fine, {}, 250);
  for (int k = 0; k < 60; ++k) {
    const int e = static_cast<int>(random() % static_cast<unsigned>(coarse.mesh.edge_count()));
    if (!coarse.mesh.is_boundary_edge(e)) coarse.mesh.split_edge(e, 0.4);
  }
  ASSERT_TRUE(is_injective(coarse.mesh.triangles(), coarse.mesh.rest()));
  const std::vector<int> triangles = holding_triangles(coarse, fine);
  for (int v = 0; v < fine.vertex_count(); ++v)
    EXPECT_TRUE(holds(coarse.mesh, triangles[static_cast<std::size_t>(v)], fine.rest().col(v)))
        << "vertex " << v;
}

TEST(HoldingTriangles, AreTheSameHoweverManyThreadsSeekThem) {
  const MeshPair fine = shape_as_mesh(grid({.columns = 150, .rows = 150}));
  const CoarseMesh coarse = coarsened(fine, {}, 2000);
  const std::vector<int> alone = holding_triangles(coarse, fine);
  Team team(3);
  const WithTeam with(&team);
  EXPECT_EQ(holding_triangles(coarse, fine), alone);
}

TEST(HoldingTriangles, VerticesThatNoTriangleUsesHaveNone) {
  const Shape shape = grid({.columns = 8, .rows = 8});
  Points rest(2, 82);
  rest << shape.rest, Vec2(0.5, 0.5);
  const MeshPair fine(shape.triangles, rest);
  const std::vector<int> triangles = holding_triangles(coarsened(fine, {}, 50), fine);
  EXPECT_EQ(triangles.back(), -1);
  EXPECT_EQ(std::ranges::count(triangles, -1), 1);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/split_edges.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/injective.h"
#include "tests/core/remesh/one_ring.h"
#include "tests/support/meshes.h"
#include "tests/support/notched_disk.h"

namespace foldless {
namespace {

using test::kEast;

/// True when vertex 0 may sit at `v_alpha` with the new vertices where they are told.
bool is_free_at(const MeshPair& mesh, const Vec2& v_alpha, const std::vector<Vec2>& new_vertices) {
  Points u = mesh.deformed();
  u.col(0) = v_alpha;
  const auto first = u.cols() - static_cast<Eigen::Index>(new_vertices.size());
  for (std::size_t i = 0; i < new_vertices.size(); ++i)
    u.col(first + static_cast<Eigen::Index>(i)) = new_vertices[i];
  return is_injective(mesh.triangles(), mesh.rest(), u);
}

TEST(SplitEdges, LetsTheVertexThroughTheInsideOfAnEdge) {  // Figure 15 (a)
  MeshPair mesh = test::figure_4a();
  EXPECT_FALSE(is_free_at(mesh, {1, 0}, {}));
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {}), 1);
  EXPECT_TRUE(is_free_at(mesh, {1, 0}, {{1.5, 0}}));
}

TEST(SplitEdges, LetsTheVertexPastTheNearEndOfAnEdge) {  // Figure 15 (b)
  MeshPair mesh = test::figure_4b();
  EXPECT_FALSE(is_free_at(mesh, {1, 0}, {}));
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {}), 1);
  EXPECT_TRUE(is_free_at(mesh, {1, 0}, {{0.2, 1.5}}));
}

TEST(SplitEdges, LetsTheVertexPastTwoComponents) {  // Figure 16 (b)
  MeshPair mesh = test::figure_16();
  EXPECT_FALSE(is_free_at(mesh, {1, 0}, {}));
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {}), 3);
  // New vertices on 0–4, 0–6 and 0–7, moved off the line to the side that 0 came from.
  EXPECT_TRUE(is_free_at(mesh, {1, 0}, {{0.8, 2}, {0.6, -3}, {0.9, -1.2}}));
}

TEST(SplitEdges, LeaveTheNarrowestGapsAtTheBoundaryOpen) {
  for (double gap = 1; gap > 1e-9; gap /= 10)
    for (const double turn : {0.0, 0.7, 2.0, 3.9}) {
      SCOPED_TRACE(testing::Message() << "gap " << gap << " turned by " << turn);
      const test::Fixture f = test::notched_disk(1);
      const Mat2 rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
      const Points u = rotation * test::with_notch(f.rest, 1, gap);
      MeshPair mesh(f.triangles, f.rest, u.colwise() + Vec2(0.3, -0.7));
      ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()));
      for (const int round : {1, 2}) {
        EXPECT_GT(split_all_edges(mesh, {}), 20) << round;
        EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed())) << round;
      }
    }
}

TEST(SplitEdges, DoesNotChangeTheMap) {
  MeshPair mesh = test::figure_16();
  Points u = mesh.rest();
  u.row(0) += 0.3 * u.row(1);
  mesh.set_deformed(u);
  const Mat2 J = deformation_gradient(mesh.rest(), mesh.deformed(), mesh.triangles().col(0));
  ASSERT_GT(split_edges(mesh, {{0, kEast}}, {}), 0);
  for (const auto& t : mesh.triangles().colwise())
    EXPECT_NEAR((deformation_gradient(mesh.rest(), mesh.deformed(), t) - J).norm(), 0, 1e-12);
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()));
}

TEST(SplitEdges, SplitsNoMoreThanItMay) {
  for (const int most : {0, 1, 2, 3, 4}) {
    MeshPair mesh = test::figure_16();
    EXPECT_EQ(split_edges(mesh, {{0, kEast}}, {.most_splits = most}), std::min(most, 3));
  }
  MeshPair mesh = test::figure_16();
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {.most_splits = 1}), 1);
  EXPECT_TRUE(mesh.find_edge(4, 8)) << "the farthest first";
}

TEST(SplitEdges, MakesNoShortEdgeInEitherMesh) {
  for (const double scale :
       {0.1, 10.0}) {  // of the deformed mesh; the edge in the way has length 2
    const MeshPair square = test::figure_4a();
    const double shorter = std::min(1.0, scale);
    for (const double part : {0.999, 1.001}) {
      MeshPair mesh(square.triangles(), square.rest(), scale * square.rest());
      EXPECT_EQ(split_edges(mesh, {{0, kEast}}, {.shortest_edge = part * shorter}), part < 1);
    }
  }
}

TEST(SplitEdges, SplitsNoTriangleBelowTheBoundOnAreas) {
  const MeshPair square = test::figure_4a();
  Points flat = square.rest();
  flat.row(1) *= 0.5;
  for (const double delta : {0.49, 0.51}) {
    MeshPair mesh(square.triangles(), square.rest(), flat);
    EXPECT_EQ(split_edges(mesh, {{0, kEast}}, {.delta = delta}), delta < 0.5);
  }
}

TEST(SplitEdges, PutsTheNewVertexWhereTheWayCrossesInBothMeshes) {
  for (const double height : {0.4, -0.4, 0.9}) {  // of the way where it crosses the edge
    SCOPED_TRACE(height);
    const MeshPair square = test::figure_4a();
    Points u = square.rest();
    u.row(1) *= 2;
    MeshPair mesh(square.triangles(), square.rest(), u);
    ASSERT_EQ(split_edges(mesh, {{0, Vec2(1, 2 * height)}}, {}), 1);
    // No nearer to an end than a fifth of the edge.
    const Vec2 rest(1, std::min(height, 0.6));
    EXPECT_LT((mesh.rest().col(5) - rest).norm(), 1e-15);
    EXPECT_LT((mesh.deformed().col(5) - Vec2(1, 2 * rest.y())).norm(), 1e-15);
  }
}

TEST(SplitEdges, SplitsABoundaryEdgeToo) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(split_edges(mesh, {{0, Vec2(1, 0.5)}}, {}), 1);
  EXPECT_EQ(mesh.face_count(), 3);
  EXPECT_EQ(mesh.edge(mesh.find_edge(1, 4).value()), (Edge{1, 4}));
}

TEST(SplitEdges, LeavesBoundaryEdgesBetweenFixedVertices) {
  const test::Fixture square = test::unit_square();
  const auto splits_with = [&](const std::vector<int>& fixed_boundary) {
    MeshPair mesh(square.triangles, square.rest);
    return split_edges(mesh, {{0, Vec2(1, 0.4)}}, {.fixed_boundary = fixed_boundary});
  };
  EXPECT_EQ(splits_with({}), 1);
  EXPECT_EQ(splits_with({2, 3}), 1);
  EXPECT_EQ(splits_with({1, 2}), 0) << "the edge in the way";
}

TEST(SplitAllEdges, SplitsEveryEdgeOnceAndDoesNotChangeTheMap) {
  MeshPair mesh = test::figure_16();
  Points u = mesh.rest();
  u.row(0) += 0.3 * u.row(1);
  mesh.set_deformed(u);
  const Mat2 J = deformation_gradient(mesh.rest(), mesh.deformed(), mesh.triangles().col(0));
  const int vertices = mesh.vertex_count(), edges = mesh.edge_count();
  EXPECT_EQ(split_all_edges(mesh, {}), edges);
  EXPECT_EQ(mesh.vertex_count(), vertices + edges);
  for (const auto& t : mesh.triangles().colwise())
    EXPECT_NEAR((deformation_gradient(mesh.rest(), mesh.deformed(), t) - J).norm(), 0, 1e-12);
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()));
}

TEST(SplitAllEdges, LeavesBoundaryEdgesBetweenFixedVertices) {
  const test::Fixture square = test::unit_square();
  MeshPair mesh(square.triangles, square.rest);
  const std::vector<int> corners{0, 1, 2, 3};
  EXPECT_EQ(split_all_edges(mesh, {.fixed_boundary = corners}), 1) << "the diagonal";
}

}  // namespace
}  // namespace foldless

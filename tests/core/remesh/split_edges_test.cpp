// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/split_edges.h"

#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// Vertex 0 at the origin with a closed link, vertices 1, 2, … counter-clockwise.
MeshPair one_ring(const std::vector<Vec2>& link) {
  const int n = static_cast<int>(link.size());
  Points points(2, n + 1);
  points.col(0).setZero();
  Triangles triangles(3, n);
  for (int k = 0; k < n; ++k) {
    points.col(k + 1) = link[static_cast<std::size_t>(k)];
    triangles.col(k) << 0, k + 1, (k + 1) % n + 1;
  }
  EXPECT_TRUE(is_injective(triangles, points));
  return {triangles, points};
}

const Vec2 kEast(1, 0);

std::vector<Edge> blocking_edges(const MeshPair& mesh, const Blockage& blockage) {
  std::vector<Edge> edges;
  for (const int e : blockage.blocking) edges.push_back(mesh.edge(e));
  return edges;
}

std::vector<Edge> split_edges_of(const MeshPair& mesh, const Blockage& blockage) {
  std::vector<Edge> edges;
  for (const EdgeSplit& split : blockage.splits) edges.push_back(mesh.edge(split.edge));
  return edges;
}

/// True when vertex 0 may sit at `v_alpha` with the new vertices where they are told.
bool is_free_at(const MeshPair& mesh, const Vec2& v_alpha, const std::vector<Vec2>& new_vertices) {
  Points u = mesh.deformed();
  u.col(0) = v_alpha;
  const auto first = u.cols() - static_cast<Eigen::Index>(new_vertices.size());
  for (std::size_t i = 0; i < new_vertices.size(); ++i)
    u.col(first + static_cast<Eigen::Index>(i)) = new_vertices[i];
  return is_injective(mesh.triangles(), mesh.rest(), u);
}

/// Figure 4 (a): the way leads through the inside of one link edge.
MeshPair figure_4a() { return one_ring({{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}); }

/// Figure 4 (b): the line through 3–4 crosses the way first, outside of the edge, nearer to 3.
MeshPair figure_4b() { return one_ring({{3, -1}, {3, 1}, {0.6, 1.2}, {0, 3}, {-3, 0}, {0, -3}}); }

/// Figure 16: the line x = 1 carries 2–3 above the way and 6–7–1 below; v_α = (1, 0) is on none.
MeshPair figure_16() {
  return one_ring({{1, -1}, {4, 0}, {1, 2}, {1, 4}, {-2, 0}, {1, -6}, {1, -3}});
}

TEST(Blockage, InsideOneEdgeSplitsThatEdge) {
  const MeshPair mesh = figure_4a();
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_EQ(blockage.v_alpha, Vec2(1, 0));
  EXPECT_EQ(blocking_edges(mesh, blockage), std::vector<Edge>({{1, 2}}));
  EXPECT_EQ(split_edges_of(mesh, blockage), std::vector<Edge>({{1, 2}}));
}

TEST(Blockage, OutsideOneEdgeSplitsTheSpokeToItsFarEnd) {
  const MeshPair mesh = figure_4b();
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_NEAR((blockage.v_alpha - Vec2(1, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(blocking_edges(mesh, blockage), std::vector<Edge>({{3, 4}}));
  EXPECT_EQ(split_edges_of(mesh, blockage), std::vector<Edge>({{0, 4}}));
}

TEST(Blockage, AtACommonEndSplitsFourEdges) {
  const MeshPair mesh = one_ring({{0, -2}, {1, 0}, {0, 2}, {-1, 0}});
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_EQ(blockage.v_alpha, Vec2(1, 0));
  std::vector<Edge> splits = split_edges_of(mesh, blockage);
  std::ranges::sort(splits);
  EXPECT_EQ(splits, std::vector<Edge>({{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
}

TEST(Blockage, ComponentsAreSplitFromTheFarthestToTheNearest) {
  const MeshPair mesh = figure_16();
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_NEAR((blockage.v_alpha - Vec2(1, 0)).norm(), 0, 1e-15);
  std::vector<Edge> blocking = blocking_edges(mesh, blockage);
  std::ranges::sort(blocking);
  EXPECT_EQ(blocking, std::vector<Edge>({{1, 7}, {3, 4}, {6, 7}}));
  // {3–4} is 2 away from v_α, {6–7, 7–1} is 1 away.
  EXPECT_EQ(split_edges_of(mesh, blockage), std::vector<Edge>({{0, 4}, {0, 6}, {0, 7}}));
}

TEST(Blockage, NothingBlocksAVertexThatNoTriangleEndsBefore) {
  // A lone triangle: away from its opposite edge the vertex may go for ever.
  Points points(2, 3);
  points << 0, -1, -1,  //
      0, 1, -1;
  const MeshPair mesh(Triangles(Eigen::Vector3i(0, 1, 2)), points);
  EXPECT_FALSE(blockage_of(mesh, 0, kEast).has_value());
  EXPECT_TRUE(blockage_of(mesh, 0, -kEast).has_value());
}

TEST(SplitEdges, LetsTheVertexThroughTheInsideOfAnEdge) {  // Figure 15 (a)
  MeshPair mesh = figure_4a();
  EXPECT_FALSE(is_free_at(mesh, {1, 0}, {}));
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {}), 1);
  EXPECT_TRUE(is_free_at(mesh, {1, 0}, {{1.5, 0}}));
}

TEST(SplitEdges, LetsTheVertexPastTheNearEndOfAnEdge) {  // Figure 15 (b)
  MeshPair mesh = figure_4b();
  EXPECT_FALSE(is_free_at(mesh, {1, 0}, {}));
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {}), 1);
  EXPECT_TRUE(is_free_at(mesh, {1, 0}, {{0.2, 1.5}}));
}

TEST(SplitEdges, LetsTheVertexPastTwoComponents) {  // Figure 16 (b)
  MeshPair mesh = figure_16();
  EXPECT_FALSE(is_free_at(mesh, {1, 0}, {}));
  ASSERT_EQ(split_edges(mesh, {{0, kEast}}, {}), 3);
  // New vertices on 0–4, 0–6 and 0–7, moved off the line to the side that 0 came from.
  EXPECT_TRUE(is_free_at(mesh, {1, 0}, {{0.8, 2}, {0.6, -3}, {0.9, -1.2}}));
}

TEST(SplitEdges, DoesNotChangeTheMap) {
  MeshPair mesh = figure_16();
  Points u = mesh.rest();
  u.row(0) += 0.3 * u.row(1);
  mesh.set_deformed(u);
  const Mat2 J = deformation_gradient(mesh.rest(), mesh.deformed(), mesh.triangles().col(0));
  ASSERT_GT(split_edges(mesh, {{0, kEast}}, {}), 0);
  for (const auto& t : mesh.triangles().colwise())
    EXPECT_NEAR((deformation_gradient(mesh.rest(), mesh.deformed(), t) - J).norm(), 0, 1e-12);
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()));
}

TEST(SplitEdges, KeepsToItsBounds) {
  MeshPair mesh = figure_16();
  EXPECT_EQ(split_edges(mesh, {{0, kEast}}, {.most_splits = 2}), 2);
  MeshPair coarse = figure_4a();
  EXPECT_EQ(split_edges(coarse, {{0, kEast}}, {.shortest_edge = 1.1}), 0);
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
  MeshPair mesh = figure_16();
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

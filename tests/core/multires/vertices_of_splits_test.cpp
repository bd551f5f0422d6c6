// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/vertices_of_splits.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/generate.h"
#include "tests/support/meshes.h"
#include "tests/support/spiral.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

/// A square of two triangles over a grid of 3 × 3 cells.
struct Square {
  Square() {
    const auto square = test::unit_square();
    coarse = {MeshPair(square.triangles, square.rest), {0, 3, 15, 12}};
    const Shape shape = grid({.columns = 3, .rows = 3, .diagonal = Diagonal::falling});
    fine = MeshPair(shape.triangles, shape.rest);
  }
  int split(int a, int b, double t) {
    return coarse.mesh.split_edge(coarse.mesh.find_edge(a, b).value(), t);
  }
  CoarseMesh coarse;
  MeshPair fine;
};

TEST(VerticesOfSplits, AVertexInATriangleSplitsItOnce) {
  Square square;
  const int v = square.split(0, 2, 0.4);
  VerticesOfSplits vertices(square.coarse, square.fine);
  EXPECT_EQ(vertices.vertex_at(v), 16);
  EXPECT_EQ(vertices.vertex_at(v), 16) << "which is there now";
  EXPECT_EQ(square.fine.vertex_count(), 17);
  EXPECT_LT((square.fine.rest().col(16) - Vec2(0.4, 0.4)).norm(), 1e-15);
  EXPECT_EQ(square.fine.triangles_of_vertex(16).size(), 3U);
  EXPECT_TRUE(test::is_valid(square.fine));
}

TEST(VerticesOfSplits, AVertexOnAnEdgeSplitsIt) {
  Square square;
  const int v = square.split(0, 2, 0.5);  // where the diagonal crosses that of the middle cell
  VerticesOfSplits vertices(square.coarse, square.fine);
  EXPECT_EQ(vertices.vertex_at(v), 16);
  EXPECT_EQ(square.fine.triangles_of_vertex(16).size(), 4U);
  EXPECT_TRUE(test::is_valid(square.fine));
}

TEST(VerticesOfSplits, AVertexWhereTheFineMeshHasOneIsThatOne) {
  Square square;
  const int v = square.split(0, 2, 1.0 / 3);
  VerticesOfSplits vertices(square.coarse, square.fine);
  EXPECT_EQ(vertices.vertex_at(v), 5);
  EXPECT_EQ(square.fine.vertex_count(), 16);
}

TEST(VerticesOfSplits, AVertexOfTheBoundaryStaysOnIt) {
  Square square;
  const int v = square.split(0, 1, 0.21), w = square.split(0, v, 0.37);
  VerticesOfSplits vertices(square.coarse, square.fine);
  for (const int of_boundary : {v, w}) {
    const int made = vertices.vertex_at(of_boundary).value();
    EXPECT_TRUE(square.fine.is_boundary_vertex(made));
    EXPECT_EQ(square.fine.rest()(1, made), 0);
    EXPECT_NEAR(square.fine.rest()(0, made), square.coarse.mesh.rest()(0, of_boundary), 1e-15);
  }
  EXPECT_EQ(square.fine.vertex_count(), 18);
  EXPECT_TRUE(test::is_valid(square.fine));
}

TEST(VerticesOfSplits, AVertexInsideThatIsAlmostAtTheBoundarySplitsNoEdgeOfIt) {
  Square square;
  const int v = square.split(0, 2, 1e-9);
  VerticesOfSplits vertices(square.coarse, square.fine);
  const int vertex_count = square.fine.vertex_count();
  EXPECT_EQ(vertices.vertex_at(v), 0) << "it is at the corner";
  Points rest = square.coarse.mesh.rest();
  rest.col(v) = Vec2(0.2, 1e-9);
  square.coarse.mesh.set_positions(rest, rest);
  EXPECT_FALSE(VerticesOfSplits(square.coarse, square.fine).vertex_at(v));
  EXPECT_EQ(square.fine.vertex_count(), vertex_count);
}

TEST(VerticesOfSplits, AVertexOfASheetIsMadeOnThatSheet) {
  const int columns = 240;
  const Shape strip = test::wound_strip(columns, 12, 2.5);
  MeshPair fine(strip.triangles, strip.rest);
  // Unwound: where a vertex goes tells its sheet.
  Points unwound(2, fine.vertex_count());
  for (int v = 0; v < fine.vertex_count(); ++v)
    unwound.col(v) = Vec2(v % (columns + 1), v / (columns + 1));
  fine.set_deformed(unwound);
  CoarseMesh coarse = coarsened(fine, {}, 900);
  std::mt19937_64 random(1);
  std::vector<int> made;
  for (int i = 0; i < 200; ++i) {
    const auto edges = static_cast<std::uint64_t>(coarse.mesh.edge_count());
    const auto e = static_cast<int>(random() % edges);
    if (!coarse.mesh.is_boundary_edge(e)) made.push_back(coarse.mesh.split_edge(e, 0.4));
  }
  VerticesOfSplits vertices(coarse, fine);
  for (const int v : made) {
    const int vertex = vertices.vertex_at(v).value();
    EXPECT_LT((fine.deformed().col(vertex) - coarse.mesh.deformed().col(v)).norm(), 3);
  }
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_edges.h"

#include <gtest/gtest.h>

#include "tests/support/meshes.h"

namespace foldless {
namespace {

MeshEdges edges_of(const test::Fixture& fixture) {
  const Triangles& triangles = fixture.triangles;
  const std::vector<std::uint32_t> indices(triangles.data(), triangles.data() + triangles.size());
  return mesh_edges(indices);
}

TEST(MeshEdges, OfASquareAreItsDiagonalAndItsSidesWithTheirTriangles) {
  const MeshEdges edges = edges_of(test::unit_square());
  ASSERT_EQ(edges.interior.size(), 1U);
  EXPECT_EQ(edges.interior[0].a, 0U);
  EXPECT_EQ(edges.interior[0].b, 2U);
  EXPECT_EQ(edges.interior[0].triangle + edges.interior[0].other, 1) << "the triangles 0 and 1";
  EXPECT_EQ(edges.boundary, (std::vector<MeshEdge>{{0, 1, 0}, {0, 3, 1}, {1, 2, 0}, {2, 3, 1}}));
}

TEST(MeshEdges, OfADiskObeyEuler) {
  for (const int n : {2, 5, 9}) {
    const test::Fixture fixture = test::square_grid(n);
    const MeshEdges edges = edges_of(fixture);
    const auto all = static_cast<long>(edges.interior.size() + edges.boundary.size());
    EXPECT_EQ(fixture.rest.cols() - all + fixture.triangles.cols(), 1);
    EXPECT_EQ(edges.boundary.size(), 4U * static_cast<unsigned>(n - 1));
  }
}

TEST(MeshEdges, AreFoundByTheirVerticesInAnyOrder) {
  const MeshEdges edges = edges_of(test::square_grid(3));
  for (const MeshEdge& edge : edges.interior) {
    EXPECT_EQ(find_edge(edges.interior, edge.a, edge.b), &edge);
    EXPECT_EQ(find_edge(edges.interior, edge.b, edge.a), &edge);
  }
  EXPECT_EQ(find_edge(edges.interior, 0, 8), nullptr);
  EXPECT_EQ(find_edge({}, 0, 8), nullptr);
}

TEST(MeshEdges, OfNothingAreNone) {
  EXPECT_TRUE(mesh_edges({}).interior.empty());
  EXPECT_TRUE(mesh_edges({}).boundary.empty());
}

}  // namespace
}  // namespace foldless

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

TEST(MeshEdges, OfASquareAreItsDiagonalAndItsSides) {
  const MeshEdges edges = edges_of(test::unit_square());
  EXPECT_EQ(edges.interior, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(edges.boundary, (std::vector<std::uint32_t>{0, 1, 0, 3, 1, 2, 2, 3}));
}

TEST(MeshEdges, OfADiskObeyEuler) {
  for (const int n : {2, 5, 9}) {
    const test::Fixture fixture = test::square_grid(n);
    const MeshEdges edges = edges_of(fixture);
    const auto all = static_cast<long>((edges.interior.size() + edges.boundary.size()) / 2);
    EXPECT_EQ(fixture.rest.cols() - all + fixture.triangles.cols(), 1);
    EXPECT_EQ(edges.boundary.size(), 2U * 4U * static_cast<unsigned>(n - 1));
  }
}

TEST(MeshEdges, OfNothingAreNone) {
  EXPECT_TRUE(mesh_edges({}).interior.empty());
  EXPECT_TRUE(mesh_edges({}).boundary.empty());
}

}  // namespace
}  // namespace foldless

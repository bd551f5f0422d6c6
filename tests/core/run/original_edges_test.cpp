// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/original_edges.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/mesh/mesh_pair.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

TEST(OriginalEdges, ContainsExactlyTheEdgesOfTheMesh) {
  const test::Fixture grid = test::square_grid(5);
  const MeshPair mesh(grid.triangles, grid.rest);
  const OriginalEdges edges(grid.triangles, 25);
  for (int a = 0; a < 25; ++a)
    for (int b = a + 1; b < 25; ++b)
      EXPECT_EQ(edges.contains({a, b}), mesh.find_edge(a, b).has_value()) << a << ' ' << b;
}

TEST(OriginalEdges, FlippedEdgesAreTheDifferenceOfTheEdgeSets) {
  constexpr unsigned kSeed = 9;
  std::mt19937 random(kSeed);
  const test::Fixture grid = test::square_grid(7);
  const OriginalEdges edges(grid.triangles, 49);
  MeshPair mesh(grid.triangles, grid.rest);
  std::set<Edge> original;
  for (int e = 0; e < mesh.edge_count(); ++e) original.insert(mesh.edge(e));
  for (int k = 0; k < 60; ++k) {
    const int e = static_cast<int>(random() % static_cast<unsigned>(mesh.edge_count()));
    if (!mesh.is_boundary_edge(e) && mesh.is_flip_legal(e)) mesh.flip(e);
    std::set<Edge> expected;
    for (int f = 0; f < mesh.edge_count(); ++f)
      if (!original.contains(mesh.edge(f))) expected.insert(mesh.edge(f));
    const std::vector<Edge> flipped = edges.flipped_in(mesh.triangles());
    EXPECT_TRUE(std::ranges::equal(flipped, expected)) << "seed " << kSeed << ", flip " << k;
  }
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/insert_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"
#include "tests/support/meshes.h"
#include "tests/support/random_scene.h"
#include "tests/support/random_vector.h"
#include "tests/support/spiral.h"

namespace foldless {
namespace {

MeshPair grid_mesh(int n) {
  const auto f = test::square_grid(n);
  return {f.triangles, f.rest};
}

/// Vertices other than a and b on the segment between them, nearest to a first. Exact.
std::vector<int> vertices_between(const Points& rest, int a, int b) {
  const Vec2 way = rest.col(b) - rest.col(a);
  const auto along = [&](int v) { return (rest.col(v) - rest.col(a)).dot(way); };
  std::vector<int> between;
  for (int v = 0; v < rest.cols(); ++v)
    if (v != a && v != b && orientation(rest.col(a), rest.col(b), rest.col(v)) == 0 &&
        along(v) > 0 && along(v) < way.squaredNorm())
      between.push_back(v);
  std::ranges::sort(between, {}, along);
  return between;
}

bool is_chain(const MeshPair& mesh, int a, int b) {
  std::vector<int> chain = vertices_between(mesh.rest(), a, b);
  chain.push_back(b);
  for (const int v : chain)
    if (!mesh.find_edge(std::exchange(a, v), v)) return false;
  return true;
}

TEST(InsertEdge, AnEdgeThatIsThereTakesNoFlip) {
  MeshPair mesh = grid_mesh(5);
  const std::uint64_t revision = mesh.revision();
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge(e);
    EXPECT_EQ(insert_edge(mesh, a, b), 0);
    EXPECT_EQ(insert_edge(mesh, b, a), 0);
  }
  EXPECT_EQ(mesh.revision(), revision);
}

TEST(InsertEdge, TheOtherDiagonalOfASquareTakesOneFlip) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(insert_edge(mesh, 1, 3), 1);
  EXPECT_TRUE(mesh.find_edge(1, 3));
  EXPECT_EQ(mesh.rest(), f.rest);
}

TEST(InsertEdge, EverySegmentOfAGridBecomesAChainThroughTheVerticesOnIt) {
  const MeshPair before = grid_mesh(6);
  for (int a = 0; a < before.vertex_count(); ++a)
    for (int b = 0; b < before.vertex_count(); ++b) {
      if (a == b) continue;
      MeshPair mesh = before;
      const int flips = insert_edge(mesh, a, b);
      ASSERT_TRUE(is_chain(mesh, a, b)) << a << " to " << b;
      ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest())) << a << " to " << b;
      ASSERT_EQ(flips == 0, is_chain(before, a, b));
      ASSERT_EQ(mesh.rest(), before.rest());
      ASSERT_EQ(mesh.edge_count(), before.edge_count());
    }
}

TEST(InsertEdge, SegmentsThatDoNotCrossStayEdges) {
  // A fan over the grid from its corner: the segments meet there only.
  MeshPair mesh = grid_mesh(8);
  const std::vector<int> ends{15, 23, 31, 39, 47, 55, 62, 61, 60, 59, 58, 57};
  for (const int end : ends) insert_edge(mesh, 0, end);
  for (const int end : ends) EXPECT_TRUE(is_chain(mesh, 0, end)) << end;
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest()));
}

TEST(InsertEdge, ASegmentThatLeavesTheDomainChangesNothingOutsideOfIt) {
  MeshPair mesh = [] {
    const Shape ring = annulus({.inner_radius = 0.4, .outer_radius = 1, .sectors = 24});
    return MeshPair(ring.triangles, ring.rest);
  }();
  insert_edge(mesh, 0, 12);  // through the hole
  EXPECT_FALSE(mesh.find_edge(0, 12));
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest()));
}

TEST(InsertEdge, StaysOnItsSheetWhereTheDomainLiesOverItself) {
  const int columns = 60, rows = 4;
  const Shape strip = test::wound_strip(columns, rows, 2.5);
  MeshPair mesh(strip.triangles, strip.rest);
  ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest()));
  int flips = 0;
  for (int i = 0; i + 3 <= columns; i += 4) {
    const int a = (columns + 1) + i, b = 3 * (columns + 1) + i + 3;
    flips += insert_edge(mesh, a, b);
    EXPECT_TRUE(mesh.find_edge(a, b)) << i;
    EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest())) << i;
  }
  EXPECT_GT(flips, columns / 4);
}

/// A grid whose interior vertices are shaken strongly and whose edges are flipped at random, so
/// that many triangles are needles.
MeshPair wild_grid(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  MeshPair mesh = grid_mesh(9);
  for (int round = 0; round < 4; ++round) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.is_boundary_vertex(v)) continue;
      Points rest = mesh.rest();
      rest.col(v) += 0.8 * test::random_vector(unit, random);
      const std::vector<int> round_v = mesh.triangles_of_vertex(v);
      if (std::ranges::all_of(
              round_v, [&](int t) { return signed_area(rest, mesh.triangles().col(t)) > 0.01; }))
        mesh.set_positions(rest, rest);
    }
    for (int e = 0; e < mesh.edge_count(); ++e) {
      if (random() % 2 || !mesh.is_flip_legal(e)) continue;
      const Diamond d = mesh.diamond(e);
      const Points& p = mesh.rest();
      if (signed_area(p.col(d.c), p.col(d.d), p.col(d.b)) > 0.01 &&
          signed_area(p.col(d.d), p.col(d.c), p.col(d.a)) > 0.01)
        mesh.flip(e);
    }
  }
  return mesh;
}

TEST(InsertEdge, RandomSegmentsOfRandomMeshesBecomeEdgesAndTheRestMeshStaysValid) {
  int flips = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    MeshPair mesh = wild_grid(random);
    ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest()));
    const Points rest = mesh.rest();
    for (int k = 0; k < 20; ++k) {
      const int a = static_cast<int>(random() % 81), b = static_cast<int>(random() % 81);
      if (a == b) continue;
      flips += insert_edge(mesh, a, b);
      EXPECT_TRUE(is_chain(mesh, a, b)) << a << " to " << b;
      ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest())) << a << " to " << b;
    }
    EXPECT_EQ(mesh.rest(), rest);
  }
  EXPECT_GT(flips, 60 * 20) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless

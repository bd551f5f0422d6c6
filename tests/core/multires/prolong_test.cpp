// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/prolong.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "tests/support/meshes.h"
#include "tests/support/notched_disk.h"
#include "tests/support/random_scene.h"
#include "tests/support/random_vector.h"
#include "tests/support/spiral.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

EnergySettings energy(double delta = 1e-5) {
  EnergySettings settings;
  settings.density = find_density("arap");
  settings.beta = 2;
  settings.delta = delta;
  settings.barrier_area_weighted = true;
  return settings;
}

MeshPair pair_of_shape(const Shape& shape) { return {shape.triangles, shape.rest}; }

MeshPair fine_grid(int cells = 24) {
  return pair_of_shape(grid({.columns = cells, .rows = cells, .diagonal = Diagonal::alternating}));
}

/// Moves the vertices of the coarse mesh one by one, nearly as far as its triangles let them.
void crease(CoarseMesh& coarse, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  MeshPair& mesh = coarse.mesh;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    Vec2 way = test::random_vector(unit, random);
    for (int trial = 0; trial < 6; ++trial, way *= 0.5) {
      Points u = mesh.deformed();
      u.col(v) += way;
      const std::vector<int> round = mesh.triangles_of_vertex(v);
      const bool is_open = std::ranges::all_of(round, [&](int t) {
        const Eigen::Vector3i corners = mesh.triangles().col(t);
        return signed_area(u, corners) > 0.1 * signed_area(mesh.rest(), corners);
      });
      if (!is_open || !is_injective(mesh.triangles(), u)) continue;
      mesh.set_deformed(u);
      break;
    }
  }
}

void expect_shared_vertices_agree(const CoarseMesh& coarse, const MeshPair& fine) {
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i)
    EXPECT_EQ(Vec2(fine.deformed().col(coarse.vertices[i])),
              Vec2(coarse.mesh.deformed().col(static_cast<Eigen::Index>(i))))
        << "vertex " << coarse.vertices[i];
}

TEST(Prolonged, TheIdentityStaysTheIdentity) {
  const MeshPair fine = fine_grid();
  const auto result = prolonged(coarsened(fine, {}, 200), fine, energy());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->flips, 0);
  EXPECT_TRUE(result->mesh.triangles() == fine.triangles());
  EXPECT_LE((result->mesh.deformed() - fine.rest()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Prolonged, NothingComesOfItWhereAStopIsRequested) {
  const MeshPair fine = fine_grid();
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_FALSE(prolonged(coarsened(fine, {}, 200), fine, energy(), stopped.get_token()));
}

TEST(Prolonged, AnAffineMapIsReproducedWithoutAFlip) {
  const MeshPair fine = fine_grid();
  CoarseMesh coarse = coarsened(fine, {}, 200);
  Mat2 map;
  map << 2, 0.7, -0.3, 0.4;
  coarse.mesh.set_deformed((map * coarse.mesh.rest()).colwise() + Vec2(3, -1));
  const auto result = prolonged(coarse, fine, energy());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->flips, 0);
  const Points expected = (map * fine.rest()).colwise() + Vec2(3, -1);
  EXPECT_LE((result->mesh.deformed() - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Prolonged, CreasesThatWouldFoldFineTrianglesBecomeEdges) {
  int folded = 0, flips = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair fine = fine_grid();
    CoarseMesh coarse = coarsened(fine, {}, 150);
    crease(coarse, random);
    const auto result = prolonged(coarse, fine, energy());
    ASSERT_TRUE(result);
    EXPECT_TRUE(test::is_valid(result->mesh));
    EXPECT_EQ(result->mesh.rest(), fine.rest());
    EXPECT_EQ(result->mesh.edge_count(), fine.edge_count());
    expect_shared_vertices_agree(coarse, result->mesh);
    folded += check_injectivity(fine.triangles(), result->mesh.deformed()).inverted;
    flips += result->flips;
  }
  EXPECT_GT(folded, 20) << "of the fine triangles without flips: the claim would be empty";
  EXPECT_GT(flips, 20);
}

TEST(Prolonged, RandomMeshesComeOutValidWithTheirSharedVerticesInPlace) {
  int came_out = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair fine = pair_of_shape(test::random_shape(random));
    CoarseMesh coarse = coarsened(fine, {}, fine.vertex_count() / 2);
    crease(coarse, random);
    const auto result = prolonged(coarse, fine, energy());
    if (!result) continue;
    ++came_out;
    EXPECT_TRUE(test::is_valid(result->mesh));
    EXPECT_EQ(result->mesh.rest(), fine.rest());
    expect_shared_vertices_agree(coarse, result->mesh);
  }
  EXPECT_GE(came_out, 95);
}

TEST(Prolonged, ADomainThatLiesOverItselfKeepsItsSheetsApart) {
  const int columns = 240;
  const MeshPair fine = pair_of_shape(test::wound_strip(columns, 12, 2.5));
  CoarseMesh coarse = coarsened(fine, {}, 900);
  // Unwound: where a vertex goes tells its sheet.
  const auto unwound = [&](int v) { return Vec2(v % (columns + 1), v / (columns + 1)); };
  Points u(2, coarse.mesh.vertex_count());
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i)
    u.col(static_cast<Eigen::Index>(i)) = unwound(coarse.vertices[i]);
  coarse.mesh.set_deformed(u);
  const auto result = prolonged(coarse, fine, energy());
  ASSERT_TRUE(result);
  for (int v = 0; v < fine.vertex_count(); ++v)
    EXPECT_LT((result->mesh.deformed().col(v) - unwound(v)).norm(), 3) << "vertex " << v;
}

/// A square whose diagonal was split in the coarse mesh, so that the crease there cannot become
/// edges of the fine one: the new vertex goes by `way` to the lower right. The fine triangle 4 5 6
/// has two corners on the diagonal and one close above its middle.
struct SplitCrease {
  explicit SplitCrease(double way) {
    const auto square = test::unit_square();
    coarse = {MeshPair(square.triangles, square.rest), {0, 1, 2, 3}};
    const int middle = coarse.mesh.split_edge(coarse.mesh.find_edge(0, 2).value(), 0.5);
    Points u = coarse.mesh.rest();
    u.col(middle) += Vec2(way, -way);
    coarse.mesh.set_deformed(u);
    Points rest(2, 7);
    rest << square.rest, Vec2(0.3, 0.3), Vec2(0.7, 0.7), Vec2(0.5, 0.52);
    Triangles triangles(3, 8);
    triangles << 4, 0, 1, 1, 2, 3, 3, 3,  //
        5, 1, 5, 2, 3, 6, 4, 0,           //
        6, 4, 4, 5, 5, 5, 6, 4;
    fine = MeshPair(triangles, rest);
  }
  CoarseMesh coarse;
  MeshPair fine;
};

void expect_mended(const SplitCrease& crease, double delta) {
  ASSERT_TRUE(test::is_valid(crease.fine) && test::is_valid(crease.coarse.mesh));
  const auto result = prolonged(crease.coarse, crease.fine, energy(delta));
  ASSERT_TRUE(result);
  EXPECT_TRUE(test::is_valid(result->mesh));
  EXPECT_EQ(result->splits, 1);
  ASSERT_EQ(result->mesh.vertex_count(), 8);
  EXPECT_EQ(result->mesh.rest().leftCols(7), crease.fine.rest());
  EXPECT_EQ(Vec2(result->mesh.rest().col(7)), Vec2(0.5, 0.5));
  EXPECT_EQ(result->mesh.deformed().col(7), crease.coarse.mesh.deformed().col(4));
  for (const int v : {4, 5}) EXPECT_TRUE(result->mesh.find_edge(v, 7)) << "along the crease";
}

TEST(Prolonged, WhereACreaseAtAVertexOfASplitFoldsTheFineMeshItGetsThatVertex) {
  expect_mended(SplitCrease(0.05), 1e-5);
}

TEST(Prolonged, WhereTheFineMeshLeavesTheFeasibleSetWithoutAFoldItGetsThatVertex) {
  const SplitCrease flat(0.026);  // A′/A = 0.064
  expect_mended(flat, 0.1);
  const auto feasible = prolonged(flat.coarse, flat.fine, energy(0.01));
  ASSERT_TRUE(feasible);
  EXPECT_EQ(feasible->splits, 0) << "what is valid is not mended";
}

TEST(Prolonged, CoarseMeshesThatWereSplitComeOutToo) {
  int splits = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair fine = fine_grid();
    CoarseMesh coarse = coarsened(fine, {}, 150);
    for (int i = 0; i < 20; ++i) {
      const auto edges = static_cast<std::uint64_t>(coarse.mesh.edge_count());
      coarse.mesh.split_edge(static_cast<int>(random() % edges), 0.5);
    }
    crease(coarse, random);
    const auto result = prolonged(coarse, fine, energy());
    ASSERT_TRUE(result);
    EXPECT_TRUE(test::is_valid(result->mesh));
    EXPECT_EQ(result->mesh.rest().leftCols(fine.vertex_count()), fine.rest());
    EXPECT_EQ(result->splits, result->mesh.vertex_count() - fine.vertex_count());
    expect_shared_vertices_agree(coarse, result->mesh);
    splits += result->splits;
  }
  EXPECT_GT(splits, 20) << "the claim would be empty";
}

TEST(Prolonged, IsNothingWhereTheCoarseMapFolds) {
  // Where the coarse mesh is outside of the feasible set no energy is asked for: only the proof
  // tells.
  const MeshPair fine = fine_grid(8);
  CoarseMesh coarse = coarsened(fine, {}, 40);
  ASSERT_TRUE(prolonged(coarse, fine, energy()));
  int inside = 0;
  while (coarse.mesh.is_boundary_vertex(inside)) ++inside;
  Points u = coarse.mesh.rest();
  u.col(inside) += Vec2(2, 0);
  coarse.mesh.set_deformed(u);
  EXPECT_FALSE(prolonged(coarse, fine, energy()));
}

TEST(Prolonged, IsNothingWhereABoundaryVertexOfTheCoarseMapOverlapsItself) {
  const test::Fixture f = test::notched_disk(0.4);
  const MeshPair fine(f.triangles, f.rest);
  CoarseMesh coarse = coarsened(fine, {}, fine.vertex_count());
  coarse.mesh.set_deformed(test::with_notch(f.rest, 0.4, 0.1));
  ASSERT_TRUE(prolonged(coarse, fine, energy()));
  coarse.mesh.set_deformed(test::with_notch(f.rest, 0.4, -0.1));
  EXPECT_FALSE(prolonged(coarse, fine, energy()));
}

TEST(Prolonged, WhereABoundaryVertexOverlapsItselfTheBoundaryGetsTheVertexOfASplit) {
  const test::Fixture f = test::notched_disk(0.4);
  const MeshPair fine(f.triangles, f.rest);
  CoarseMesh coarse = coarsened(fine, {}, fine.vertex_count());
  coarse.mesh.set_deformed(test::with_notch(f.rest, 0.4, 0.1));
  const int split = coarse.mesh.split_edge(coarse.mesh.find_edge(0, 1).value(), 0.5);
  Points u = coarse.mesh.deformed();
  u.col(1) = 0.5 * Vec2(std::cos(0.1), -std::sin(0.1));  // across the notch, but not at its tip
  coarse.mesh.set_deformed(u);
  ASSERT_TRUE(test::is_valid(coarse.mesh));
  ASSERT_EQ(overlapping_boundary_vertices(f.triangles, u), std::vector<int>{0});
  const auto result = prolonged(coarse, fine, energy());
  ASSERT_TRUE(result);
  EXPECT_TRUE(test::is_valid(result->mesh));
  EXPECT_EQ(result->splits, 1);
  EXPECT_EQ(result->mesh.deformed(), coarse.mesh.deformed());
  EXPECT_TRUE(result->mesh.is_boundary_vertex(split));
}

TEST(Prolonged, ACreaseIsTheSameMapOnceItsEdgesAreInserted) {
  // A square with a crease along its diagonal, under a fine grid whose diagonals all go the other
  // way.
  Points rest(2, 4);
  rest << 0, 1, 0, 1,  //
      0, 0, 1, 1;
  Triangles triangles(3, 2);
  triangles << 0, 0,  //
      1, 3,           //
      3, 2;
  Points u = rest;
  u.col(1) = Vec2(-0.6, -0.8);  // more than half of a turn from vertex 2
  const Shape shape = grid({.columns = 7, .rows = 7, .diagonal = Diagonal::falling});
  const MeshPair fine = pair_of_shape(shape);
  const CoarseMesh coarse{MeshPair(triangles, rest, u), {0, 7, 56, 63}};
  const auto result = prolonged(coarse, fine, energy());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->flips, 7) << "one in every cell of the diagonal";
  EXPECT_TRUE(test::is_valid(result->mesh));
  for (int i = 0; i < 7; ++i) EXPECT_TRUE(result->mesh.find_edge(9 * i, 9 * (i + 1)));
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/flip_edges.h"

#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "core/remesh/diamond_energy.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

FlipSettings settings() { return {{find_density("arap"), 5e7, 0.01, 1e-5, true}, 1e-3, true}; }

/// A unit square that was sheared along its diagonal, so that the other diagonal is shorter.
MeshPair sheared_square() {
  const auto f = test::unit_square();
  Points deformed = f.rest;
  deformed.col(2) += Vec2(0.8, 0.8);
  return {f.triangles, f.rest, deformed};
}

Unknowns all_unknown(const MeshPair& mesh) { return unknowns_of(mesh, {0}); }

TEST(FlipEdges, LeavesTheRestStateAlone) {
  const auto f = test::square_grid(6);
  MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(flip_edges(mesh, all_unknown(mesh), settings()), 0);
  EXPECT_EQ(mesh.triangles(), f.triangles);
}

TEST(FlipEdges, FlipsTheDiagonalThatCostsMore) {
  MeshPair mesh = sheared_square();
  const Diamond diamond = mesh.diamond(mesh.find_edge(0, 2).value());
  const double before = energy_of(mesh, triangles_of(diamond), settings().energy);
  const double after = energy_of(mesh, flipped_triangles_of(diamond), settings().energy);
  FlipSettings untested = settings();
  untested.condition_test = false;
  const int flips = flip_edges(mesh, all_unknown(mesh), untested);
  EXPECT_EQ(flips, after < before * (1 - untested.eta) ? 1 : 0);
  EXPECT_EQ(mesh.find_edge(1, 3).has_value(), flips == 1);
}

TEST(FlipEdges, TheConditionTestOnlyEverCancelsFlips) {
  MeshPair tested = sheared_square();
  MeshPair untested = sheared_square();
  FlipSettings off = settings();
  off.condition_test = false;
  EXPECT_LE(flip_edges(tested, all_unknown(tested), settings()),
            flip_edges(untested, all_unknown(untested), off));
}

TEST(FlipEdges, NeverFlipsTowardsATriangleThatIsNotPositiveInTheRestMesh) {
  // The quad 0 1 2 3 has a right angle of 180° at vertex 1: flipped, (1, 2, 3) and (0, 1, 3) would
  // be fine in the deformed mesh, but the rest triangle with 0, 1, 2 on a line is degenerate.
  Points rest(2, 4);
  rest << 0, 1, 2, 1,  //
      0, 0, 0, 1;
  Triangles triangles(3, 2);
  triangles << 0, 1,  //
      1, 2,           //
      3, 3;
  Points deformed = rest;
  deformed.col(1) = Vec2(1, -2);
  MeshPair mesh(triangles, rest, deformed);
  const Diamond diamond = mesh.diamond(mesh.find_edge(1, 3).value());
  EXPECT_FALSE(is_feasible(mesh, flipped_triangles_of(diamond), 1e-5));
  FlipSettings eager = settings();
  eager.condition_test = false;
  EXPECT_EQ(flip_edges(mesh, all_unknown(mesh), eager), 0);
}

TEST(FlipEdges, LeavesComponentsWithoutAHandleAlone) {
  MeshPair mesh = sheared_square();
  FlipSettings eager = settings();
  eager.condition_test = false;
  EXPECT_EQ(flip_edges(mesh, unknowns_of(mesh, {}), eager), 0);
}

TEST(DiamondEnergy, ConditionIsTheSameForAScaledEnergy) {
  const MeshPair mesh = sheared_square();
  const Diamond diamond = mesh.diamond(mesh.find_edge(0, 2).value());
  EnergySettings weighted = settings().energy;
  weighted.beta = 0;
  EnergySettings unweighted = weighted;
  unweighted.area_weighted = false;  // both rest triangles have area ½: twice the energy
  const double condition = condition_of(mesh, triangles_of(diamond), diamond, weighted);
  EXPECT_GT(condition, 0);
  EXPECT_DOUBLE_EQ(condition_of(mesh, triangles_of(diamond), diamond, unweighted), condition);
}

}  // namespace
}  // namespace foldless

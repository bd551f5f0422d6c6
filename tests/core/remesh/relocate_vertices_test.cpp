// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/relocate_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <stop_token>
#include <vector>

#include "core/energy/densities.h"
#include "core/remesh/diamond_energy.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/core/remesh/one_ring.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

EnergySettings symmetric_dirichlet() {
  return {.density = find_density("symmetric-dirichlet"), .beta = 0};
}

double total(const MeshPair& mesh, const EnergySettings& energy) {
  double sum = 0;
  for (const Eigen::Vector3i& t : mesh.triangles().colwise())
    sum += energy_of(mesh, std::array<Eigen::Vector3i, 1>{t}, energy);
  return sum;
}

TEST(RelocateVertices, LowersTheEnergyByWhatItSaysAndKeepsEveryMapValid) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const test::OwnWorkspace own = test::arrived_workspace(seed, 12);
    RelocateSettings settings{own.work.held_energy().settings, own.settings.first_removable};
    settings.energy.conformal_weight = seed % 2 == 0 ? 1e-3 : 0;
    const MeshPair& before = own.work.mesh;
    MeshPair mesh = before;
    const double fall = relocate_vertices(mesh, settings);
    EXPECT_TRUE(test::is_valid(mesh));
    EXPECT_EQ(mesh.triangles(), before.triangles());
    EXPECT_EQ(fall > 0, mesh.revision() != before.revision());
    const double energy = total(before, settings.energy);
    EXPECT_NEAR(total(mesh, settings.energy), energy - fall, 1e-9 * energy);
    moved += fall > 1e-3 * energy;
  }
  EXPECT_GT(moved, 30) << "the claim would be empty";
}

double least_relative_height(const MeshPair& mesh) {
  double least = 1;
  for (const Eigen::Vector3i& t : mesh.triangles().colwise())
    least = std::min(least, relative_height_at_rest(mesh, t));
  return least;
}

TEST(RelocateVertices, MakesNoTriangleNextToDegenerateAtRest) {
  int asked = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const test::OwnWorkspace own = test::arrived_workspace(seed, 12);
    MeshPair mesh = own.work.mesh;
    const double before = least_relative_height(mesh);
    const double fall =
        relocate_vertices(mesh, {own.work.held_energy().settings, own.settings.first_removable});
    EXPECT_GE(least_relative_height(mesh), std::min(before, 1e-3));
    asked += fall > 0 && before > 1e-2;
  }
  EXPECT_GT(asked, 20) << "the claim would be empty";
}

TEST(RelocateVertices, LeavesOriginalVerticesAndThoseOfTheBoundaryWhereTheyAre) {
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const test::OwnWorkspace own = test::arrived_workspace(seed, 12);
    const MeshPair& before = own.work.mesh;
    const int first = own.settings.first_removable;
    MeshPair mesh = before;
    relocate_vertices(mesh, {own.work.held_energy().settings, first});
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const bool may_move = v >= first && !before.is_boundary_vertex(v);
      if (!may_move) {
        EXPECT_EQ(mesh.rest().col(v), before.rest().col(v));
        EXPECT_EQ(mesh.deformed().col(v), before.deformed().col(v));
      }
      inside += may_move && mesh.rest().col(v) != before.rest().col(v);
    }
  }
  EXPECT_GT(inside, 20) << "the claim would be empty";
}

// The way there is one of those on which the map, which is conformal, does not change.
TEST(RelocateVertices, BringsTheVertexOfASimilarityBackToWhereItBelongs) {
  for (const double x : {-0.9, -0.3, 0.5, 0.99}) {
    SCOPED_TRACE(x);
    MeshPair mesh = test::one_ring({{1, -1}, {1, 1}, {-1, 1}, {-1, -1}});
    mesh.set_deformed(3 * mesh.rest());
    mesh.move_vertex(0, Vec2(x, -0.2 * x), Vec2(0.1, 0.4));
    const double fall = relocate_vertices(mesh, {symmetric_dirichlet()});
    EXPECT_GT(fall, 0);
    EXPECT_TRUE(test::is_valid(mesh));
    EXPECT_LT((mesh.deformed().col(0) - 3 * mesh.rest().col(0)).norm(), 1e-3);
  }
}

TEST(RelocateVertices, LeavesNoPlaceThatIsBetterInEitherMesh) {
  // Twice as wide to the right of x = 0.3.
  MeshPair mesh = test::one_ring({{0.3, -1}, {1, -1}, {1, 1}, {0.3, 1}, {-1, 1}, {-1, -1}});
  Points deformed = mesh.rest();
  for (double& x : deformed.row(0)) x += std::max(0.0, x - 0.3);
  mesh.set_deformed(deformed);
  const EnergySettings energy = symmetric_dirichlet();
  const double fall = relocate_vertices(mesh, {energy});
  EXPECT_GT(fall, 0.01 * total(mesh, energy));
  const double least = total(mesh, energy);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-0.2, 0.2);
  for (int trial = 0; trial < 1000; ++trial) {
    MeshPair other = mesh;
    other.move_vertex(0, mesh.rest().col(0) + Vec2(unit(random), unit(random)),
                      mesh.deformed().col(0) + Vec2(unit(random), unit(random)));
    EXPECT_GE(total(other, energy), least * (1 - 1e-6));
  }
}

TEST(RelocateVertices, MovesNothingOnceAStopIsRequested) {
  std::stop_source stopped;
  stopped.request_stop();
  const test::OwnWorkspace own = test::arrived_workspace(5, 12);
  MeshPair mesh = own.work.mesh;
  EXPECT_EQ(relocate_vertices(mesh, {own.work.held_energy().settings, own.settings.first_removable},
                              stopped.get_token()),
            0);
  EXPECT_EQ(mesh.revision(), own.work.mesh.revision());
}

TEST(RelocateVertices, EndsWhenASweepBringsLessThanItIsToBring) {
  const test::OwnWorkspace own = test::arrived_workspace(5, 12);
  const EnergySettings energy = own.work.held_energy().settings;
  MeshPair once = own.work.mesh, often = own.work.mesh;
  const int first = own.settings.first_removable;
  const double fall =
      relocate_vertices(once, {energy, first, std::numeric_limits<double>::infinity()});
  EXPECT_GT(fall, 0);
  EXPECT_GT(relocate_vertices(often, {energy, first}), fall);
}

}  // namespace
}  // namespace foldless

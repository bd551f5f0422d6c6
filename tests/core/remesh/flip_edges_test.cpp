// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/flip_edges.h"

#include <gtest/gtest.h>

#include <random>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "core/remesh/diamond_energy.h"
#include "core/threads/team.h"
#include "tests/core/remesh/reference_flips.h"
#include "tests/support/meshes.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

FlipSettings settings() { return {{find_density("arap"), 5e7, 0.01, 1e-5, true}, 1e-3, true}; }

FlipSettings eager() {
  FlipSettings result = settings();
  result.condition_test = false;
  return result;
}

/// A unit square with vertex 1 close above the diagonal 0–2, so that the other one is better.
MeshPair dented_square() {
  const auto f = test::unit_square();
  Points deformed = f.rest;
  deformed.col(1) = Vec2(0.55, 0.45);
  return {f.triangles, f.rest, deformed};
}

int diagonal_of(const MeshPair& mesh) { return mesh.find_edge(0, 2).value(); }

TEST(FlipEdges, LeavesTheRestStateAlone) {
  const auto f = test::square_grid(6);
  MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(flip_edges(mesh, eager()), 0);
  EXPECT_EQ(mesh.triangles(), f.triangles);
}

TEST(FlipEdges, FlipsTheDiagonalThatCostsMore) {
  MeshPair mesh = dented_square();
  ASSERT_GT(test::flip_candidate(mesh, diagonal_of(mesh), settings().energy).gain, 0.01);
  EXPECT_EQ(flip_edges(mesh, eager()), 1);
  EXPECT_TRUE(mesh.find_edge(1, 3).has_value());
  EXPECT_TRUE(test::is_valid(mesh));
  EXPECT_EQ(flip_edges(mesh, eager()), 0) << "and not back";
}

TEST(FlipEdges, AGainBelowEtaFlipsNothing) {
  const MeshPair dented = dented_square();
  const auto c = test::flip_candidate(dented, diagonal_of(dented), settings().energy);
  for (const double part : {0.999, 1.001}) {
    FlipSettings close = eager();
    close.eta = part * c.gain / c.energy;
    MeshPair mesh = dented;
    EXPECT_EQ(flip_edges(mesh, close), part < 1 ? 1 : 0) << part;
  }
}

TEST(FlipEdges, AllGainsTogetherBelowTheLeastFlipNothing) {
  const MeshPair tangled = test::tangled_pair(5);
  double gain = 0, energy = 0;
  for (int e = 0; e < tangled.edge_count(); ++e)
    if (!tangled.is_boundary_edge(e)) {
      const auto c = test::flip_candidate(tangled, e, settings().energy);
      if (c.gain > settings().eta * c.energy) gain += c.gain;
    }
  for (const auto& t : tangled.triangles().colwise())
    energy += test::arap_energy(corners_of(tangled.rest(), t), corners_of(tangled.deformed(), t),
                                settings().energy);
  for (const double part : {0.999, 1.001}) {
    FlipSettings close = eager();
    close.least_total_gain = part * gain / energy;
    MeshPair mesh = tangled;
    EXPECT_EQ(flip_edges(mesh, close) > 0, part < 1) << part;
  }
}

TEST(FlipEdges, AreThoseOfThePaperOneByOne) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    for (const bool condition_test : {true, false}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << (condition_test ? ", tested" : ""));
      FlipSettings some = settings();
      some.eta = seed % 2 ? 1e-3 : 0.1;
      some.energy.delta = seed % 3 ? 1e-5 : 0.04;
      some.condition_test = condition_test;
      MeshPair mesh = test::tangled_pair(seed), expected = mesh;
      const int flips = test::reference_flips(expected, some, {.condition = condition_test});
      EXPECT_EQ(flip_edges(mesh, some), flips);
      EXPECT_EQ(mesh.triangles(), expected.triangles());
      EXPECT_TRUE(test::is_valid(mesh));
    }
}

/// Those scenes, flipped by some rules.
std::vector<MeshPair> flipped_scenes(const test::FlipRules& rules) {
  std::vector<MeshPair> scenes;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    FlipSettings some = settings();
    some.eta = seed % 2 ? 1e-3 : 0.1;
    test::reference_flips(scenes.emplace_back(test::tangled_pair(seed)), some, rules);
  }
  return scenes;
}

TEST(FlipEdges, EveryRuleOfThePaperChangesSomeOfTheseScenes) {
  const std::vector<MeshPair> whole = flipped_scenes({});
  const auto scenes_that_differ = [&](const test::FlipRules& rules) {
    const std::vector<MeshPair> without = flipped_scenes(rules);
    int differ = 0;
    for (std::size_t k = 0; k < whole.size(); ++k)
      differ += without[k].triangles() != whole[k].triangles();
    return differ;
  };
  EXPECT_EQ(scenes_that_differ({}), 0);
  EXPECT_GT(scenes_that_differ({.descending = false}), 5);
  EXPECT_GT(scenes_that_differ({.drops_neighbours = false}), 5);
  EXPECT_GT(scenes_that_differ({.condition = false}), 5);
  EXPECT_GT(scenes_that_differ({.reversed_condition = true}), 5);
  EXPECT_GT(scenes_that_differ({.eta = false}), 2);
}

TEST(FlipEdges, EFallsByNoLessThanEveryFlipPromises) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    MeshPair mesh = test::tangled_pair(seed);
    const auto energy = [&] {
      double sum = 0;
      for (const auto& t : mesh.triangles().colwise())
        sum += test::arap_energy(corners_of(mesh.rest(), t), corners_of(mesh.deformed(), t),
                                 settings().energy);
      return sum;
    };
    const double before = energy();
    const int flips = flip_edges(mesh, eager());
    EXPECT_EQ(energy() < before, flips > 0);
    EXPECT_LE(energy(), before);
    EXPECT_TRUE(test::is_valid(mesh));
  }
}

/// A quad whose diagonal 1–3 stands on a point of the line 0–2 but for `height`; in the deformed
/// mesh it bulges there and vertex 2 nearly lies on the diagonal, which is what flips it.
MeshPair nearly_collinear(double height) {
  Points rest(2, 4), deformed(2, 4);
  rest << 0, 1, 2, 1,  //
      0, -height, 0, 1;
  deformed << 0, 1, 1.001, 1,  //
      0, -1, 0, 1;
  Triangles triangles(3, 2);
  triangles << 0, 1,  //
      1, 2,           //
      3, 3;
  return {triangles, rest, deformed};
}

TEST(FlipEdges, AreTheSameWithAnyNumberOfThreads) {
  const auto f = test::square_grid(40);
  Points deformed = f.rest;
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-0.24, 0.24);  // of a side of a cell
  for (double& x : deformed.reshaped()) x += shake(random);
  MeshPair alone(f.triangles, f.rest, deformed), shared = alone;
  const int flips = flip_edges(alone, settings());
  ASSERT_GT(flips, 100);
  Team team(3);
  const WithTeam with(&team);
  EXPECT_EQ(flip_edges(shared, settings()), flips);
  EXPECT_EQ(shared.triangles(), alone.triangles());
}

TEST(FlipEdges, MakeNoNeedlesInTheRestMesh) {
  FlipSettings pressing = eager();
  pressing.energy.beta = 1e9;  // so much is gained that a needle's distortion would not matter
  MeshPair needle = nearly_collinear(1e-6), thin = nearly_collinear(1e-5);
  ASSERT_TRUE(test::is_valid(needle));
  ASSERT_GT(test::flip_candidate(needle, needle.find_edge(1, 3).value(), pressing.energy).gain, 1);
  EXPECT_EQ(flip_edges(needle, pressing), 0);
  EXPECT_EQ(flip_edges(thin, pressing), 1);
}

TEST(FlipEdges, MakeNoTriangleThatIsNotPositive) {
  // One and the other mesh is a dart, whose second diagonal lies outside.
  const auto f = test::unit_square();
  Points dart = f.rest;
  dart.col(2) = Vec2(0.3, 0.3);
  for (const auto& [rest, deformed] :
       {std::pair(f.rest, dart), std::pair(dart, f.rest), std::pair(dart, dart)}) {
    MeshPair mesh(f.triangles, rest, deformed);
    FlipSettings pressing = eager();
    pressing.eta = 0;
    EXPECT_EQ(flip_edges(mesh, pressing), 0);
    const TrianglePair flipped = flipped_triangles_of(mesh.diamond(diagonal_of(mesh)));
    EXPECT_FALSE(is_feasible(mesh, flipped, 1e-5));
    EXPECT_EQ(is_positive_at_rest(mesh, flipped), rest == f.rest);
  }
}

TEST(FlipEdges, KeepTheBoundOnAreas) {
  const MeshPair mesh = dented_square();  // flipped, both triangles have 0.55 of their area
  const TrianglePair flipped = flipped_triangles_of(mesh.diamond(diagonal_of(mesh)));
  EXPECT_TRUE(is_feasible(mesh, flipped, 0.54));
  EXPECT_FALSE(is_feasible(mesh, flipped, 0.56));
}

TEST(DiamondEnergy, IsThatOfTheSingularValuesAndItsConditionThatOfDifferences) {
  const MeshPair mesh = dented_square();
  const Diamond diamond = mesh.diamond(diagonal_of(mesh));
  for (const bool weighted : {true, false})
    for (const bool barrier_weighted : {true, false}) {
      EnergySettings energy = settings().energy;
      energy.area_weighted = weighted;
      energy.unit_area = 3;
      energy.barrier_area_weighted = barrier_weighted;
      const auto c = test::flip_candidate(mesh, diagonal_of(mesh), energy);
      EXPECT_NEAR(energy_of(mesh, triangles_of(diamond), energy), c.energy, 1e-12);
      EXPECT_NEAR(energy_of(mesh, flipped_triangles_of(diamond), energy), c.energy - c.gain, 1e-12);
      for (const bool flipped : {false, true}) {
        const double expected = test::condition(mesh, flipped ? c.flipped : c.now, energy);
        EXPECT_NEAR(
            condition_of(mesh, flipped ? flipped_triangles_of(diamond) : triangles_of(diamond),
                         diamond, energy),
            expected, 1e-6 * expected);
      }
    }
}

TEST(DiamondEnergy, ConditionIsTheSameForAScaledEnergy) {
  const MeshPair mesh = dented_square();
  const Diamond diamond = mesh.diamond(diagonal_of(mesh));
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

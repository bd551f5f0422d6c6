// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/energy/conformal_power.h"
#include "core/mesh/generate.h"
#include "core/mesh/quality.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::arrived_workspace;
using test::OwnWorkspace;
using test::StageRunner;

Quality shape_of(const MeshPair& mesh) {
  return quality_of(mesh.triangles(), mesh.rest(), mesh.deformed());
}

Quality settled_quality(std::uint64_t seed, double exponent) {
  OwnWorkspace own = arrived_workspace(seed);
  test::run_to_the_end(settle(own.work, {.exponent = exponent}));
  return shape_of(own.work.mesh);
}

/// Of every step of a settling, after which both meshes are valid.
void expect_falling_merit(Workspace& work) {
  double merit = merit_of(work);
  StageRunner<void> runner(settle(work));
  while (!runner.has_ended()) {
    runner.step();
    EXPECT_LE(merit_of(work), merit * (1 + 1e-9));
    EXPECT_TRUE(test::is_valid(work.mesh));
    merit = merit_of(work);
  }
}

// Sums over large meshes are taken in parts.
TEST(Settle, MeritCountsAllTrianglesOfALargeMeshAlike) {
  const Shape shape = grid({.columns = 100, .rows = 100, .width = 1, .height = 1});
  Points u = shape.rest;  // the farther to the right, the flatter
  u.row(0) = shape.rest.row(0).array() - 0.4 * shape.rest.row(0).array().square();
  const OwnWorkspace own =
      test::workspace_of(MeshPair(shape.triangles, shape.rest, u), {Handle{.vertex = 0}});
  double sum = 0;
  for (const auto& t : shape.triangles.colwise())
    sum += conformal_power_value(deformation_gradient(shape.rest, u, t), 2);
  const double mean = sum / static_cast<double>(shape.triangles.cols());
  ASSERT_GT(mean, 1.05) << "the claim would be empty";
  EXPECT_NEAR(merit_of(own.work, 1) / settled_energy(own.work), mean, 1e-12 * mean);
}

TEST(Settle, NeverRaisesEnergyTimesDistortionAndStaysValid) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = arrived_workspace(seed);
    expect_falling_merit(own.work);
  }
}

TEST(Settle, HoldsTheHandlesWhereTheyAre) {
  OwnWorkspace own = arrived_workspace(3);
  test::run_to_the_end(settle(own.work));
  EXPECT_EQ(own.work.error(), 0);
}

TEST(Settle, LeavesFewFlipsThatWouldGainSomething) {
  int left = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = arrived_workspace(seed);
    test::run_to_the_end(settle(own.work, {.exponent = 0}));
    left += own.work.flip_edges(own.work.held_energy().settings);
  }
  EXPECT_LT(left, 40) << "fewer than one a mesh";
}

TEST(Settle, ALargerExponentLowersTheDistortions) {
  constexpr int kSeeds = 200;
  int lower_mean = 0, lower_max = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Quality plain = settled_quality(seed, 0);
    const Quality better = settled_quality(seed, 0.2);
    lower_mean += better.mean_conformal_distortion < plain.mean_conformal_distortion;
    lower_max += better.max_conformal_distortion < plain.max_conformal_distortion;
  }
  // Three of four; either comes to four of five.
  EXPECT_GE(lower_mean, 0.75 * kSeeds);
  EXPECT_GE(lower_max, 0.75 * kSeeds);
}

TEST(Settle, AHigherPowerLowersTheLargestDistortion) {
  constexpr int kSeeds = 100;
  int lower = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto largest = [&](int power) {
      OwnWorkspace own = arrived_workspace(seed);
      test::run_to_the_end(settle(own.work, {.exponent = 0.4, .power = power}));
      EXPECT_TRUE(test::is_valid(own.work.mesh));
      return shape_of(own.work.mesh).max_conformal_distortion;
    };
    lower += largest(16) < largest(2);
  }
  EXPECT_GE(lower, 0.75 * kSeeds);
}

/// What settling ends with.
struct Settled {
  double energy, largest;
};

Settled settled_with(std::uint64_t seed, const SettleSettings& settings) {
  OwnWorkspace own = arrived_workspace(seed);
  test::run_to_the_end(settle(own.work, settings));
  EXPECT_TRUE(test::is_valid(own.work.mesh));
  return {settled_energy(own.work), shape_of(own.work.mesh).max_conformal_distortion};
}

TEST(Settle, BelowTheDistortionThatIsEnoughItLowersTheEnergyAlone) {
  constexpr int kSeeds = 40;
  int same = 0, dearer = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double energy = settled_with(seed, {.exponent = 0}).energy;
    SettleSettings settings{.exponent = 8, .power = 16};
    dearer += settled_with(seed, settings).energy > 1.01 * energy;
    settings.enough = 2 * shape_of(arrived_workspace(seed).work.mesh).max_conformal_distortion;
    same += std::abs(settled_with(seed, settings).energy - energy) <= 1e-3 * energy;
  }
  EXPECT_GE(same, 0.9 * kSeeds);
  EXPECT_GE(dearer, 0.5 * kSeeds) << "the claim would be empty";
}

TEST(Settle, LowersTheLargestDistortionToWhatIsEnoughForNoMoreEnergyThanItTakes) {
  constexpr int kSeeds = 60;
  int could = 0, did = 0, cheaper = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SettleSettings settings{.exponent = 8, .power = 16};
    const double before = settled_with(seed, {.exponent = 0}).largest;
    const Settled least = settled_with(seed, settings);
    if (least.largest > 0.5 * before) continue;
    settings.enough = 0.4 * before;  // k is half of σ₁/σ₂, or a little more
    const Settled settled = settled_with(seed, settings);
    ++could;
    did += settled.largest <= 0.9 * before;
    cheaper += settled.energy < least.energy;
  }
  EXPECT_GE(could, 10) << "the claim would be empty";
  EXPECT_GE(did, 0.9 * could);
  EXPECT_GE(cheaper, 0.9 * could);
}

TEST(Settle, MovesVerticesOfSplitsAtRestAndNoOthers) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = arrived_workspace(seed, 10);
    const int first = own.settings.first_removable;
    const Points before = own.work.mesh.rest();
    expect_falling_merit(own.work);
    const Points& rest = own.work.mesh.rest();
    EXPECT_EQ(rest.leftCols(first), before.leftCols(first));
    moved += rest.rightCols(rest.cols() - first) != before.rightCols(rest.cols() - first);
  }
  EXPECT_GE(moved, 15);
}

TEST(Settle, LeavesBothMeshesAsTheyAreWhereAStepIsCancelled) {
  int cancelled = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = arrived_workspace(seed, 10);
    const MeshPair& mesh = own.work.mesh;
    StageRunner<void> runner(settle(own.work));
    Points rest = mesh.rest(), deformed = mesh.deformed();
    cancelled += test::run_with_cancels(runner, seed, [&](bool was_cancelled) {
      if (was_cancelled) {
        EXPECT_EQ(mesh.rest(), rest);
        EXPECT_EQ(mesh.deformed(), deformed);
      }
      rest = mesh.rest();
      deformed = mesh.deformed();
    });
  }
  EXPECT_GT(cancelled, 20) << "the claim would be empty";
}

/// A grid at rest but for a vertex next to the opposite edge of one of its triangles; in the map
/// that vertex is where it belongs. Its Jacobians are in the order of 1/height.
OwnWorkspace crushed_workspace(double height) {
  const Shape shape = grid({.columns = 8, .rows = 8, .width = 0.7, .height = 0.7});
  Points rest = shape.rest;
  const Vec2 foot = 0.5 * (rest.col(39) + rest.col(49));
  rest.col(40) = foot + height * (rest.col(40) - foot);
  const MeshPair mesh(shape.triangles, rest, shape.rest);
  const Constraints constraints =
      constraints_of({{.id = 0, .vertex = 0, .target = shape.rest.col(0)},
                      {.id = 1, .vertex = 80, .target = shape.rest.col(80)}});
  RunSettings settings = test::run_settings(find_density("green-strain"), mesh);
  settings.energy.delta = 1e-12;
  settings.energy.barrier_area_weighted = false;
  return {mesh, constraints, std::move(settings)};
}

TEST(Settle, FindsItsWayOutOfTrianglesThatAreNearlyCrushed) {
  for (const double height : {1e-2, 1e-4, 1e-6}) {
    SCOPED_TRACE(height);
    OwnWorkspace own = crushed_workspace(height);
    ASSERT_TRUE(test::is_valid(own.work.mesh));
    test::run_to_the_end(settle(own.work));
    EXPECT_LT(shape_of(own.work.mesh).max_conformal_distortion, 10);
  }
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/approach_refined.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/foldless/foldless.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/turn_along.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::run_to_the_end;

constexpr DiskOptions kDisk{.rings = 6, .boundary_vertices = 24, .vertices = 103};
constexpr int kInner = 3;
constexpr double kFortyDegrees = std::numbers::pi / 4.5;

/// A disk whose boundary and an inner ring are held, all of it moved a little.
Problem held_disk(std::uint64_t seed) {
  Shape shape = disk(kDisk);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> little(-1e-7, 1e-7);
  for (double& x : shape.rest.reshaped()) x += little(random);
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  for (const int ring : {kInner, kDisk.rings})
    for (const int v : disk_ring(kDisk, ring)) problem.handles.push_back(test::held(shape.rest, v));
  return problem;
}

void turn_inner_ring(Problem& problem, double angle) {
  const Eigen::Rotation2Dd turn(angle);
  for (std::size_t i = 0; i < disk_ring(kDisk, kInner).size(); ++i)
    problem.handles[i].target = turn * problem.mesh.rest().col(problem.handles[i].vertex);
}

// The other ways, from rest, would lead round the other side: not at all instead of by 360°.
TEST(ApproachRefined, ADragThatTurnsARingGoesOnTheWayItWent) {
  constexpr int kMoves = 9;
  int refined = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = held_disk(seed);
    Foldless method(problem);
    test::run_validly(method);
    for (int move = 1; move <= kMoves; ++move) {
      turn_inner_ring(problem, -move * kFortyDegrees);
      method.set_targets(constraints_of(problem.handles).targets);
      const int vertices = method.mesh().vertex_count();
      while (const auto record = method.step({}))
        if (method.mesh().vertex_count() > 2 * vertices) ++refined;
      ASSERT_EQ(method.outcome(), Outcome::gradient) << move;
    }
    const Points& rest = problem.mesh.rest();
    const Vec2 inner = rest.col(disk_ring(kDisk, kInner).front());
    const Vec2 outer = inner.normalized() * (1 - 1e-3) * rest.colwise().norm().maxCoeff();
    EXPECT_NEAR(test::turn_along(method.mesh(), inner, outer), kMoves * kFortyDegrees, 0.3);
  }
  EXPECT_GT(refined, 0) << "the claim would be empty";
}

TEST(ApproachRefined, LeavesTheMeshAsItWasWhereItLocks) {
  Problem problem = held_disk(1);
  problem.handles[0].target = problem.handles[1].target;  // no map has both there
  OwnWorkspace own = test::workspace_of(problem.mesh, problem.handles);
  EXPECT_EQ(run_to_the_end(approach_refined(own.work, problem.mesh)), Progress::locked);
  EXPECT_GT(own.effort.splits, 0);
  EXPECT_EQ(own.work.mesh.deformed(), problem.mesh.deformed());
}

}  // namespace
}  // namespace foldless

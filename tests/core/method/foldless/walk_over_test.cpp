// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/walk_over.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/curled_bar.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

constexpr double kFullTurn = 2 * std::numbers::pi;

MeshPair bar(double angle) {
  const Shape shape = test::flat_bar();
  return {shape.triangles, shape.rest, test::curled(shape.rest, angle)};
}

/// A bar that turns by three quarters on its way.
OwnWorkspace curled_workspace() {
  const MeshPair mesh = bar(0.75 * kFullTurn);
  return test::workspace_of(mesh, test::left_end(mesh.rest()));
}

TEST(WalkOver, UncurlsWithoutAFoldWhereAStraightWayWouldFold) {
  OwnWorkspace own = curled_workspace();
  const MeshPair to = bar(0);
  const Points straight = to.deformed() - own.work.mesh.deformed();
  ASSERT_LT(own.work.system.objective().largest_step(own.settings.energy, own.work.mesh.deformed(),
                                                     straight),
            1)
      << "the claim would be empty";
  StageRunner<void> runner(walk_over(own.work, to));
  while (runner.step()) EXPECT_TRUE(test::is_valid(own.work.mesh));
  EXPECT_EQ(runner.records().size(), std::size_t{kStepsOfAWalk});
  for (const Iteration& record : runner.records()) EXPECT_EQ(record.phase, Phase::walk);
  EXPECT_EQ(own.work.mesh.deformed(), to.deformed());
}

TEST(WalkOver, StopsLieSoCloseThatNothingFoldsBetweenThem) {
  const OwnWorkspace own = curled_workspace();
  const std::vector<Points> way = way_over(own.work, bar(0).deformed());
  ASSERT_EQ(way.size(), std::size_t{kStepsOfAWalk});
  Points here = own.work.mesh.deformed();
  for (const Points& stop : way) {
    EXPECT_GT(own.work.system.objective().largest_step(own.settings.energy, here, stop - here), 1);
    here = stop;
  }
}

TEST(WalkOver, IsOnTheTriangulationThatBearsBothMaps) {
  OwnWorkspace own = curled_workspace();
  MeshPair to = bar(0);
  for (int e = 0, flipped = 0; e < to.edge_count() && flipped < 10; ++e) {
    if (to.is_boundary_edge(e) || !to.is_flip_legal(e)) continue;
    MeshPair next = to;
    next.flip(e);
    if (!test::is_valid(next)) continue;
    to = next;
    ++flipped;
  }
  ASSERT_NE(to.triangles(), own.work.mesh.triangles());
  StageRunner<void> runner(walk_over(own.work, to));
  while (runner.step()) EXPECT_TRUE(test::is_valid(own.work.mesh));
  EXPECT_EQ(runner.records().size(), std::size_t{kStepsOfAWalk});
  EXPECT_EQ(own.work.mesh.triangles(), to.triangles());
  EXPECT_EQ(own.work.mesh.deformed(), to.deformed());
}

TEST(WalkOver, LeapsWhereTheMeshesHaveOtherVertices) {
  OwnWorkspace own = curled_workspace();
  MeshPair to = bar(0);
  to.split_edge(5, 0.4);
  StageRunner<void> runner(walk_over(own.work, to));
  EXPECT_TRUE(runner.run());
  EXPECT_TRUE(runner.records().empty());
  EXPECT_EQ(own.work.mesh.deformed(), to.deformed());
}

TEST(WalkOver, TakesNoStepsWhereNothingMovesThatIsSeen) {
  OwnWorkspace own = curled_workspace();
  MeshPair to = own.work.mesh;
  Points nearly = to.deformed();
  nearly.col(100).x() += 1e-4;
  to.set_deformed(nearly);
  StageRunner<void> runner(walk_over(own.work, to));
  EXPECT_TRUE(runner.run());
  EXPECT_TRUE(runner.records().empty());
  EXPECT_EQ(own.work.mesh.deformed(), nearly);
}

}  // namespace
}  // namespace foldless

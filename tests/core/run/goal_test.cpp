// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/goal.h"

#include <gtest/gtest.h>

#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// A grid of 4 × 4 vertices a unit apart: one handle turns, one is soft.
struct GridGoal {
  test::Fixture grid = test::square_grid(4);
  Handle turning{.id = 0, .vertex = 5, .target = Vec2(grid.rest.col(5)), .turn = Turn{0, 1}};
  Handle soft{.id = 1, .vertex = 15, .target = Vec2(9, 9), .kind = HandleKind::soft, .weight = 1};
  Goal goal{{turning, soft}, grid.triangles, grid.rest, 1};
};

TEST(Goal, IsMetWithEveryFollowerInPlaceWhereverSoftHandlesAre) {
  const GridGoal g;
  EXPECT_TRUE(g.goal.is_met(g.grid.rest));
  for (const int v : {4, 5, 6, 10}) {
    const bool follows = v != 10;
    Points u = g.grid.rest;
    u.col(v) += Vec2(1e-4, 0);
    EXPECT_EQ(g.goal.is_met(u), !follows) << v;
    u.col(v) = g.grid.rest.col(v) + Vec2(1e-6, 0);
    EXPECT_TRUE(g.goal.is_met(u)) << v;
  }
}

TEST(Goal, KeepsTheAnglesWhereNoneAreGiven) {
  GridGoal g;
  Points targets(2, 2);
  targets << 3, 9, 4, 9;
  g.goal.set_targets(targets, {90, 45});
  EXPECT_EQ(g.goal.handles()[0].target, Vec2(3, 4));
  EXPECT_EQ(g.goal.handles()[0].turn->angle, 90);
  EXPECT_FALSE(g.goal.handles()[1].turn) << "one that does not turn";
  g.goal.set_targets(targets, {});
  EXPECT_EQ(g.goal.handles()[0].turn->angle, 90);
  EXPECT_EQ(g.goal.with_followers().size(), 2U + 4U);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/strides.h"

#include <gtest/gtest.h>

#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

const std::vector<int> kOnlyHandle = {0};

/// One handle that is to go so far.
test::OwnWorkspace one_handle(const Vec2& way) {
  const Problem problem = test::grid_problem({{40, way}});
  return test::workspace_of(problem.mesh, problem.handles);
}

/// Leaves the handle this far from its aim.
void put_off_aim(Workspace& work, const Strides& strides, const Vec2& off) {
  Points u = work.mesh.deformed();
  u.col(40) = strides.aims().col(0) + off;
  work.mesh.set_deformed(u);
}

TEST(Strides, TheNextBeginsWhenThreeTenthsAreLeftAndNotBefore) {
  test::OwnWorkspace own = one_handle({0.4, 0});
  Strides strides(own.work, {.groups = {kOnlyHandle}, .stride = 0.05});
  strides.begin(kOnlyHandle);
  const Vec2 first = strides.aims().col(0);
  EXPECT_NEAR(first.x() - own.work.handles()(0, 0), strides.stride(), 1e-12);
  put_off_aim(own.work, strides, Vec2(0, 0.31 * strides.stride()));
  strides.begin(kOnlyHandle);
  EXPECT_EQ(strides.aims().col(0), first);
  EXPECT_EQ(strides.directions(kOnlyHandle).size(), 1U);
  put_off_aim(own.work, strides, Vec2(0, 0.29 * strides.stride()));
  EXPECT_NEAR(strides.distance(kOnlyHandle), 0.29 * strides.stride(), 1e-12);
  strides.begin(kOnlyHandle);
  EXPECT_NEAR(strides.aims()(0, 0) - first.x(), strides.stride(), 1e-12);
}

TEST(Strides, AreHomeAtTheEndOfThePathAndNowhereElse) {
  test::OwnWorkspace own = one_handle({0.1, 0.02});
  Strides strides(own.work, {.groups = {kOnlyHandle}, .stride = 0.05});
  int count = 0;
  for (; !strides.are_home(kOnlyHandle); ++count) {
    ASSERT_LT(count, 10);
    strides.begin(kOnlyHandle);
    put_off_aim(own.work, strides, Vec2(0, 0));
    EXPECT_TRUE(strides.have_arrived(kOnlyHandle));
  }
  EXPECT_EQ(count, 3) << "of 0.05 D each, D = 0.7 √2";
  EXPECT_EQ(strides.aims(), own.work.constraints.targets);
}

TEST(Patience, RunsOutAfterSevenStridesInARowWithoutGain) {
  Patience patience;
  for (int stride = 0; stride < 7; ++stride) {
    EXPECT_FALSE(patience.has_run_out());
    EXPECT_FALSE(patience.gains(1, 0.71));
  }
  EXPECT_TRUE(patience.has_run_out());
}

TEST(Patience, AStrideThatGainsGivesAllOfItBack) {
  Patience patience;
  for (int stride = 0; stride < 6; ++stride) EXPECT_FALSE(patience.gains(1, 0.71));
  EXPECT_TRUE(patience.gains(1, 0.69));
  for (int stride = 0; stride < 6; ++stride) EXPECT_FALSE(patience.gains(1, 0.71));
  EXPECT_FALSE(patience.has_run_out());
}

}  // namespace
}  // namespace foldless

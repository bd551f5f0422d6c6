// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/method/foldless/legs.h"
#include "core/method/foldless/pursue.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

TEST(PursueStage, ArrivesExactlyWithTheFirstWholeStepAndLocksAfterThreeShortOnesInARowTwice) {
  int arrived = 0, late = 0, locked = 0, mixed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = seed % 2 == 0 ? test::random_problem(seed) : test::trading_places(seed);
    OwnWorkspace own = test::workspace_of(problem.mesh, problem.handles);
    if (legs_of(own.work).size() > 1) continue;  // see legs_test.cpp
    StageRunner<Progress> runner(pursue(own.work));
    int short_steps = 0, most_short = 0, rows = 0;
    while (!runner.has_ended()) {
      ASSERT_LT(rows, 2) << "it goes on";
      const double error = own.work.error();
      const auto record = runner.step();
      ASSERT_TRUE(record);
      EXPECT_EQ(record->phase, Phase::pursue);
      EXPECT_TRUE(test::is_valid(own.work.mesh));
      EXPECT_LT(own.work.error(), error);
      EXPECT_EQ(record->step_length == 1, own.work.error() == 0);
      EXPECT_EQ(record->step_length == 1, runner.has_ended() && own.work.error() == 0);
      short_steps = record->step_length < 0.35 ? short_steps + 1 : 0;
      mixed += short_steps == 0 && most_short > 0;
      most_short = std::max(most_short, short_steps);
      if (short_steps == 3) {
        ++rows;
        short_steps = 0;
      }
    }
    const bool is_home = own.work.error() == 0;
    EXPECT_EQ(runner.result(), is_home ? Progress::arrived : Progress::locked);
    if (!is_home) {
      EXPECT_EQ(rows, 2);
    }
    arrived += is_home;
    late += is_home && runner.records().size() > 1;
    locked += !is_home;
  }
  EXPECT_GT(std::min({arrived, late, locked, mixed}), 4) << "the claims would be empty";
}

TEST(PursueStage, FlipsWhereAnEdgeWasInTheWayAndNotWhereTheStepIsWhole) {
  int flips = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::random_problem(seed);
    OwnWorkspace own = test::workspace_of(problem.mesh, problem.handles);
    if (legs_of(own.work).size() > 1) continue;  // see legs_test.cpp
    StageRunner<Progress> runner(pursue(own.work));
    while (!runner.has_ended()) {
      const std::uint64_t revision = own.work.mesh.revision();
      const auto record = runner.step();
      if (record->step_length == 1) {
        EXPECT_EQ(own.work.mesh.revision(), revision);
      }
      flips += own.work.mesh.revision() != revision;
    }
  }
  EXPECT_GT(flips, 10) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/approach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

constexpr double kFirstAlpha = 10, kLastAlpha = 5e7;

OwnWorkspace workspace_of(const Problem& problem) {
  return test::workspace_of(problem.mesh, problem.handles);
}

/// α of a step: the penalty is α‖P‖² where no handle is soft.
double alpha_of(const Iteration& record) {
  return record.penalty_energy / record.handle_error_squared;
}

std::vector<double> alphas(const std::vector<Iteration>& records) {
  std::vector<double> alphas;
  for (const Iteration& record : records)
    if (record.handle_error_squared > 0) alphas.push_back(alpha_of(record));
  return alphas;
}

TEST(Approach, BeginsTheStifferTheShorterTheWay) {
  int seen = 0;
  for (const double way : {0.3, 0.2, 0.11, 0.07, 0.05, 0.03, 0.02}) {
    SCOPED_TRACE(way);
    OwnWorkspace own = workspace_of(test::held_grid({{40, {way, 0}}}));
    StageRunner<Progress> runner(approach(own.work, FactorUse::lagged));
    const auto first = runner.step();
    if (first->handle_error_squared == 0) continue;
    ++seen;
    const double D = own.settings.diagonal, part = std::max(1.0, 0.1 * D / way);
    EXPECT_NEAR(alpha_of(*first) / (kFirstAlpha * part * part), 1, 1e-6);
  }
  EXPECT_GE(seen, 2) << "the claim would be empty";
}

TEST(Approach, TakesTheWayOfTheHandleThatGoesFarthest) {
  OwnWorkspace own = workspace_of(test::held_grid({{30, {0.02, 0}}, {50, {0.3, 0}}}));
  StageRunner<Progress> runner(approach(own.work, FactorUse::lagged));
  EXPECT_NEAR(alpha_of(*runner.step()), kFirstAlpha, 1e-6);
}

/// Handles that trade places inside the held boundary.
Problem crowded(std::uint64_t seed) { return test::trading_places(3 * seed + 1); }

TEST(Approach, AlphaGrowsTenfoldAndOnlyWhenALevelHasDoneItsWork) {
  int levels = 0, steps = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = workspace_of(crowded(seed));
    StageRunner<Progress> runner(approach(own.work, FactorUse::own));
    runner.run();
    const std::vector<Iteration>& records = runner.records();
    int since_level = 0;
    for (std::size_t i = 1; i < records.size() && records[i].handle_error_squared > 0; ++i) {
      const double ratio = alpha_of(records[i]) / alpha_of(records[i - 1]);
      ++since_level;
      ++steps;
      if (std::abs(ratio - 1) < 1e-6) continue;
      const bool is_last = std::abs(alpha_of(records[i]) / kLastAlpha - 1) < 1e-6;
      EXPECT_TRUE(std::abs(ratio - 10) < 1e-6 || (is_last && ratio > 1 && ratio < 10)) << ratio;
      // What the step gained bounds what was promised from below, about: with much of it a level
      // is not done, unless its time is over.
      const bool is_same_level_before =
          i >= 2 && std::abs(alpha_of(records[i - 1]) / alpha_of(records[i - 2]) - 1) < 1e-6;
      if (is_same_level_before && since_level < 25) {
        EXPECT_TRUE(records[i - 1].energy > 0.9 * records[i - 2].energy ||
                    records[i - 1].step_infinity_norm < 1e-3)
            << "step " << i;
      }
      since_level = 0;
      ++levels;
    }
  }
  EXPECT_GT(levels, 40);
  EXPECT_GT(steps, 3 * levels) << "most steps stay at their level";
}

TEST(Approach, IsOnTargetToTheLastBitWhereItArrivesAndOffItUntilThen) {
  int arrived = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = workspace_of(seed % 3 == 0 ? crowded(seed) : test::random_problem(seed));
    StageRunner<Progress> runner(approach(own.work, FactorUse::lagged));
    while (!runner.has_ended()) {
      ASSERT_TRUE(runner.step());
      EXPECT_EQ(runner.records().back().phase, Phase::approach);
      EXPECT_TRUE(test::is_valid(own.work.mesh));
      EXPECT_EQ(own.work.error(), runner.records().back().handle_error_squared);
    }
    EXPECT_EQ(runner.result() == Progress::arrived, own.work.error() == 0);
    arrived += own.work.error() == 0;
  }
  EXPECT_GT(arrived, 15);
  EXPECT_LT(arrived, 30);
}

TEST(Approach, LocksAtFullPenaltyWhenTwentyFiveStepsGainedLessThanAQuarter) {
  int locked = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = workspace_of(crowded(seed));
    StageRunner<Progress> runner(approach(own.work, FactorUse::own));
    runner.run();
    const std::vector<Iteration>& records = runner.records();
    if (runner.result() == Progress::arrived) continue;
    ++locked;
    ASSERT_GT(records.size(), 26U);
    int at_full = 0;
    for (const double alpha : alphas(records)) at_full += std::abs(alpha / kLastAlpha - 1) < 1e-6;
    EXPECT_EQ(at_full % 25, 0) << "a watch begins with the level";
    EXPECT_GE(at_full, 25);
    const auto error_before = [&](std::size_t steps) {
      return records[records.size() - 1 - steps].handle_error_squared;
    };
    EXPECT_GT(error_before(0), 0.75 * error_before(25));
    for (int watch = 1; watch < at_full / 25; ++watch)
      EXPECT_LE(error_before(static_cast<std::size_t>(25 * watch)),
                0.75 * error_before(static_cast<std::size_t>(25 * watch) + 25));
  }
  EXPECT_GE(locked, 3) << "the claim would be empty";
}

/// A triangle of three handles, one of which goes to so small a part of its height that the barrier
/// holds it off.
Problem flattened(double part) {
  Problem problem = test::grid_problem({{40, {0, 0}}, {41, {0, 0}}, {50, {0, 0}}, {0, {0, 0}}});
  const Vec2 foot(problem.handles[2].target.x(), problem.handles[1].target.y());
  problem.handles[2].target = foot + part * (problem.handles[2].target - foot);
  return problem;
}

TEST(Approach, WhereTheMeshHoldsHandlesOffTheAimMovesToTheOtherSide) {
  for (const double part : {1e-3, 7e-4, 5e-4}) {
    SCOPED_TRACE(part);
    OwnWorkspace own = workspace_of(flattened(part));
    StageRunner<Progress> runner(approach(own.work, FactorUse::own));
    runner.run();
    EXPECT_EQ(runner.result(), Progress::arrived);
  }
}

}  // namespace
}  // namespace foldless

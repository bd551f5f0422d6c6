// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/foldless.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

using test::expect_on_target;
using test::grid_problem;
using test::is_valid;
using test::run_validly;
using test::swirl;
using test::trading_places;

TEST(Foldless, SatisfiedMeansExactlyOnTarget) {
  const Problem problem = grid_problem({{0, {0, 0}}, {8, {0.1, 0}}, {40, {-0.05, 0.12}}});
  Foldless method(problem);
  run_validly(method);
  expect_on_target(method, problem);
}

TEST(Foldless, AShortWayTakesFewFactorizations) {
  Foldless method(grid_problem({{0, {0, 0}}, {80, {0.002, 0.001}}}));
  EXPECT_LE(run_validly(method).back().factorizations, 8);
}

TEST(Foldless, ReachesACoreThatTurnsByHalfACircle) {
  Foldless method(swirl());
  run_validly(method);
  expect_on_target(method, swirl());
}

TEST(Foldless, WhileOtherWaysAreTriedTheNearestMeshStaysOnShow) {
  int transports = 0, unchanged = 0;
  for (std::uint64_t seed = 1; seed <= 40 && transports < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = trading_places(seed);
    const Constraints constraints = constraints_of(problem.handles);
    Foldless method(problem);
    bool is_trying = false;
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      const Points shown = method.mesh().deformed();
      const auto iteration = method.step({});
      ASSERT_TRUE(iteration);
      const Points& now = method.mesh().deformed();
      const bool is_same = now.cols() == shown.cols() && now == shown;  // splits add vertices
      if (is_trying && !is_same) {
        EXPECT_LT(handle_error_squared(constraints, now), handle_error_squared(constraints, shown))
            << "step " << step;
      }
      unchanged += is_trying && is_same;
      is_trying |= iteration->phase == Phase::transport;
      transports += iteration->phase == Phase::transport;
      if (handle_error_squared(constraints, method.mesh().deformed()) == 0) break;
    }
  }
  EXPECT_GE(transports, 200) << "the claim would be empty";
  EXPECT_GE(unchanged, 190);
}

TEST(Foldless, IsValidOnRandomScenesWhateverIsCancelledAndResumed) {
  std::set<Phase> phases;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foldless method(seed % 2 ? test::random_problem(seed) : trading_places(seed));
    std::mt19937_64 random(seed);
    std::stop_source stopped;
    stopped.request_stop();
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      if (random() % 4 == 0) {
        const Points before = method.mesh().deformed();
        EXPECT_FALSE(method.step(stopped.get_token()).has_value());
        EXPECT_EQ(method.mesh().deformed(), before);
      }
      if (const auto iteration = method.step({})) phases.insert(iteration->phase);
      ASSERT_TRUE(is_valid(method.mesh())) << "step " << step;
    }
  }
  // The claim would be empty if a stage were never entered.
  EXPECT_EQ(phases, (std::set{Phase::approach, Phase::transport, Phase::pursue, Phase::settle,
                              Phase::construct}));
}

TEST(Foldless, NewTargetsStartFromTheMeshAsItIs) {
  Problem problem = grid_problem({{0, {0, 0}}, {80, {0.1, 0.1}}});
  Foldless method(problem);
  run_validly(method);
  const Points reached = method.mesh().deformed();
  problem.handles[1].target += Vec2(0.01, -0.02);
  method.set_targets(constraints_of(problem.handles).targets);
  EXPECT_FALSE(method.outcome().has_value());
  EXPECT_EQ(method.mesh().deformed(), reached);
  run_validly(method);
  expect_on_target(method, problem);
}

}  // namespace
}  // namespace foldless

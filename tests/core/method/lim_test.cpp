// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/lim.h"

#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "core/method/remeshing_assisted.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

using test::is_satisfied;
using test::pulled_grid;
using test::run_to_its_end;

TEST(Lim, EndsAtAMinimumWithTheHandlesAtTheirTargets) {
  for (const Density& density : densities()) {
    SCOPED_TRACE(density.name);
    Lim method(pulled_grid(density.name, Vec2(0.1, 0.15)));
    const Iteration last = run_to_its_end(method);
    EXPECT_EQ(method.outcome(), Outcome::gradient);
    EXPECT_LT(last.gradient_norm_squared, 1e-6);
    EXPECT_TRUE(is_satisfied(method, last));
    EXPECT_EQ(last.flips, 0);
  }
}

TEST(Lim, EveryTriangleIsPositiveAfterEveryStep) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Lim method(test::random_problem(seed));
    const InjectivityChecker checker(method.mesh().triangles(), method.mesh().vertex_count());
    for (int k = 0; k < 40 && method.step({}); ++k) {
      const InjectivityReport report = checker.check(method.mesh().deformed());
      ASSERT_EQ(report.inverted + report.degenerate, 0) << "step " << k;
    }
  }
}

TEST(Lim, AStepTowardsTheRealTargetsLowersTheEnergy) {
  Lim method(pulled_grid("green-strain", Vec2(-0.3, -0.2)));
  double energy = std::numeric_limits<double>::infinity();
  int plain = 0, shifted = 0;
  while (const auto now = method.step({})) {
    // Sub-stepping lowers E with targets of its own, which lets E with the real ones rise.
    if (now->mu == 0 && now->step_length > 0) {
      EXPECT_LT(now->energy, energy);
    }
    ++(now->mu == 0 ? plain : shifted);
    energy = now->energy;
  }
  EXPECT_GT(plain, 0);
  EXPECT_GT(shifted, 0) << "the scene was chosen to need the shift";
}

TEST(Lim, HardTwistsOfTheCoarseDiskNeedMoreFactorizationsThanWithRelaxation) {
  int with_sub_steps = 0, with_relaxation = 0;
  for (const int ring : {5, 6}) {
    const Problem problem = test::turned_disk({.ring = ring, .degrees = 150});
    Lim lim(problem);
    RemeshingAssisted relaxing(problem, {.flips = false});
    const Iteration last = run_to_its_end(lim);
    EXPECT_TRUE(is_satisfied(lim, last)) << ring;
    with_sub_steps += last.factorizations;
    with_relaxation += run_to_its_end(relaxing).factorizations;
  }
  EXPECT_GT(with_sub_steps, with_relaxation);
}

TEST(Lim, ACancelledStepChangesNothingAndTheRunCanGoOn) {
  Lim method(pulled_grid("arap", Vec2(0.2, 0.2)));
  ASSERT_TRUE(method.step({}));
  const Points before = method.mesh().deformed();
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(method.step(source.get_token()));
  EXPECT_FALSE(method.outcome());
  EXPECT_EQ(method.mesh().deformed(), before);
  EXPECT_TRUE(is_satisfied(method, run_to_its_end(method)));
}

TEST(Lim, MovedTargetsBeginTheRunAgainFromWhereItIs) {
  Problem problem = pulled_grid("arap", Vec2(0.1, 0));
  Points targets = constraints_of(problem.handles).targets;
  Lim method(std::move(problem));
  run_to_its_end(method);
  ASSERT_TRUE(method.outcome());
  targets.col(3) += Vec2(0, 0.1);
  method.set_targets(targets);
  EXPECT_FALSE(method.outcome());
  EXPECT_TRUE(is_satisfied(method, run_to_its_end(method)));
}

TEST(Lim, TheIterationLimitIsAnOutcome) {
  Problem problem = pulled_grid("arap", Vec2(-0.5, -0.5));
  problem.parameters.inner_iterations = 2;
  Lim method(std::move(problem));
  run_to_its_end(method);
  EXPECT_EQ(method.outcome(), Outcome::iteration_limit);
}

}  // namespace
}  // namespace foldless

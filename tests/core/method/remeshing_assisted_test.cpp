// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/remeshing_assisted.h"

#include <gtest/gtest.h>

#include "core/method/methods.h"
#include "tests/core/method/method_fixture.h"

namespace foldless {
namespace {

using test::held;
using test::is_satisfied;
using test::pulled_grid;
using test::run_to_its_end;

/// Figure 1: vertex a of the triangle (a, b, c) should go to the other side of the edge bc, whose
/// ends are held, and d holds the vertex beyond.
Problem figure_1() {
  const Shape shape = grid({.columns = 4, .rows = 4, .width = 0.7, .height = 0.7});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  const auto at = [&](double x, double y) -> Vec2 { return Vec2(x, y) * 0.175; };
  for (const int v : {12, 7, 6}) problem.handles.push_back(held(shape.rest, v));
  Handle a = held(shape.rest, 13);
  a.target = at(1.7, 1.35) + (shape.rest.col(6) - at(1, 1));
  problem.handles.push_back(a);
  return problem;
}

TEST(RemeshingAssisted, EndsAtAMinimumWithTheHandlesAtTheirTargets) {
  for (const Density& density : densities()) {
    SCOPED_TRACE(density.name);
    for (const bool flips : {true, false}) {
      RemeshingAssisted method(pulled_grid(density.name, Vec2(0.1, 0.15)), {flips});
      const Iteration last = run_to_its_end(method);
      EXPECT_EQ(method.outcome(), Outcome::gradient) << flips;
      EXPECT_LT(last.gradient_norm_squared, 1e-6);
      EXPECT_TRUE(is_satisfied(method, last));
    }
  }
}

TEST(RemeshingAssisted, TheRestStateIsAMinimumAndNothingMoves) {
  const auto method = find_method("paper-flip")->start(pulled_grid("arap", Vec2::Zero()));
  const Iteration last = run_to_its_end(*method);
  EXPECT_EQ(method->outcome(), Outcome::gradient);
  EXPECT_EQ(last.flips, 0);
  EXPECT_LT((method->mesh().deformed() - method->mesh().rest()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(RemeshingAssisted, AVertexBlockedByAnEdgeGetsThereWithFlipsOnly) {
  const auto without = find_method("paper-noflip")->start(figure_1());
  EXPECT_FALSE(is_satisfied(*without, run_to_its_end(*without)));
  EXPECT_TRUE(without->outcome().has_value());
  const auto with = find_method("paper-flip")->start(figure_1());
  const Iteration last = run_to_its_end(*with);
  EXPECT_TRUE(is_satisfied(*with, last));
  EXPECT_GT(last.flips, 0);
}

TEST(RemeshingAssisted, EveryStepIsOneUpdateAndTheCountersOnlyGrow) {
  RemeshingAssisted method(pulled_grid("lscm", Vec2(-0.3, -0.3)), {.flips = true});
  Iteration previous;
  while (const auto now = method.step({})) {
    EXPECT_LE(now->updates - previous.updates, 1);
    EXPECT_GE(now->factorizations, previous.factorizations);
    EXPECT_GE(now->flips, previous.flips);
    EXPECT_GE(now->seconds, previous.seconds);
    EXPECT_GE(now->factorizations, now->updates);
    previous = *now;
  }
  EXPECT_GT(previous.updates, 1);
}

TEST(RemeshingAssisted, AnUpdateNeverRaisesTheEnergy) {
  RemeshingAssisted method(pulled_grid("green-strain", Vec2(-0.3, -0.2)), {.flips = true});
  double energy = std::numeric_limits<double>::infinity();
  while (const auto now = method.step({})) {
    // RelaxVertices holds the handles with a spring, which lets E with the real targets rise.
    if (now->phase == Phase::update) {
      EXPECT_LE(now->energy, energy * (1 + 1e-12));
    }
    energy = now->energy;
  }
}

TEST(RemeshingAssisted, RunsAreReproducibleBitForBit) {
  const auto first = find_method("paper-flip")->start(pulled_grid("lscm", Vec2(-0.4, -0.4)));
  const auto second = find_method("paper-flip")->start(pulled_grid("lscm", Vec2(-0.4, -0.4)));
  run_to_its_end(*first);
  run_to_its_end(*second);
  EXPECT_EQ(first->mesh().triangles(), second->mesh().triangles());
  EXPECT_EQ(first->mesh().deformed(), second->mesh().deformed());
}

TEST(RemeshingAssisted, ACancelledStepChangesNothingAndTheRunCanGoOn) {
  RemeshingAssisted method(pulled_grid("arap", Vec2(0.2, 0.2)), {.flips = true});
  ASSERT_TRUE(method.step({}));
  const Points before = method.mesh().deformed();
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(method.step(source.get_token()));
  EXPECT_FALSE(method.outcome());
  EXPECT_EQ(method.mesh().deformed(), before);
  EXPECT_TRUE(is_satisfied(method, run_to_its_end(method)));
}

TEST(RemeshingAssisted, MovedTargetsBeginTheRunAgainFromWhereItIs) {
  Problem problem = pulled_grid("arap", Vec2(0.1, 0));
  Points targets = constraints_of(problem.handles).targets;
  RemeshingAssisted method(std::move(problem), {.flips = true});
  run_to_its_end(method);
  ASSERT_TRUE(method.outcome());
  targets.col(3) += Vec2(0, 0.1);
  method.set_targets(targets);
  EXPECT_FALSE(method.outcome());
  run_to_its_end(method);
  EXPECT_NEAR((method.mesh().deformed().col(48) - targets.col(3)).norm(), 0, 1e-6);
}

TEST(RemeshingAssisted, TheIterationLimitIsAnOutcome) {
  Problem problem = pulled_grid("arap", Vec2(-0.5, -0.5));
  problem.parameters.inner_iterations = 2;
  problem.parameters.outer_iterations = 2;
  RemeshingAssisted method(std::move(problem), {.flips = true});
  run_to_its_end(method);
  EXPECT_EQ(method.outcome(), Outcome::iteration_limit);
}

TEST(RemeshingAssisted, GreenStrainUsesTheMeanAreaForThePapersBeta) {
  const Problem problem = pulled_grid("green-strain", Vec2::Zero());
  const EnergySettings settings = energy_settings(problem);
  EXPECT_TRUE(settings.area_weighted);
  EXPECT_NEAR(settings.beta, 100 * 0.7 * 0.7 / 72, 1e-12);
  Problem unweighted = problem;
  unweighted.parameters.area_weighted = false;
  EXPECT_FALSE(energy_settings(unweighted).area_weighted);
  EXPECT_NEAR(energy_settings(unweighted).beta, 100 * 2 * 0.7 * 0.7, 1e-12) << "D is not 1";
}

}  // namespace
}  // namespace foldless

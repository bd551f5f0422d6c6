// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/moving_directions.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

/// Three vertices; handles at 2 and 0, whose target, last step and gradient all point elsewhere.
struct Scene {
  Scene() : u(2, 3) {
    u << 0, 5, 2,  //
        0, 5, 1;
    constraints = constraints_of({{.id = 0, .vertex = 2, .target = Vec2(2, 4)},
                                  {.id = 1, .vertex = 0, .target = Vec2(-1, 0)}});
    before.resize(2, 2);
    before << 1.5, 0,  //
        1, 0.25;
    gradient.resize(6);
    gradient << 8, 1, 100, 100, -3, 2;
  }

  std::vector<MovingDirection> directions(Outcome outcome, bool is_last_step_small,
                                          double tolerance = 1e-3) const {
    return moving_directions(constraints, u, {outcome, is_last_step_small, before, gradient},
                             tolerance);
  }

  Points u;
  Constraints constraints;
  Points before;
  Eigen::VectorXd gradient;
};

void expect_directions(const std::vector<MovingDirection>& found, const Vec2& of_first,
                       const Vec2& of_second) {
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].vertex, 2);
  EXPECT_EQ(found[0].direction, of_first);
  EXPECT_EQ(found[1].vertex, 0);
  EXPECT_EQ(found[1].direction, of_second);
}

TEST(MovingDirections, AfterGradientConvergencePointToTheTargets) {
  for (const bool is_last_step_small : {false, true})
    expect_directions(Scene().directions(Outcome::gradient, is_last_step_small), {0, 3}, {-1, 0});
}

TEST(MovingDirections, ElseAfterASmallStepAreThoseOfSteepestDescent) {
  for (const Outcome outcome : {Outcome::step, Outcome::iteration_limit})
    expect_directions(Scene().directions(outcome, true), {3, -2}, {-8, -1});
}

TEST(MovingDirections, ElseAreThoseOfTheLastStep) {
  for (const Outcome outcome : {Outcome::step, Outcome::iteration_limit})
    expect_directions(Scene().directions(outcome, false), {0.5, 0}, {0, -0.25});
}

TEST(MovingDirections, OneThatHasVanishedPointsToTheTarget) {
  Scene scene;
  scene.before.col(0) = scene.u.col(2);
  scene.gradient.segment<2>(0).setZero();
  expect_directions(scene.directions(Outcome::iteration_limit, false), {0, 3}, {0, -0.25});
  expect_directions(scene.directions(Outcome::step, true), {3, -2}, {-1, 0});
  scene.before.resize(2, 0);
  expect_directions(scene.directions(Outcome::iteration_limit, false), {0, 3}, {-1, 0});
}

TEST(MovingDirections, SoftHandlesAndThoseThatAreHomeHaveNone) {
  Scene scene;
  EXPECT_EQ(scene.directions(Outcome::gradient, false, 1.0).size(), 1U);
  EXPECT_EQ(scene.directions(Outcome::gradient, false, 0.99).size(), 2U);
  scene.constraints.soft[0] = true;
  const auto directions = scene.directions(Outcome::iteration_limit, false);
  ASSERT_EQ(directions.size(), 1U);
  EXPECT_EQ(directions[0].vertex, 0);
  EXPECT_EQ(directions[0].direction, Vec2(0, -0.25)) << "its own, not that of the handle before";
}

}  // namespace
}  // namespace foldless

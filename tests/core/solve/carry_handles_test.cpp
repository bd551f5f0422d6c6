// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/carry_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "tests/core/solve/newton_fixture.h"
#include "tests/support/meshes.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

/// A square grid of nine vertices with two corners held and a soft handle in the middle.
struct Carried {
  Carried(const char* density, double beta, const Vec2& way) {
    const auto f = test::square_grid(3);
    mesh = MeshPair(f.triangles, f.rest);
    Handle fixed{.id = 0, .vertex = 0, .target = f.rest.col(0)};
    Handle moved{.id = 1, .vertex = 8, .target = f.rest.col(8) + way};
    Handle soft{.id = 2, .vertex = 4, .target = f.rest.col(4), .kind = HandleKind::soft};
    energy.constraints = held(constraints_of({fixed, moved, soft}));
    energy.settings.density = find_density(density);
    energy.settings.alpha = 0.3;
    energy.settings.beta = beta;
  }

  MeshPair mesh;
  Energy energy;
  Effort effort;
};

TEST(CarryHandles, AFullStepPutsThemExactlyOnTheirTargetsInOneFactorization) {
  Carried c("arap", 2, {0.07, -0.03});
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  const VertexUpdate update = carry_handles(system, c.mesh, c.energy, {});
  EXPECT_EQ(update.step_length, 1);
  EXPECT_EQ(c.effort.factorizations, 1);
  EXPECT_EQ(handle_error_squared(c.energy.constraints, c.mesh.deformed()), 0);
}

TEST(CarryHandles, TheOthersAreAtTheMinimumAfterOneStepWhereTheEnergyIsQuadratic) {
  Carried c("dirichlet", 0, {0.3, 0.2});
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  Points only_handles_moved = c.mesh.deformed();
  only_handles_moved.col(8) = c.energy.constraints.targets.col(1);
  system.assemble_gradient(c.energy, only_handles_moved);
  ASSERT_GT(system.gradient().norm(), 0.1) << "the claim would be empty";
  ASSERT_EQ(carry_handles(system, c.mesh, c.energy, {}).step_length, 1);
  system.assemble_gradient(c.energy, c.mesh.deformed());
  // The shift of the clamped ∇²E is what is left.
  EXPECT_LT(system.gradient().norm(), 1e-8);
}

TEST(CarryHandles, AStepIsBoundedAlongItsLineAndTheHandlesGoThatPartOfTheirWay) {
  Carried c("arap", 2, {-3, -3});
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  const Points before = c.mesh.deformed();
  const VertexUpdate update = carry_handles(system, c.mesh, c.energy, {});
  EXPECT_GT(update.step_length, 0);
  EXPECT_LT(update.step_length, 1);
  const Vec2 moved = c.mesh.deformed().col(8) - before.col(8);
  EXPECT_LT((moved - update.step_length * Vec2(-3, -3)).norm(), 1e-12);
  const InjectivityChecker checker(c.mesh.triangles(), c.mesh.vertex_count());
  for (int k = 0; k <= 8; ++k)
    EXPECT_TRUE(checker.is_injective(before + k / 8.0 * (c.mesh.deformed() - before))) << k;
}

TEST(CarryHandles, NoTriangleEndsBeyondItsLeastAreaHoweverOftenHandlesPressAgainstIt) {
  int pressed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-2, 2);
    Carried c("arap", 2, {0, 0});
    const double delta = c.energy.settings.delta;
    const Vec2 far_away(1e5, 7e4);  // where positions are rounded more coarsely than areas
    const Points rest = c.mesh.rest().colwise() + far_away;
    c.mesh.set_positions(rest, rest);
    c.energy.constraints.targets.colwise() += far_away;
    NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
    for (int step = 0; step < 100; ++step) {
      if (step % 25 == 0)
        c.energy.constraints.targets.col(1) = far_away + test::random_vector(unit, random);
      pressed += carry_handles(system, c.mesh, c.energy, {}).step_length < 1e-6;
      for (const auto& t : c.mesh.triangles().colwise())
        ASSERT_GT(signed_area(c.mesh.deformed(), t), delta * signed_area(c.mesh.rest(), t))
            << "step " << step;
    }
  }
  EXPECT_GT(pressed, 30) << "the claim would be empty";
}

TEST(CarryHandles, NoRoundingKeepsAHandleFromItsTarget) {
  int rounded = 0;
  for (int k = 1; k <= 20; ++k) {
    SCOPED_TRACE(k);
    Carried c("arap", 2, {0, 0});
    // Where p is nearer to zero than u, u + (p − u) need not be p.
    const Points shifted = c.mesh.rest().colwise() - Vec2(2 - 1 / 30.0, 2 - 1 / 70.0);
    c.mesh.set_positions(shifted, shifted);
    for (int i = 0; i < 3; ++i)
      c.energy.constraints.targets.col(i) =
          shifted.col(c.energy.constraints.vertices[static_cast<std::size_t>(i)]);
    const Vec2 start = shifted.col(8), target(k / 1700.0, k / 1900.0);
    c.energy.constraints.targets.col(1) = target;
    rounded += start + (target - start) != target;
    NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
    ASSERT_EQ(carry_handles(system, c.mesh, c.energy, {}).step_length, 1);
    EXPECT_EQ(handle_error_squared(c.energy.constraints, c.mesh.deformed()), 0);
  }
  EXPECT_GT(rounded, 0) << "the claim would be empty";
}

TEST(CarryHandles, TheOthersFollowAsTheDenseSystemSays) {
  Carried c("arap", 2, {0.07, -0.03});
  Points u = c.mesh.deformed();
  u.col(4) += Vec2(0.1, 0.15);  // so that ∇E has its part
  c.mesh.set_deformed(u);
  Energy free = c.energy;
  free.constraints.held = false;
  const test::DenseNewton dense(c.mesh, free, 1);
  std::vector<int> others, handles;
  for (int v = 0; v < 9; ++v)
    for (const int i : {2 * v, 2 * v + 1}) (v == 0 || v == 8 ? handles : others).push_back(i);
  const Eigen::Vector4d way(0, 0, 0.07, -0.03);
  const Eigen::VectorXd expected =
      dense.hessian(others, others)
          .ldlt()
          .solve(-dense.gradient(others) - dense.hessian(others, handles) * way);
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  ASSERT_EQ(carry_handles(system, c.mesh, c.energy, {}).step_length, 1);
  const Eigen::VectorXd moved = (c.mesh.deformed() - u).reshaped();
  EXPECT_LT((moved(others) - expected).norm(), 1e-7 * expected.norm()) << "but for the shift";
}

TEST(CarryHandles, TheStepIsEightTenthsOfTheWayToTheFirstFold) {
  Carried c("arap", 2, {-3, -3});
  c.energy.settings.delta = 0.05;
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  const Points before = c.mesh.deformed();
  carry_handles(system, c.mesh, c.energy, {});
  const auto smallest_ratio = [&](double part) {
    const Points u = before + part * (c.mesh.deformed() - before);
    double smallest = 1e9;
    for (const auto& t : c.mesh.triangles().colwise())
      smallest = std::min(smallest, signed_area(u, t) / signed_area(c.mesh.rest(), t));
    return smallest;
  };
  for (int k = 0; k < 100; ++k) EXPECT_GT(smallest_ratio(k / 80.0), 0.05) << k;
  EXPECT_NEAR(smallest_ratio(1 / 0.8), 0.05, 1e-9);
}

TEST(CarryHandles, CountsEveryAttemptAndTheStep) {
  Carried c("arap", 2, {0.07, -0.03});
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  carry_handles(system, c.mesh, c.energy, {});
  EXPECT_EQ(c.effort.factorizations, 1);
  EXPECT_EQ(c.effort.updates, 1);
  c.energy.constraints.targets.col(1) += Vec2(0.01, 0);
  carry_handles(system, c.mesh, c.energy, {});
  EXPECT_EQ(c.effort.factorizations, 1) << "the factor is near enough";
  EXPECT_EQ(c.effort.updates, 2);
  EXPECT_EQ(handle_error_squared(c.energy.constraints, c.mesh.deformed()), 0);
}

TEST(CarryHandles, ASoftHandleIsNoneToCarry) {
  Carried c("arap", 2, {0.07, -0.03});
  c.energy.constraints.targets.col(2) += Vec2(0.3, 0);
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  carry_handles(system, c.mesh, c.energy, {});
  const double moved = (c.mesh.deformed().col(4) - c.mesh.rest().col(4)).x();
  EXPECT_GT(moved, 0.01);
  EXPECT_LT(moved, 0.29);
}

TEST(CarryHandles, CancelledChangesNothing) {
  Carried c("arap", 2, {0.07, -0.03});
  NewtonSystem system(c.mesh, c.energy.constraints, c.effort);
  std::stop_source stopped;
  stopped.request_stop();
  const Points before = c.mesh.deformed();
  EXPECT_TRUE(carry_handles(system, c.mesh, c.energy, stopped.get_token()).cancelled);
  EXPECT_EQ(c.mesh.deformed(), before);
}

}  // namespace
}  // namespace foldless

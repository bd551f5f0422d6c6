// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/carry_handles.h"

#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// A square grid of nine vertices with two corners held and a soft handle in the middle.
struct Carried {
  Carried(const char* energy, double beta, const Vec2& way) {
    const auto f = test::square_grid(3);
    mesh = MeshPair(f.triangles, f.rest);
    Handle fixed{.id = 0, .vertex = 0, .target = f.rest.col(0)};
    Handle moved{.id = 1, .vertex = 8, .target = f.rest.col(8) + way};
    Handle soft{.id = 2, .vertex = 4, .target = f.rest.col(4), .kind = HandleKind::soft};
    constraints = constraints_of({fixed, moved, soft});
    constraints.held = true;
    settings.density = find_density(energy);
    settings.alpha = 0.3;
    settings.beta = beta;
  }

  MeshPair mesh;
  Constraints constraints;
  EnergySettings settings;
};

TEST(CarryHandles, AFullStepPutsThemExactlyOnTheirTargetsInOneFactorization) {
  Carried c("arap", 2, {0.07, -0.03});
  NewtonSystem system(c.settings, c.mesh, c.constraints);
  const VertexUpdate update = carry_handles(system, c.mesh, c.constraints, {});
  EXPECT_EQ(update.step_length, 1);
  EXPECT_EQ(system.counters.factorizations, 1);
  EXPECT_EQ(handle_error_squared(c.constraints, c.mesh.deformed()), 0);
}

TEST(CarryHandles, TheOthersAreAtTheMinimumAfterOneStepWhereTheEnergyIsQuadratic) {
  Carried c("dirichlet", 0, {0.3, 0.2});
  NewtonSystem system(c.settings, c.mesh, c.constraints);
  Points only_handles_moved = c.mesh.deformed();
  only_handles_moved.col(8) = c.constraints.targets.col(1);
  system.assemble_gradient(only_handles_moved, c.constraints);
  ASSERT_GT(system.gradient().norm(), 0.1) << "the claim would be empty";
  ASSERT_EQ(carry_handles(system, c.mesh, c.constraints, {}).step_length, 1);
  system.assemble_gradient(c.mesh.deformed(), c.constraints);
  // The shift of the clamped ∇²E is what is left.
  EXPECT_LT(system.gradient().norm(), 1e-8);
}

TEST(CarryHandles, AStepIsBoundedAlongItsLineAndTheHandlesGoThatPartOfTheirWay) {
  Carried c("arap", 2, {-3, -3});
  NewtonSystem system(c.settings, c.mesh, c.constraints);
  const Points before = c.mesh.deformed();
  const VertexUpdate update = carry_handles(system, c.mesh, c.constraints, {});
  EXPECT_GT(update.step_length, 0);
  EXPECT_LT(update.step_length, 1);
  const Vec2 moved = c.mesh.deformed().col(8) - before.col(8);
  EXPECT_LT((moved - update.step_length * Vec2(-3, -3)).norm(), 1e-12);
  const InjectivityChecker checker(c.mesh.triangles(), c.mesh.vertex_count());
  for (int k = 0; k <= 8; ++k)
    EXPECT_TRUE(checker.is_injective(before + k / 8.0 * (c.mesh.deformed() - before))) << k;
}

TEST(CarryHandles, CancelledChangesNothing) {
  Carried c("arap", 2, {0.07, -0.03});
  NewtonSystem system(c.settings, c.mesh, c.constraints);
  std::stop_source stopped;
  stopped.request_stop();
  const Points before = c.mesh.deformed();
  EXPECT_TRUE(carry_handles(system, c.mesh, c.constraints, stopped.get_token()).cancelled);
  EXPECT_EQ(c.mesh.deformed(), before);
}

}  // namespace
}  // namespace foldless

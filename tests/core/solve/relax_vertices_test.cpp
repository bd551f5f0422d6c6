// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/relax_vertices.h"

#include <gtest/gtest.h>

#include "tests/core/solve/newton_fixture.h"

namespace foldless {
namespace {

using test::DenseNewton;
using test::SqueezedGrid;

/// Handles that E_c pulls to where they are.
Energy at_rest(const SqueezedGrid& s) {
  return {s.energy.settings,
          with_targets(s.energy.constraints,
                       handle_positions(s.energy.constraints, s.mesh.deformed()))};
}

TEST(RelaxVertices, IsADampedNewtonStepTowardsWhereTheHandlesAre) {
  SqueezedGrid s(0.2);
  DampedSystem system = s.system();
  const DenseNewton dense(s.mesh, at_rest(s));
  test::Damping damping;
  damping.iterate(dense.smallest_eigenvalue());
  const Points before = s.mesh.deformed(), step = dense.step(damping.mu);
  const auto update = relax_vertices(system, s.mesh, s.energy, {});
  ASSERT_TRUE(update);
  EXPECT_DOUBLE_EQ(update->mu, damping.mu);
  EXPECT_GT(update->step_length, 0);
  EXPECT_LT((s.mesh.deformed() - before - update->step_length * step).norm(), 1e-9 * step.norm());
  EXPECT_EQ(s.effort.factorizations, damping.attempts) << "each once, the plain one with them";
  EXPECT_EQ(s.effort.updates, 1);
}

TEST(RelaxVertices, DoesNotLookAtTheTargets) {
  SqueezedGrid a(0.2), b(0.2);
  b.energy.constraints.targets.array() += 7;
  DampedSystem system_a = a.system(), system_b = b.system();
  ASSERT_TRUE(relax_vertices(system_a, a.mesh, a.energy, {}));
  ASSERT_TRUE(relax_vertices(system_b, b.mesh, b.energy, {}));
  EXPECT_EQ(a.mesh.deformed(), b.mesh.deformed());
}

TEST(RelaxVertices, LowersDistortionAndBarrierUntilTheHessianIsPositiveDefinite) {
  SqueezedGrid s(0.2);
  s.energy.settings.alpha = 5e7;
  DampedSystem system = s.system();
  const Objective objective(s.mesh, s.energy.constraints);
  const auto shape_energy = [&] {
    const EnergyTerms terms = objective.value(s.energy, s.mesh.deformed());
    return terms.distortion + terms.barrier;
  };
  const Points handles = handle_positions(s.energy.constraints, s.mesh.deformed());
  const double at_first = shape_energy();
  double energy = at_first;
  int steps = 0;
  while (true) {
    SCOPED_TRACE(testing::Message() << "step " << steps);
    const double smallest = DenseNewton(s.mesh, s.energy).smallest_eigenvalue();
    const Points before = s.mesh.deformed();
    const auto update = relax_vertices(system, s.mesh, s.energy, {});
    ASSERT_EQ(update.has_value(), smallest < 0);
    if (!update) {
      EXPECT_EQ(s.mesh.deformed(), before);
      break;
    }
    ASSERT_GT(update->mu, 0);
    EXPECT_LE(shape_energy(), energy);
    energy = shape_energy();
    ASSERT_LT(++steps, 200);
  }
  EXPECT_GT(steps, 0);
  EXPECT_LT(energy, 0.99 * at_first);
  EXPECT_LT((handle_positions(s.energy.constraints, s.mesh.deformed()) - handles).norm(), 1e-4);
  EXPECT_TRUE(system.factor().is_exact()) << "for the next update";
  EXPECT_EQ(s.effort.updates, steps);
}

TEST(RelaxVertices, IsNothingWhereTheHessianIsPositiveDefinite) {
  SqueezedGrid s(0.9);
  DampedSystem system = s.system();
  ASSERT_GT(DenseNewton(s.mesh, s.energy).smallest_eigenvalue(), 0);
  const Points before = s.mesh.deformed();
  EXPECT_FALSE(relax_vertices(system, s.mesh, s.energy, {}));
  EXPECT_EQ(s.mesh.deformed(), before);
  EXPECT_EQ(s.effort.factorizations, 1);
  EXPECT_EQ(s.effort.updates, 0);
}

TEST(RelaxVertices, CancelledChangesNothing) {
  SqueezedGrid s(0.2);
  DampedSystem system = s.system();
  std::stop_source stop;
  stop.request_stop();
  const Points before = s.mesh.deformed();
  const auto update = relax_vertices(system, s.mesh, s.energy, stop.get_token());
  ASSERT_TRUE(update);
  EXPECT_TRUE(update->cancelled);
  EXPECT_EQ(s.mesh.deformed(), before);
}

}  // namespace
}  // namespace foldless

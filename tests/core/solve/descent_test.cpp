// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/descent.h"

#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// A square grid squeezed to a part of its size, whose corners are pulled back to where they were.
/// Under ARAP a triangle of less than half of its size has negative curvature.
struct Squeezed {
  explicit Squeezed(double size) {
    const auto f = test::square_grid(4);
    mesh = MeshPair(f.triangles, f.rest, size * f.rest);
    std::vector<Handle> corners;
    for (const int v : {0, 3, 12, 15})
      corners.push_back({.id = v, .vertex = v, .target = f.rest.col(v)});
    constraints = constraints_of(corners);
    settings.density = find_density("arap");
    settings.alpha = 1;
    settings.beta = 2;
    settings.barrier_area_weighted = true;
  }

  MeshPair mesh;
  Constraints constraints;
  EnergySettings settings;
};

TEST(Descend, WhereTheExactHessianIsDefiniteOneFactorizationServesAStep) {
  Squeezed s(0.9);
  NewtonSystem system(s.settings, s.mesh, s.constraints);
  CurvatureChoice choice;
  const VertexUpdate update = descend(system, s.mesh, s.constraints, choice, {});
  EXPECT_EQ(update.clamping, 0);
  EXPECT_GT(update.step_length, 0);
  EXPECT_EQ(system.counters.factorizations, 1);
}

TEST(Descend, AFactorServesSeveralSteps) {
  Squeezed s(0.9);
  NewtonSystem system(s.settings, s.mesh, s.constraints);
  CurvatureChoice choice;
  VertexUpdate update;
  for (int step = 0; step < 50; ++step) {
    update = descend(system, s.mesh, s.constraints, choice, {});
    if (update.decrement < 1e-12) break;
  }
  EXPECT_LT(update.decrement, 1e-12);
  EXPECT_LT(update.step_infinity_norm, 6e-6);
  EXPECT_LT(system.counters.factorizations, system.counters.updates);
}

TEST(Descend, AStepFromAnEarlierFactorIsNearlyNewtons) {
  Squeezed s(0.9);
  NewtonSystem system(s.settings, s.mesh, s.constraints);
  CurvatureChoice choice;
  descend(system, s.mesh, s.constraints, choice, {});
  system.assemble(s.mesh.deformed(), s.constraints);
  const std::optional<LaggedStep> lagged = system.lagged_newton_step();
  ASSERT_TRUE(lagged);
  EXPECT_FALSE(lagged->is_indefinite);
  ASSERT_TRUE(system.factorize(0));
  const Points newton = system.newton_step();
  // Of the decrease that the model promises a hundredth may be missing, or little more.
  EXPECT_LT(system.slope(lagged->step), 0.97 * system.slope(newton));
  EXPECT_GE(system.slope(lagged->step), (1 + 1e-9) * system.slope(newton));
}

TEST(Descend, AFactorOfFreeHandlesDoesNotServeHeldOnes) {
  Squeezed s(0.9);
  NewtonSystem system(s.settings, s.mesh, s.constraints);
  CurvatureChoice choice;
  descend(system, s.mesh, s.constraints, choice, {});
  s.constraints.held = true;
  system.assemble(s.mesh.deformed(), s.constraints);
  EXPECT_FALSE(system.lagged_newton_step());
}

TEST(Descend, GoesBackToTheExactHessianThroughParts) {
  Squeezed s(0.2);
  NewtonSystem system(s.settings, s.mesh, s.constraints);
  system.set_lagging(false);
  CurvatureChoice choice;
  double energy = system.objective().value(s.mesh.deformed(), s.constraints).total();
  std::vector<double> parts;
  VertexUpdate update;
  for (int step = 0; step < 50; ++step) {
    update = descend(system, s.mesh, s.constraints, choice, {});
    const double lower = system.objective().value(s.mesh.deformed(), s.constraints).total();
    EXPECT_LE(lower, energy);
    energy = lower;
    if (parts.empty() || parts.back() != update.clamping) parts.push_back(update.clamping);
    if (update.decrement < 1e-12) break;
  }
  EXPECT_LT(update.decrement, 1e-12);
  EXPECT_EQ(parts, (std::vector<double>{1, 0.5, 0.25, 0}));
}

TEST(Descend, WhenCancelledNothingMoves) {
  Squeezed s(0.2);
  NewtonSystem system(s.settings, s.mesh, s.constraints);
  CurvatureChoice choice;
  const Points before = s.mesh.deformed();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(descend(system, s.mesh, s.constraints, choice, stop.get_token()).cancelled);
  EXPECT_EQ(s.mesh.deformed(), before);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/update_vertices.h"

#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "core/solve/line_search.h"
#include "core/solve/relax_vertices.h"
#include "tests/core/solve/newton_fixture.h"

namespace foldless {
namespace {

using test::DenseNewton;
using test::SqueezedGrid;

/// What a line search along a step makes of the mesh, without a NewtonSystem.
LineSearchResult searched(const SqueezedGrid& s, const Points& step) {
  const Objective objective(s.mesh, s.energy.constraints);
  const EnergyGradient start = objective.gradient(s.energy, s.mesh.deformed());
  return line_search(
      objective, s.energy,
      {s.mesh.deformed(), step, start.energy.total(), start.gradient.dot(step.reshaped())});
}

TEST(UpdateVertices, IsADampedNewtonStepAndALineSearch) {
  for (const double size : {0.9, 0.2}) {
    SCOPED_TRACE(size);
    SqueezedGrid s(size);
    DampedSystem system = s.system();
    const DenseNewton dense(s.mesh, s.energy);
    test::Damping damping;
    damping.iterate(dense.smallest_eigenvalue());
    const Points before = s.mesh.deformed(), step = dense.step(damping.mu);
    const LineSearchResult expected = searched(s, step);
    const VertexUpdate update = update_vertices(system, s.mesh, s.energy, {});
    EXPECT_FALSE(update.cancelled);
    EXPECT_DOUBLE_EQ(update.mu, damping.mu);
    EXPECT_EQ(update.mu > 0, size < 0.5);
    EXPECT_NEAR(update.step_length, expected.step_length, 1e-9);
    EXPECT_LT((s.mesh.deformed() - expected.u).norm(), 1e-8);
    EXPECT_NEAR(update.decrement, -0.5 * dense.gradient.dot(step.reshaped()),
                1e-8 * update.decrement);
    EXPECT_EQ(update.step_infinity_norm, (s.mesh.deformed() - before).lpNorm<Eigen::Infinity>());
    EXPECT_EQ(s.effort.factorizations, damping.attempts);
    EXPECT_EQ(s.effort.updates, 1);
  }
}

TEST(UpdateVertices, ReachesTheMinimumWithAFactorOfItsOwnForEveryStep) {
  SqueezedGrid s(0.2);
  DampedSystem system = s.system();
  const Objective objective(s.mesh, s.energy.constraints);
  test::Damping damping;
  int attempts = 0, updates = 0;
  double energy = objective.value(s.energy, s.mesh.deformed()).total();
  double gradient = 1;
  for (; gradient > 1e-9 && updates < 100; ++updates) {
    const DenseNewton dense(s.mesh, s.energy);
    damping.iterate(dense.smallest_eigenvalue());
    attempts += damping.attempts;
    ASSERT_DOUBLE_EQ(update_vertices(system, s.mesh, s.energy, {}).mu, damping.mu);
    const double lower = objective.value(s.energy, s.mesh.deformed()).total();
    EXPECT_LE(lower, energy * (1 + 1e-14));
    energy = lower;
    gradient = objective.gradient(s.energy, s.mesh.deformed()).gradient.norm();
    EXPECT_TRUE(is_injective(s.mesh.triangles(), s.mesh.deformed()));
  }
  EXPECT_LE(gradient, 1e-9);
  EXPECT_EQ(s.effort.factorizations, attempts);
  EXPECT_EQ(s.effort.updates, updates);
}

TEST(UpdateVertices, UsesTheFactorThatRelaxVerticesLeft) {
  SqueezedGrid s(0.9);
  DampedSystem system = s.system();
  ASSERT_FALSE(relax_vertices(system, s.mesh, s.energy, {}));
  ASSERT_EQ(s.effort.factorizations, 1);
  const LineSearchResult expected = searched(s, DenseNewton(s.mesh, s.energy).step());
  const VertexUpdate update = update_vertices(system, s.mesh, s.energy, {});
  EXPECT_EQ(s.effort.factorizations, 1);
  EXPECT_EQ(s.effort.updates, 1);
  EXPECT_EQ(update.mu, 0);
  EXPECT_LT((s.mesh.deformed() - expected.u).norm(), 1e-9) << "with ∇E of the real targets";
}

TEST(UpdateVertices, UsesNoFactorOfAnEarlierPlace) {
  SqueezedGrid s(0.9);
  DampedSystem system = s.system();
  ASSERT_FALSE(relax_vertices(system, s.mesh, s.energy, {}));
  update_vertices(system, s.mesh, s.energy, {});
  const LineSearchResult expected = searched(s, DenseNewton(s.mesh, s.energy).step());
  update_vertices(system, s.mesh, s.energy, {});
  EXPECT_EQ(s.effort.factorizations, 2);
  EXPECT_LT((s.mesh.deformed() - expected.u).norm(), 1e-9);
}

TEST(UpdateVertices, UsesNoFactorOfEarlierTriangles) {
  SqueezedGrid s(0.9);
  DampedSystem system = s.system();
  ASSERT_FALSE(relax_vertices(system, s.mesh, s.energy, {}));
  s.mesh.flip(s.mesh.find_edge(5, 10).value());
  system.follow_flips(s.mesh);
  const LineSearchResult expected = searched(s, DenseNewton(s.mesh, s.energy).step());
  update_vertices(system, s.mesh, s.energy, {});
  EXPECT_EQ(s.effort.factorizations, 2);
  EXPECT_LT((s.mesh.deformed() - expected.u).norm(), 1e-9);
}

TEST(UpdateVertices, DoesNotCountWhereTheLineSearchFindsNothing) {
  SqueezedGrid s(0.9);
  DampedSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  ASSERT_TRUE(system.factorize_plain({}));
  // E along the line has a term more than E at its start.
  Energy higher = s.energy;
  higher.settings.conformal_weight = 100;
  const Points before = s.mesh.deformed();
  const VertexUpdate update = move_vertices(system, s.mesh, higher, 0);
  EXPECT_EQ(update.step_length, 0);
  EXPECT_EQ(update.step_infinity_norm, 0);
  EXPECT_FALSE(update.cancelled);
  EXPECT_EQ(s.mesh.deformed(), before);
  EXPECT_EQ(s.effort.updates, 0);
  EXPECT_TRUE(system.factor().is_exact()) << "nothing moved";
}

TEST(UpdateVertices, DoesNotGoUphill) {
  SqueezedGrid s(0.9);
  DampedSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  const Points before = s.mesh.deformed();
  const Points up = system.gradient().reshaped(2, before.cols());
  EXPECT_EQ(move_along(up, system, s.mesh, s.energy).step_length, 0);
  EXPECT_EQ(move_along(0 * up, system, s.mesh, s.energy).step_length, 0);
  EXPECT_EQ(s.mesh.deformed(), before);
  EXPECT_EQ(s.effort.updates, 0);
}

TEST(UpdateVertices, CancelledChangesNothing) {
  SqueezedGrid s(0.2);
  DampedSystem system = s.system();
  std::stop_source stop;
  stop.request_stop();
  const Points before = s.mesh.deformed();
  EXPECT_TRUE(update_vertices(system, s.mesh, s.energy, stop.get_token()).cancelled);
  EXPECT_EQ(s.mesh.deformed(), before);
  EXPECT_EQ(s.effort.updates, 0);
}

}  // namespace
}  // namespace foldless

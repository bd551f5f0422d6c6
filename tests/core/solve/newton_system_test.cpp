// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_system.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/solve/newton_fixture.h"

namespace foldless {
namespace {

using test::DenseNewton;
using test::SqueezedGrid;

/// A squeezed grid whose ∇²E has that smallest eigenvalue.
SqueezedGrid with_smallest_eigenvalue(double wanted) {
  SqueezedGrid s(0.2);
  // Everything but the factor is gone: ∇²E is proportional to it.
  s.energy.settings.alpha = s.energy.settings.beta = 0;
  s.energy.settings.area_weighted = false;
  s.energy.settings.unit_area = wanted / DenseNewton(s.mesh, s.energy).smallest_eigenvalue();
  return s;
}

TEST(NewtonSystem, AStepSolvesEquationSix) {
  for (const double size : {0.9, 0.2}) {
    SCOPED_TRACE(size);
    SqueezedGrid s(size);
    NewtonSystem system = s.system();
    system.assemble(s.energy, s.mesh.deformed());
    const double mu = system.factorize_damped(false, {}).value();
    EXPECT_EQ(mu > 0, size < 0.5);
    const DenseNewton dense(s.mesh, s.energy);
    EXPECT_EQ(system.gradient(), dense.gradient);
    const Points expected = dense.step(mu);
    EXPECT_LT((system.newton_step() - expected).norm(), 1e-9 * expected.norm());
    const double slope = dense.gradient.dot(expected.reshaped());
    EXPECT_NEAR(system.slope(expected), slope, 1e-12 * std::abs(slope));
    EXPECT_LT(slope, 0);
  }
}

TEST(NewtonSystem, ShiftsAreCumulative) {
  SqueezedGrid s = with_smallest_eigenvalue(-10.5);
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1 + 1 + 10);
  EXPECT_EQ(s.effort.factorizations, 4) << "0, 0.1, 1.1 and 11.1";
}

TEST(NewtonSystem, LambdaIsDividedByTenAfterTheFirstShiftWorked) {
  SqueezedGrid s = with_smallest_eigenvalue(-0.05);
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1);
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.01 + 0.1) << "λ is 0.01";
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1) << "λ stayed at 0.1";
}

TEST(NewtonSystem, LambdaBeginsSmallOnceTheHessianWasDefinite) {
  SqueezedGrid definite(0.9), s = with_smallest_eigenvalue(-0.05);
  NewtonSystem system = s.system();
  system.assemble(definite.energy, definite.mesh.deformed());
  EXPECT_EQ(system.factorize_damped(false, {}), 0);
  EXPECT_EQ(s.effort.factorizations, 1);
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 1e-5 + 1e-4 + 1e-3 + 1e-2 + 1e-1);
  EXPECT_EQ(s.effort.factorizations, 1 + 1 + 5);
}

TEST(NewtonSystem, LambdaBeginsAnewWhenItRanOutOfRange) {
  SqueezedGrid hopeless = with_smallest_eigenvalue(-1e19), s = with_smallest_eigenvalue(-10.5);
  NewtonSystem system = hopeless.system();
  system.assemble(hopeless.energy, hopeless.mesh.deformed());
  EXPECT_FALSE(system.factorize_damped(false, {}));
  EXPECT_EQ(hopeless.effort.factorizations, 1 + 19) << "λ from 1e-1 to 1e17";
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1 + 1 + 10);
}

TEST(NewtonSystem, DampingGoesByTheEigenvaluesFromIterationToIteration) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-7, 7);
  SqueezedGrid definite(0.9);
  NewtonSystem system = definite.system();
  test::Damping expected;
  for (int iteration = 0; iteration < 100; ++iteration) {
    SCOPED_TRACE(testing::Message() << "iteration " << iteration);
    const bool is_definite = random() % 8 == 0;
    const double smallest = -std::pow(10, exponent(random));
    SqueezedGrid s = is_definite ? definite : with_smallest_eigenvalue(smallest);
    expected.iterate(is_definite ? 1 : smallest);
    const int before = definite.effort.factorizations;
    system.assemble(s.energy, s.mesh.deformed());
    ASSERT_NEAR(system.factorize_damped(false, {}).value(), expected.mu, 1e-12 * expected.mu);
    ASSERT_EQ(definite.effort.factorizations - before, expected.attempts);
  }
}

TEST(NewtonSystem, ThePlainHessianIsNotTriedTwice) {
  SqueezedGrid s = with_smallest_eigenvalue(-0.05);
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_FALSE(system.factorize_plain());
  EXPECT_DOUBLE_EQ(system.factorize_damped(true, {}).value(), 0.1);
  EXPECT_EQ(s.effort.factorizations, 2);
}

TEST(NewtonSystem, CancelledDampingGivesNothing) {
  SqueezedGrid s(0.2);
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(system.factorize_damped(false, stop.get_token()));
  EXPECT_EQ(s.effort.factorizations, 0) << "not even the plain one";
}

TEST(NewtonSystem, HasAPlainFactorOfWhatWasAssembledLastOnly) {
  SqueezedGrid s(0.9);
  NewtonSystem system = s.system();
  const auto factorized = [&] {
    system.assemble(s.energy, s.mesh.deformed());
    EXPECT_FALSE(system.has_plain_factor());
    EXPECT_TRUE(system.factorize_plain());
    return system.has_plain_factor();
  };
  EXPECT_TRUE(factorized());
  EXPECT_TRUE(factorized()) << "and not what was assembled before";
  system.moved();
  EXPECT_FALSE(system.has_plain_factor());
  EXPECT_TRUE(factorized());
  system.follow_flips(s.mesh, 0);
  EXPECT_FALSE(system.has_plain_factor());
  EXPECT_TRUE(factorized());
  system.rebuild(s.mesh, s.energy.constraints, 0);
  EXPECT_FALSE(system.has_plain_factor());
  EXPECT_TRUE(factorized());
  EXPECT_EQ(system.factorize_damped(true, {}), 1e-5);
  EXPECT_FALSE(system.has_plain_factor()) << "that of a shifted one";
}

TEST(NewtonSystem, FollowsFlipsAsIfItWereNew) {
  SqueezedGrid s(0.9);
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  ASSERT_TRUE(system.factorize_plain());
  for (const auto& [a, b] : {Edge{0, 5}, Edge{5, 10}, Edge{6, 11}}) {
    s.mesh.flip(s.mesh.find_edge(a, b).value());
    system.follow_flips(s.mesh, 1);
  }
  system.assemble(s.energy, s.mesh.deformed());
  ASSERT_TRUE(system.factorize_plain());
  const Points expected = DenseNewton(s.mesh, s.energy).step();
  EXPECT_LT((system.newton_step() - expected).norm(), 1e-9 * expected.norm());
}

TEST(NewtonSystem, TheOthersFollowCarriedHandlesAsTheDenseSystemSays) {
  SqueezedGrid s(0.8);
  const DenseNewton free(s.mesh, s.energy, 1);
  Points way = Points::Zero(2, s.mesh.vertex_count());
  way.col(3) = Vec2(0.1, -0.2);
  way.col(12) = Vec2(-0.05, 0.3);
  s.energy.constraints.held = true;
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed(), 1);
  ASSERT_TRUE(system.factorize(0));
  const Points step = system.carrying_step(s.energy.settings, s.mesh.deformed(), way);
  // K_ff d_f = −∇E_f − K_fh δ, by taking rows and columns out of the dense system.
  std::vector<int> f, h;
  for (int v = 0; v < s.mesh.vertex_count(); ++v)
    for (const int i : {2 * v, 2 * v + 1})
      (v == 0 || v == 3 || v == 12 || v == 15 ? h : f).push_back(i);
  const Eigen::VectorXd delta = way.reshaped();
  const Eigen::VectorXd d_f =
      free.hessian(f, f).ldlt().solve(-free.gradient(f) - free.hessian(f, h) * delta(h));
  EXPECT_LT((step.reshaped()(f) - d_f).norm(), 1e-9 * d_f.norm());
  EXPECT_EQ(step.reshaped()(h), delta(h));
}

}  // namespace
}  // namespace foldless

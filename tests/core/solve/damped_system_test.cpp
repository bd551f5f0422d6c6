// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/damped_system.h"

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

TEST(DampedSystem, ShiftsAreCumulative) {
  SqueezedGrid s = with_smallest_eigenvalue(-10.5);
  DampedSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1 + 1 + 10);
  EXPECT_EQ(s.effort.factorizations, 4) << "0, 0.1, 1.1 and 11.1";
}

TEST(DampedSystem, LambdaIsDividedByTenAfterTheFirstShiftWorked) {
  SqueezedGrid s = with_smallest_eigenvalue(-0.05);
  DampedSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1);
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.01 + 0.1) << "λ is 0.01";
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1) << "λ stayed at 0.1";
}

TEST(DampedSystem, LambdaBeginsSmallOnceTheHessianWasDefinite) {
  SqueezedGrid definite(0.9), s = with_smallest_eigenvalue(-0.05);
  DampedSystem system = s.system();
  system.assemble(definite.energy, definite.mesh.deformed());
  EXPECT_EQ(system.factorize_damped(false, {}), 0);
  EXPECT_EQ(s.effort.factorizations, 1);
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 1e-5 + 1e-4 + 1e-3 + 1e-2 + 1e-1);
  EXPECT_EQ(s.effort.factorizations, 1 + 1 + 5);
}

TEST(DampedSystem, LambdaBeginsAnewWhenItRanOutOfRange) {
  SqueezedGrid hopeless = with_smallest_eigenvalue(-1e19), s = with_smallest_eigenvalue(-10.5);
  DampedSystem system = hopeless.system();
  system.assemble(hopeless.energy, hopeless.mesh.deformed());
  EXPECT_FALSE(system.factorize_damped(false, {}));
  EXPECT_EQ(hopeless.effort.factorizations, 1 + 19) << "λ from 1e-1 to 1e17";
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_DOUBLE_EQ(system.factorize_damped(false, {}).value(), 0.1 + 1 + 10);
}

TEST(DampedSystem, DampingGoesByTheEigenvaluesFromIterationToIteration) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-7, 7);
  SqueezedGrid definite(0.9);
  DampedSystem system = definite.system();
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

TEST(DampedSystem, ThePlainHessianIsNotTriedTwice) {
  SqueezedGrid s = with_smallest_eigenvalue(-0.05);
  DampedSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  EXPECT_FALSE(system.factorize_plain({}));
  EXPECT_DOUBLE_EQ(system.factorize_damped(true, {}).value(), 0.1);
  EXPECT_EQ(s.effort.factorizations, 2);
}

TEST(DampedSystem, CancelledDampingGivesNothing) {
  SqueezedGrid s(0.2);
  DampedSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(system.factorize_damped(false, stop.get_token()));
  EXPECT_EQ(s.effort.factorizations, 0) << "not even the plain one";
}

}  // namespace
}  // namespace foldless

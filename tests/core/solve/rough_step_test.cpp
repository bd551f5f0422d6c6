// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of large meshes, whose factors are in single precision.
#include <gtest/gtest.h>

#include <cmath>

#include "core/energy/densities.h"
#include "core/linear/single_precision_solve.h"
#include "core/solve/carry_handles.h"
#include "core/solve/descent.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

constexpr int kSide = 46;  // 4,232 unknowns

/// A large grid that is bent a little, with its corners pulled.
struct BentGrid {
  explicit BentGrid(int side = kSide) {
    const auto f = test::square_grid(side);
    Points u = f.rest;
    for (Eigen::Index v = 0; v < u.cols(); ++v)
      u.col(v) += 0.02 * Vec2(std::sin(0.3 * u(1, v)), std::cos(0.2 * u(0, v)));
    mesh = MeshPair(f.triangles, f.rest, u);
    std::vector<Handle> corners;
    for (const int v : {0, side - 1, side * (side - 1), side * side - 1})
      corners.push_back({.id = v, .vertex = v, .target = 1.03 * f.rest.col(v)});
    energy.constraints = constraints_of(corners);
    energy.settings.density = find_density("symmetric-dirichlet");
    energy.settings.alpha = 1;
    energy.settings.beta = 0.01;
  }
  /// Makes a triangle nearly flat: its barrier is as stiff as no other.
  void crush(double height) {
    Points u = mesh.deformed();
    const Eigen::Vector3i t = mesh.triangles().col(mesh.face_count() / 2);
    const Vec2 a = u.col(t[0]), along = u.col(t[1]) - a;
    u.col(t[2]) = a + 0.5 * along + height * Vec2(-along.y(), along.x());
    mesh.set_deformed(u);
  }
  NewtonSystem system() { return {mesh, energy.constraints, effort}; }

  MeshPair mesh;
  Energy energy;
  Effort effort;
};

/// How far the vertices went from `start`.
Points way_of(const BentGrid& bent, const Points& start) { return bent.mesh.deformed() - start; }

TEST(RoughStep, IsNearlyNewtons) {
  BentGrid rough, exact;
  NewtonSystem system = rough.system(), exact_system = exact.system();
  const Points start = rough.mesh.deformed();
  Descent lagged, own(FactorUse::own);
  EXPECT_EQ(lagged.step(system, rough.mesh, rough.energy, {}).mu, 0);
  own.step(exact_system, exact.mesh, exact.energy, {});
  EXPECT_EQ(rough.effort.factorizations, 1);
  const Points newton = way_of(exact, start);
  EXPECT_LT((way_of(rough, start) - newton).norm(), 1e-3 * newton.norm());
}

TEST(RoughStep, IsNearlyThatOfTheClampedHessian) {
  if (!solves_in_single_precision()) GTEST_SKIP() << "this processor solves in doubles alone";
  BentGrid bent;
  NewtonSystem system = bent.system();
  system.assemble(bent.energy, bent.mesh.deformed(), 1);
  const auto rough = rough_clamped_step(system, {}, [&] { return lagged_newton_step(system); });
  ASSERT_TRUE(rough && !rough->is_indefinite);
  EXPECT_EQ(bent.effort.factorizations, 1);
  ASSERT_TRUE(factorize(system, 0));
  const Points newton = newton_step(system);
  const double difference = (rough->step - newton).norm() / newton.norm();
  EXPECT_LT(difference, 1e-3);
  EXPECT_GT(difference, 1e-12) << "it is of a factor in full precision";
}

TEST(RoughStep, CarriesHandlesWhereTheyGo) {
  BentGrid rough, exact;
  for (BentGrid* bent : {&rough, &exact}) bent->energy.constraints.held = true;
  NewtonSystem system = rough.system(), exact_system = exact.system();
  exact_system.factor().set_too_rough();
  exact_system.factor().set_too_rough();
  const Points start = rough.mesh.deformed();
  EXPECT_EQ(carry_handles(system, rough.mesh, rough.energy, {}).step_length, 1);
  EXPECT_EQ(carry_handles(exact_system, exact.mesh, exact.energy, {}).step_length, 1);
  EXPECT_EQ(rough.effort.factorizations, 1);
  const Points newton = way_of(exact, start);
  EXPECT_LT((way_of(rough, start) - newton).norm(), 1e-3 * newton.norm());
  for (const int i : {0, 1, 2, 3})
    EXPECT_EQ(rough.mesh.deformed().col(rough.energy.constraints.vertices[i]),
              rough.energy.constraints.targets.col(i));
}

TEST(RoughStep, IsForLargeMeshes) {
  BentGrid small(20), large;
  NewtonSystem few = small.system(), many = large.system();
  few.assemble(small.energy, small.mesh.deformed());
  many.assemble(large.energy, large.mesh.deformed());
  EXPECT_EQ(few.factor().for_iterations(few.hessian()), Precision::full);
  EXPECT_EQ(many.factor().for_iterations(many.hessian()),
            solves_in_single_precision() ? Precision::single : Precision::full);
}

/// Iterations begin from such a factor for good after a step of a mesh with a triangle that is so
/// low, or, where it is one in full precision, from none.
void expect_for_good(double height, Precision precision) {
  BentGrid bent;
  bent.crush(height);
  NewtonSystem system = bent.system();
  Descent descent;
  const double before = system.objective().value(bent.energy, bent.mesh.deformed()).total();
  EXPECT_GT(descent.step(system, bent.mesh, bent.energy, {}).step_length, 0);
  EXPECT_LT(system.objective().value(bent.energy, bent.mesh.deformed()).total(), before);
  EXPECT_EQ(system.factor().for_iterations(system.hessian()), precision);
  system.factor().set_far();
  const int factorizations = bent.effort.factorizations;
  system.assemble(bent.energy, bent.mesh.deformed(), 1);
  const bool is_rough = precision != Precision::full;
  const auto step = rough_clamped_step(system, {}, [&] { return lagged_newton_step(system); });
  EXPECT_EQ(step.has_value(), is_rough);
  EXPECT_EQ(bent.effort.factorizations, factorizations + (is_rough ? 1 : 0));
}

TEST(RoughStep, IsMadeInDoublesForGoodWhereATriangleIsCrushed) {
  if (!solves_in_single_precision()) GTEST_SKIP() << "this processor solves in doubles alone";
  expect_for_good(1e-3, Precision::rounded);
}

TEST(RoughStep, IsGivenUpForGoodWhereATriangleIsCrushedMore) {
  if (!solves_in_single_precision()) GTEST_SKIP() << "this processor solves in doubles alone";
  expect_for_good(1e-4, Precision::full);
}

TEST(RoughStep, StoppedIsNotGivenUp) {
  if (!solves_in_single_precision()) GTEST_SKIP() << "this processor solves in doubles alone";
  BentGrid bent;
  NewtonSystem system = bent.system();
  system.assemble(bent.energy, bent.mesh.deformed(), 1);
  std::stop_source stop;
  stop.request_stop();
  const auto lagged = [&] { return lagged_newton_step(system); };
  EXPECT_FALSE(rough_clamped_step(system, stop.get_token(), lagged));
  EXPECT_EQ(system.factor().for_iterations(system.hessian()), Precision::single);
  EXPECT_TRUE(rough_clamped_step(system, {}, lagged));
}

}  // namespace
}  // namespace foldless

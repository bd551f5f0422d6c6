// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/objective.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/dense_matrix.h"
#include "tests/support/finite_difference.h"
#include "tests/support/meshes.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

Constraints corner_handles(const Points& rest) {
  Handle fixed{.id = 0, .vertex = 0, .target = rest.col(0)};
  Handle moved{.id = 1, .vertex = 8, .target = rest.col(8) + Vec2(0.1, -0.2)};
  Handle soft{
      .id = 2, .vertex = 4, .target = Vec2(1, 1.1), .kind = HandleKind::soft, .weight = 0.5};
  return constraints_of({fixed, moved, soft});
}

Points shaken(const Points& rest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-0.25, 0.25);
  Points u = rest;
  for (Eigen::Index i = 0; i < u.size(); ++i) u.data()[i] += unit(random);
  return u;
}

class ObjectiveTest : public testing::TestWithParam<Density> {};

TEST_P(ObjectiveTest, GradientAndHessianAgreeWithFiniteDifferences) {
  const auto f = test::square_grid(3);
  const MeshPair mesh(f.triangles, f.rest);
  const Constraints constraints = corner_handles(f.rest);
  // α is small here so that the penalty does not hide the other terms.
  for (const bool weighted : {true, false}) {
    EnergySettings settings{&GetParam(), 3.0, 0.7, 1e-2, weighted};
    settings.conformal_weight = weighted ? 0.3 : 0;
    const Objective objective(settings, mesh, constraints);
    const Points u = shaken(f.rest, 5);
    ASSERT_TRUE(std::isfinite(objective.value(u, constraints).total()));
    const auto points = [](const Eigen::VectorXd& x) -> Points {
      return x.reshaped(2, x.size() / 2);
    };
    const Eigen::VectorXd x = u.reshaped();
    SparseSymmetric hessian = objective.hessian_pattern();
    const auto [energy, gradient] = objective.assemble(u, constraints, hessian);
    const EnergyGradient by_itself = objective.gradient(u, constraints);
    EXPECT_LT(test::relative_difference(by_itself.gradient, gradient), 1e-14);
    const double total = objective.value(u, constraints).total();
    EXPECT_NEAR(energy.total(), total, 1e-13 * total);
    EXPECT_NEAR(by_itself.energy.total(), total, 1e-13 * total);
    const Eigen::MatrixXd numeric_gradient = test::finite_difference(
        [&](const Eigen::VectorXd& y) {
          return Eigen::VectorXd::Constant(1, objective.value(points(y), constraints).total());
        },
        x, 1e-4);
    const Eigen::MatrixXd numeric_hessian = test::finite_difference(
        [&](const Eigen::VectorXd& y) { return objective.gradient(points(y), constraints).gradient; },
        x, 1e-4);
    EXPECT_LT(test::relative_difference(numeric_gradient.transpose(), gradient), 1e-6);
    EXPECT_LT(test::relative_difference(numeric_hessian, test::dense(hessian)), 1e-6);
  }
}

TEST_P(ObjectiveTest, SplittingATriangleDoesNotChangeTheWeightedDistortion) {
  const auto f = test::square_grid(3);
  MeshPair mesh(f.triangles, f.rest, shaken(f.rest, 5));
  const Constraints constraints = corner_handles(f.rest);
  const EnergySettings settings{&GetParam(), 3.0, 0.7, 1e-2, true};
  const double before =
      Objective(settings, mesh, constraints).value(mesh.deformed(), constraints).distortion;
  mesh.split_triangle(3, {0.2, 0.5, 0.3});
  mesh.split_edge(7, 0.3);
  const double after =
      Objective(settings, mesh, constraints).value(mesh.deformed(), constraints).distortion;
  EXPECT_NEAR(after, before, 1e-12 * before);
}

INSTANTIATE_TEST_SUITE_P(Densities, ObjectiveTest,
                         testing::ValuesIn(densities().begin(), densities().end()),
                         [](const auto& row) {
                           std::string name(row.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(Objective, IsInfiniteOutsideTheFeasibleSetEvenWithoutABarrier) {
  const auto f = test::hexagon();
  const MeshPair mesh(f.triangles, f.rest);
  const Constraints constraints = constraints_of({Handle{.vertex = 1, .target = f.rest.col(1)}});
  const Objective objective({find_density("arap"), 1, 0, 1e-3, true}, mesh, constraints);
  Points u = f.rest;
  u.col(0) = Vec2(2, 0);
  EXPECT_TRUE(std::isinf(objective.value(u, constraints).total()));
}

TEST(Objective, TheStepBoundIsWhereTheFirstTriangleReachesItsSmallestArea) {
  const auto f = test::hexagon();
  const MeshPair mesh(f.triangles, f.rest);
  const Constraints constraints = constraints_of({Handle{.vertex = 1, .target = f.rest.col(1)}});
  const double delta = 0.1;
  const Objective objective({find_density("arap"), 1, 0.01, delta, true}, mesh, constraints);
  Points step = Points::Zero(2, 7);
  step.col(0) = Vec2(0, 1);
  // The height of the triangle above shrinks from √3/2; its area bound is δ of it.
  EXPECT_NEAR(objective.largest_step(f.rest, step), std::sqrt(3) / 2 * (1 - delta), 1e-12);
  EXPECT_TRUE(std::isinf(objective.largest_step(f.rest, Points::Zero(2, 7))));
}

TEST(Unknowns, ComponentsWithoutAHandleAndUnusedVerticesStay) {
  Triangles triangles(3, 2);
  triangles << 0, 3, 1, 4, 2, 5;
  Points rest(2, 7);
  rest << 0, 1, 0, 5, 6, 5, 9,  //
      0, 0, 1, 0, 0, 1, 9;
  const MeshPair mesh(triangles, rest);
  const Unknowns unknowns = unknowns_of(mesh, {4});
  EXPECT_EQ(unknowns.vertex_of_node, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(unknowns.node_of_vertex[0], -1);
  EXPECT_EQ(unknowns.node_of_vertex[6], -1);
}

TEST(Constraints, SoftHandlesPullButDoNotCount) {
  Points u(2, 2);
  u << 0, 1,  //
      0, 1;
  const Constraints constraints = constraints_of(
      {Handle{.vertex = 0, .target = Vec2(3, 4)},
       Handle{.vertex = 1, .target = Vec2(1, 2), .kind = HandleKind::soft, .weight = 2}});
  EXPECT_DOUBLE_EQ(penalty(constraints, u), 25 + 2);
  EXPECT_DOUBLE_EQ(handle_error_squared(constraints, u), 25);
  EXPECT_DOUBLE_EQ(penalty(held_where_they_are(constraints, u), u), 0);
}

}  // namespace
}  // namespace foldless

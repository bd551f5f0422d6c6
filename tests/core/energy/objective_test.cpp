// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/objective.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

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

/// Ten times as stiff near the left side of a grid.
std::shared_ptr<const Stiffness> half_stiff() {
  Points line(2, 2);
  line << 0, 0,  //
      0, 2;
  return std::make_shared<const Stiffness>(std::vector<StiffStroke>{{line, 1, 10}});
}

class ObjectiveTest : public testing::TestWithParam<Density> {};

TEST_P(ObjectiveTest, GradientAndHessianAgreeWithFiniteDifferences) {
  const auto f = test::square_grid(3);
  MeshPair mesh(f.triangles, f.rest);
  mesh.set_stiffness(half_stiff());
  // α is small here so that the penalty does not hide the other terms.
  for (const bool weighted : {true, false}) {
    Energy e{{&GetParam(), 3.0, 0.7, 1e-2, weighted}, corner_handles(f.rest)};
    e.settings.conformal_weight = weighted ? 0.3 : 0;
    const Objective objective(mesh, e.constraints);
    const Points u = shaken(f.rest, 5);
    ASSERT_TRUE(std::isfinite(objective.value(e, u).total()));
    const auto points = [](const Eigen::VectorXd& x) -> Points {
      return x.reshaped(2, x.size() / 2);
    };
    const Eigen::VectorXd x = u.reshaped();
    SparseSymmetric hessian = objective.hessian_pattern();
    const auto [energy, gradient] = objective.assemble(e, u, hessian);
    const EnergyGradient by_itself = objective.gradient(e, u);
    EXPECT_LT(test::relative_difference(by_itself.gradient, gradient), 1e-14);
    const double total = objective.value(e, u).total();
    EXPECT_NEAR(energy.total(), total, 1e-13 * total);
    EXPECT_NEAR(by_itself.energy.total(), total, 1e-13 * total);
    const Eigen::MatrixXd numeric_gradient = test::finite_difference(
        [&](const Eigen::VectorXd& y) {
          return Eigen::VectorXd::Constant(1, objective.value(e, points(y)).total());
        },
        x, 1e-4);
    const Eigen::MatrixXd numeric_hessian = test::finite_difference(
        [&](const Eigen::VectorXd& y) { return objective.gradient(e, points(y)).gradient; }, x,
        1e-4);
    EXPECT_LT(test::relative_difference(numeric_gradient.transpose(), gradient), 1e-6);
    EXPECT_LT(test::relative_difference(numeric_hessian, test::dense(hessian)), 1e-6);
  }
}

TEST_P(ObjectiveTest, SplittingATriangleDoesNotChangeTheWeightedDistortion) {
  const auto f = test::square_grid(3);
  MeshPair mesh(f.triangles, f.rest, shaken(f.rest, 5));
  const Energy e{{&GetParam(), 3.0, 0.7, 1e-2, true}, corner_handles(f.rest)};
  const double before = Objective(mesh, e.constraints).value(e, mesh.deformed()).distortion;
  mesh.split_triangle(3, {0.2, 0.5, 0.3});
  mesh.split_edge(7, 0.3);
  const double after = Objective(mesh, e.constraints).value(e, mesh.deformed()).distortion;
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
  const Energy e{{find_density("arap"), 1, 0, 1e-3, true},
                 constraints_of({Handle{.vertex = 1, .target = f.rest.col(1)}})};
  const Objective objective(mesh, e.constraints);
  Points u = f.rest;
  u.col(0) = Vec2(2, 0);
  EXPECT_TRUE(std::isinf(objective.value(e, u).total()));
}

/// The grid under an affine map: every triangle has the same J.
struct Affine {
  Affine() : u(J * f.rest), mesh(f.triangles, f.rest, u), objective(mesh, {}) {}

  EnergyTerms value(const EnergySettings& settings) const {
    const Energy e{settings, {}};
    const EnergyTerms terms = objective.value(e, u);
    EXPECT_NEAR(objective.gradient(e, u).energy.total(), terms.total(), 1e-12 * terms.total());
    return terms;
  }

  const Mat2 J{{0.7, 0.2}, {-0.1, 0.5}};
  const test::Fixture f = test::square_grid(3);  // eight triangles of area ½
  const Points u;
  const MeshPair mesh;
  const Objective objective;
};

TEST(Objective, SumsArePerAreaOrPerTriangleAsTheSettingsSay) {
  const Affine map;
  const double psi = find_density("arap")->value(map.J);
  const double x = (map.J.determinant() - 0.1) / 0.9;
  const double chi = 1 / (1 - std::pow(1 - x, 3)) - 1;
  EnergySettings settings{find_density("arap"), 1, 0.3, 0.1};
  EXPECT_NEAR(map.value(settings).distortion, 4 * psi, 1e-13);
  EXPECT_NEAR(map.value(settings).barrier, 0.3 * 8 * chi, 1e-13);
  settings.area_weighted = false;
  settings.unit_area = 5;
  EXPECT_NEAR(map.value(settings).distortion, 5 * 8 * psi, 1e-13);
  EXPECT_NEAR(map.value(settings).barrier, 0.3 * 8 * chi, 1e-13);
  settings.barrier_area_weighted = true;
  EXPECT_NEAR(map.value(settings).barrier, 0.3 * 4 * chi, 1e-13);
  settings.beta = 0;
  EXPECT_EQ(map.value(settings).barrier, 0);
  settings.conformal_weight = 0.2;
  const double conformal = std::pow(map.J.squaredNorm() / (2 * map.J.determinant()), 2);
  EXPECT_NEAR(map.value(settings).barrier, 0.2 * 8 * conformal, 1e-12);
}

TEST(Objective, StiffnessIsAFactorOnTheDistortionOfWhatItCovers) {
  const auto f = test::square_grid(3);
  MeshPair mesh(f.triangles, f.rest);
  const Points u = shaken(f.rest, 5);
  const Constraints constraints = corner_handles(f.rest);
  for (const bool weighted : {true, false})
    for (const Reference reference : {Reference::rest, Reference::equilateral}) {
      Energy e{{find_density("arap"), 3.0, 0.7, 1e-2, weighted}, constraints};
      e.settings.reference = reference;
      const auto distortion = [&](const std::vector<Eigen::Index>& triangles) {
        Triangles some(3, static_cast<Eigen::Index>(triangles.size()));
        for (std::size_t i = 0; i < triangles.size(); ++i)
          some.col(static_cast<Eigen::Index>(i)) = f.triangles.col(triangles[i]);
        return Objective(MeshPair(some, f.rest), constraints).value(e, u).distortion;
      };
      // The cells of the left column are the first two of each row of two.
      const double left = distortion({0, 1, 4, 5}), right = distortion({2, 3, 6, 7});
      mesh.set_stiffness(nullptr);
      const EnergyTerms plain = Objective(mesh, constraints).value(e, u);
      EXPECT_NEAR(plain.distortion, left + right, 1e-12);
      mesh.set_stiffness(half_stiff());
      const EnergyTerms stiff = Objective(mesh, constraints).value(e, u);
      EXPECT_NEAR(stiff.distortion, 10 * left + right, 1e-11);
      EXPECT_EQ(stiff.barrier, plain.barrier);
      EXPECT_EQ(stiff.penalty, plain.penalty);
    }
}

TEST(Objective, AnEquilateralReferenceForgetsTheRestShapeButNotItsArea) {
  const Affine map;
  EnergySettings settings{find_density("symmetric-dirichlet"), 1, 0, 0.1};
  settings.reference = Reference::equilateral;
  // The right-angled triangle with legs 1 is this image of the equilateral one of its area.
  const double side = std::sqrt(2 / std::sqrt(3));
  Mat2 equilateral, right;
  equilateral << side, side / 2, 0, side * std::sqrt(0.75);
  right << 1, 1, 0, 1;
  const double lower = settings.density->value(map.J * right * equilateral.inverse());
  right << 1, 0, 1, 1;
  const double upper = settings.density->value(map.J * right * equilateral.inverse());
  EXPECT_NEAR(map.value(settings).distortion, 4 * 0.5 * (lower + upper), 1e-12);
}

TEST(Objective, HeldHandlesAreNoUnknownsAndHaveNoPenalty) {
  const auto f = test::square_grid(3);
  const MeshPair mesh(f.triangles, f.rest);
  const Points u = shaken(f.rest, 5);
  Energy e{{find_density("arap"), 3.0, 0.7, 1e-2}, corner_handles(f.rest)};
  const Objective objective(mesh, e.constraints);
  SparseSymmetric free = objective.hessian_pattern(), fixed = free;
  const EnergyGradient free_gradient = objective.assemble(e, u, free);
  e.constraints.held = true;
  const EnergyGradient gradient = objective.assemble(e, u, fixed);
  EXPECT_DOUBLE_EQ(gradient.energy.penalty, 3 * 0.5 * (u.col(4) - Vec2(1, 1.1)).squaredNorm());
  EXPECT_LT((objective.gradient(e, u).gradient - gradient.gradient).norm(), 1e-13);
  Eigen::MatrixXd expected = test::dense(free);
  Eigen::VectorXd expected_gradient = free_gradient.gradient;
  for (const int v : {0, 8})
    for (const int i : {2 * v, 2 * v + 1}) {
      expected.row(i).setZero();
      expected.col(i).setZero();
      expected(i, i) = 1;
      expected_gradient[i] = 0;
    }
  EXPECT_LT((test::dense(fixed) - expected).norm(), 1e-12);
  EXPECT_LT((gradient.gradient - expected_gradient).norm(), 1e-12);
}

TEST(Objective, HandlesPullByTheirPartOfTheClampedHessian) {
  const auto f = test::square_grid(3);
  const MeshPair mesh(f.triangles, f.rest);
  const Points u = 0.4 * shaken(f.rest, 5);  // ARAP has negative curvature there
  const Energy e{{find_density("arap"), 0, 0.1, 1e-2}, corner_handles(f.rest)};
  const Objective objective(mesh, e.constraints);
  SparseSymmetric clamped = objective.hessian_pattern(), exact = clamped;
  objective.assemble(e, u, clamped, 1);
  objective.assemble(e, u, exact);
  Points way = Points::Zero(2, 9);
  way.col(0) = Vec2(0.3, -0.1);
  way.col(8) = Vec2(-0.2, 0.4);
  Eigen::VectorXd expected = test::dense(clamped) * way.reshaped();
  ASSERT_GT((test::dense(exact) * way.reshaped() - expected).norm(), 1e-3);
  for (const int v : {0, 8}) expected.segment<2>(2 * v).setZero();
  EXPECT_LT((objective.pull_of_handles(e.settings, u, way) - expected).norm(), 1e-12);
}

TEST(Objective, FollowsFlipsAsIfItWereNew) {
  const auto f = test::square_grid(3);
  MeshPair mesh(f.triangles, f.rest, shaken(f.rest, 5));
  const Energy e{{find_density("arap"), 3.0, 0.7, 1e-2}, corner_handles(f.rest)};
  Objective objective(mesh, e.constraints);
  for (const Edge& diagonal : {Edge{0, 4}, Edge{4, 8}})
    mesh.flip(mesh.find_edge(diagonal[0], diagonal[1]).value());
  objective.follow_flips(mesh);
  const Objective anew(mesh, e.constraints);
  EXPECT_EQ(objective.gradient(e, mesh.deformed()).gradient,
            anew.gradient(e, mesh.deformed()).gradient);
  Points way = Points::Zero(2, 9);
  way.col(8) = Vec2(1, 2);
  EXPECT_EQ(objective.pull_of_handles(e.settings, mesh.deformed(), way),
            anew.pull_of_handles(e.settings, mesh.deformed(), way));
  EXPECT_EQ(objective.largest_step(e.settings, mesh.deformed(), way),
            anew.largest_step(e.settings, mesh.deformed(), way));
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/moved_corner.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>
#include <vector>

#include "core/energy/densities.h"
#include "tests/support/finite_difference.h"

namespace foldless {
namespace {

/// A triangle at rest and deformed.
struct Pair {
  Corners rest, deformed;
};

Pair random_pair(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-0.25, 0.25);
  Pair pair;
  pair.rest << 0, 1, 0, 0, 0, 1;
  pair.deformed << 2, 2, 1, 3, 4, 3;
  for (Corners* corners : {&pair.rest, &pair.deformed})
    *corners = corners->unaryExpr([&](double x) { return x + unit(random); });
  return pair;
}

/// Corner 0 moved by (X, Y) at rest and by (x, y) deformed.
Pair moved(Pair pair, const Eigen::VectorXd& by) {
  pair.rest.col(0) += by.head<2>();
  pair.deformed.col(0) += by.tail<2>();
  return pair;
}

RestElement element_of(const Pair& pair) {
  RestElement rest = rest_element(pair.rest);
  rest.stiffness = 1.7;
  return rest;
}

std::vector<EnergySettings> settings_of_all() {
  std::vector<EnergySettings> all;
  for (const Density& density : densities())
    for (const bool area_weighted : {true, false})
      for (const bool barrier_area_weighted : {true, false})
        for (const double conformal_weight : {0.0, 0.3})
          all.push_back({.density = &density,
                         .beta = 0.4,
                         .delta = 1e-3,
                         .area_weighted = area_weighted,
                         .unit_area = 2.5,
                         .barrier_area_weighted = barrier_area_weighted,
                         .conformal_weight = conformal_weight,
                         .conformal_power = 4});
  return all;
}

TEST(MovedCorner, GradientAgreesWithFiniteDifferencesForEveryEnergy) {
  std::mt19937_64 random(3);
  for (const EnergySettings& settings : settings_of_all())
    for (int trial = 0; trial < 5; ++trial) {
      SCOPED_TRACE(testing::Message() << settings.density->name << ", trial " << trial);
      const Pair pair = random_pair(random);
      const MovedCorner at = moved_corner(settings, element_of(pair), pair.deformed);
      const auto energy = [&](const Eigen::VectorXd& by) {
        const Pair other = moved(pair, by);
        return Eigen::VectorXd::Constant(
            1, element_energy(settings, element_of(other), other.deformed).total());
      };
      EXPECT_NEAR(at.energy, energy(Eigen::Vector4d::Zero())[0], 1e-14 * at.energy);
      const Eigen::MatrixXd expected =
          test::finite_difference(energy, Eigen::Vector4d::Zero(), 1e-3);
      EXPECT_LT((expected.transpose() - at.gradient).norm(), 1e-6 * (1 + at.gradient.norm()));
    }
}

TEST(MovedCorner, HessianOfWhatIsWeightedByAreaAgreesWithFiniteDifferences) {
  std::mt19937_64 random(4);
  for (const EnergySettings& settings : settings_of_all()) {
    if (!settings.area_weighted || !settings.barrier_area_weighted) continue;
    if (settings.conformal_weight > 0) continue;
    for (int trial = 0; trial < 5; ++trial) {
      SCOPED_TRACE(testing::Message() << settings.density->name << ", trial " << trial);
      const Pair pair = random_pair(random);
      const auto gradient = [&](const Eigen::VectorXd& by) -> Eigen::VectorXd {
        const Pair other = moved(pair, by);
        return moved_corner(settings, element_of(other), other.deformed).gradient;
      };
      const Eigen::MatrixXd expected =
          test::finite_difference(gradient, Eigen::Vector4d::Zero(), 1e-3);
      const MovedCorner at = moved_corner(settings, element_of(pair), pair.deformed);
      EXPECT_LT(test::relative_difference(at.hessian, expected), 1e-5);
    }
  }
}

TEST(MovedCorner, HasNoNegativeCurvatureWhereThatIsClamped) {
  std::mt19937_64 random(5);
  for (const EnergySettings& settings : settings_of_all()) {
    const Pair pair = random_pair(random);
    const MovedCorner at = moved_corner(settings, element_of(pair), pair.deformed, 1);
    const Eigen::Vector4d curvature =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(at.hessian).eigenvalues();
    EXPECT_GE(curvature[0], -1e-9 * curvature[3]) << settings.density->name;
  }
}

}  // namespace
}  // namespace foldless

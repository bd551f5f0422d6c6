// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/energy/objective.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

TEST(StepBound, IsWhereTheFirstTriangleReachesItsSmallestArea) {
  const auto f = test::hexagon();
  const MeshPair mesh(f.triangles, f.rest);
  EnergySettings settings;
  const double delta = settings.delta = 0.1;
  const Objective objective(mesh, {});
  Points step = Points::Zero(2, 7);
  step.col(0) = Vec2(0, 1);
  // The height of the triangle above shrinks from √3/2; its area bound is δ of it.
  EXPECT_NEAR(objective.largest_step(settings, f.rest, step), std::sqrt(3) / 2 * (1 - delta),
              1e-12);
  EXPECT_TRUE(std::isinf(objective.largest_step(settings, f.rest, Points::Zero(2, 7))));
}

/// The least A′ − δA of all triangles, over A.
double least_room(const MeshPair& mesh, const Points& u, double delta) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles().colwise())
    least = std::min(least, signed_area(u, t) / signed_area(mesh.rest(), t) - delta);
  return least;
}

TEST(StepBound, IsTheFirstOfAllTriangles) {
  constexpr int kPlaces = 100;
  int bounded = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto f = test::square_grid(12);
    const MeshPair mesh(f.triangles, f.rest);
    EnergySettings settings;
    settings.delta = 0.01;
    // Turned as a whole: areas fall along the line before they rise again.
    const double turn = 0.05 * seed;
    Mat2 R;
    R << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
    const Points noise = 0.25 * Points::NullaryExpr(2, f.rest.cols(), [&] { return unit(random); });
    const Points step = R * (f.rest + noise) - f.rest;
    const double t = Objective(mesh, {}).largest_step(settings, f.rest, step);
    const double end = std::min(t, 4.0);
    for (int i = 1; i < kPlaces; ++i)
      ASSERT_GT(least_room(mesh, f.rest + i * end / kPlaces * step, settings.delta), 0) << i;
    if (t > 4) continue;
    ++bounded;
    EXPECT_NEAR(least_room(mesh, f.rest + t * step, settings.delta), 0, 1e-9);
  }
  EXPECT_GT(bounded, 10) << "the claim would be empty";
}

TEST(StepBound, TrianglesInTheWayAreThoseThatBoundAStepBelow) {
  const auto f = test::hexagon();
  const MeshPair mesh(f.triangles, f.rest);
  EnergySettings settings;
  const Objective objective(mesh, {});
  Points step = Points::Zero(2, 7);
  step.col(0) = Vec2(0, 1);
  const double least = objective.largest_step(settings, f.rest, step);
  EXPECT_TRUE(objective.triangles_in_way(settings, f.rest, step, least).empty());
  const std::vector<int> above = objective.triangles_in_way(settings, f.rest, step, 1.001 * least);
  ASSERT_EQ(above.size(), 1U);
  const auto t = f.triangles.col(above[0]);
  EXPECT_GT(f.rest(1, t[0]) + f.rest(1, t[1]) + f.rest(1, t[2]), std::sqrt(3) - 1e-9);
  EXPECT_EQ(objective.triangles_in_way(settings, f.rest, step, 1e9).size(), 3U)
      << "of the three above";
}

}  // namespace
}  // namespace foldless

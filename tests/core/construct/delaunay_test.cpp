// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/delaunay.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <random>
#include <vector>

#include "core/mesh/orientation.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

/// Positive where d is inside of the circle through a, b and c, counter-clockwise.
double in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  Eigen::Matrix3d m;
  m << (a - d).transpose(), (a - d).squaredNorm(), (b - d).transpose(), (b - d).squaredNorm(),
      (c - d).transpose(), (c - d).squaredNorm();
  return m.determinant();
}

TEST(Delaunay, CirclesRoundItsTrianglesHoldNoOtherPoint) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Points points(2, 40);
    for (auto p : points.colwise()) p = test::random_vector(unit, random);
    const auto triangles = delaunay_triangles(points);
    ASSERT_TRUE(triangles);
    std::vector<bool> is_used(40, false);
    for (const Eigen::Vector3i t : triangles->colwise()) {
      EXPECT_GT(orientation(points, t), 0);
      for (const int v : t) is_used[static_cast<std::size_t>(v)] = true;
      for (const auto& p : points.colwise())
        EXPECT_LT(in_circle(points.col(t[0]), points.col(t[1]), points.col(t[2]), p), 1e-12);
    }
    EXPECT_EQ(std::ranges::count(is_used, true), 40);
  }
}

TEST(Delaunay, IsNothingWherePointsCoincide) {
  Points points(2, 5);
  points << 0, 1, 0, 0.2, 0.2,  //
      0, 0, 1, 0.3, 0.3;
  EXPECT_FALSE(delaunay_triangles(points));
  EXPECT_TRUE(delaunay_triangles(points.leftCols(4)));
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/curve_energy.h"

#include <gtest/gtest.h>

#include "tests/support/carried_points.h"

namespace foldless {
namespace {

using namespace test;

TriangulatedDisk disk_of(const Points& rest, Points deformed) {
  const auto disk = CutDisk::over(rest.leftCols(kCorners), rest.rightCols(rest.cols() - kCorners));
  return {disk.value().triangles(), kCorners, rest, std::move(deformed)};
}

/// ½ ∫ ‖J‖² of the map that is linear by triangles.
double dirichlet_energy(const TriangulatedDisk& disk) {
  double sum = 0;
  for (const Eigen::Vector3i& t : disk.triangles) {
    Mat2 rest, deformed;
    for (int i = 0; i < 2; ++i) {
      rest.col(i) = disk.rest.col(t[i + 1]) - disk.rest.col(t[0]);
      deformed.col(i) = disk.deformed.col(t[i + 1]) - disk.deformed.col(t[0]);
    }
    sum += 0.5 * signed_area(disk.rest, t) * (deformed * rest.inverse()).squaredNorm();
  }
  return sum;
}

/// ¼ w ℓ² of the outline, which has one triangle at each edge.
double energy_of_outline(const TriangulatedDisk& disk) {
  double sum = 0;
  for (const Eigen::Vector3i& t : disk.triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (b != (a + 1) % kCorners || a >= kCorners) continue;
      const Vec2 p = disk.rest.col(a) - disk.rest.col(c), q = disk.rest.col(b) - disk.rest.col(c);
      const double cotangent = p.dot(q) / (p.x() * q.y() - p.y() * q.x());
      sum += 0.25 * cotangent * (disk.deformed.col(a) - disk.deformed.col(b)).squaredNorm();
    }
  return sum;
}

TEST(CurveEnergy, IsTheDirichletEnergyWhereCurvesAreStraight) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points rest = dotted_circle(seed, 9);
    Mat2 linear;
    linear << 1.5, 0.4, -0.3, 0.8;
    Points deformed = linear * rest;
    deformed.col(kCorners) += 0.001 * Vec2::Ones();
    const TriangulatedDisk disk = disk_of(rest, deformed);
    const double expected = dirichlet_energy(disk) - energy_of_outline(disk);
    EXPECT_NEAR(CurveEnergy(disk)(curves_of(rest).curves()), expected, 1e-12 * expected);
  }
}

TEST(CurveEnergy, RisesWithEveryTurnOfTwoPoints) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Points points = dotted_circle(seed, 6);
    points.col(kCorners + 1) = points.col(kCorners) + Vec2(0.02, 0.01);
    const TriangulatedDisk disk = disk_of(points, points);
    const CurveEnergy energy(disk);
    CarriedCurves carried = curves_of(points);
    double least = energy(carried.curves());
    for (int turn = 1; turn <= 3; ++turn) {
      twist(carried, points, 1);
      EXPECT_GT(energy(carried.curves()), 1.001 * least);
      least = energy(carried.curves());
    }
  }
}

TEST(CurveEnergy, GoesWithTheSquareOfTheSizeOfTheImageAndNotWithThatOfTheDisk) {
  const Points points = dotted_circle(3, 7);
  const auto curves_at = [&](double size) {
    CarriedCurves carried = curves_of(size * points);
    twist(carried, size * points, 1);
    return carried.curves();
  };
  const TriangulatedDisk disk = disk_of(points, points), large = disk_of(points, 8 * points);
  const TriangulatedDisk both = disk_of(8 * points, 8 * points);
  const double once = CurveEnergy(disk)(curves_at(1));
  EXPECT_NEAR(CurveEnergy(large)(curves_at(8)), 64 * once, 1e-9 * once);
  EXPECT_NEAR(CurveEnergy(both)(curves_at(8)), 64 * once, 1e-9 * once);
}

TEST(CurveEnergy, ACurveIsAsLongAsItsPieces) {
  CarriedCurves::Curve curve{0, 1, Points(2, 2)};
  curve.bends << 3, 3, 4, 0;
  Points ends(2, 2);
  ends << 0, 7, 0, 3;
  EXPECT_DOUBLE_EQ(length_of(curve, ends), 5 + 4 + 5);
}

}  // namespace
}  // namespace foldless

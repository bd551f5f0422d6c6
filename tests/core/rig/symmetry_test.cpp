// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rig/symmetry.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace foldless {
namespace {

/// A tall kite over the y axis: wide below, pointed above.
struct Kite {
  Triangles triangles;
  Points rest;
};
Kite kite() {
  Kite result{Triangles(3, 2), Points(2, 4)};
  result.triangles << 0, 0, 1, 2, 2, 3;
  result.rest << 0, 2, 0, -2, 0, 1, 6, 1;
  return result;
}

double degrees_from_upright(const MirrorAxis& axis) {
  const Vec2 way = axis.to - axis.from;
  return std::atan(-way.x() / way.y()) * 180 / std::numbers::pi;
}

double distance(const MirrorAxis& axis, const Vec2& point) {
  return (mirrored(axis, point) - point).norm() / 2;
}

TEST(MirrorAxis, MirrorsPointsAndWays) {
  const MirrorAxis axis{{3, 0}, {3, 5}};
  EXPECT_EQ(mirrored(axis, {1, 2}), Vec2(5, 2));
  EXPECT_EQ(mirrored_way(axis, {1, 2}), Vec2(-1, 2));
  const MirrorAxis slanted{{1, 0}, {2, 1}};
  EXPECT_LT((mirrored(slanted, {4, 1}) - Vec2(2, 3)).norm(), 1e-12);
  EXPECT_LT((mirrored(slanted, mirrored(slanted, {7, -3})) - Vec2(7, -3)).norm(), 1e-12);
}

TEST(Symmetry, FindsTheAxisOfAKiteExactlyWhereItIsUpright) {
  const Kite k = kite();
  const MirrorAxis axis = symmetry_axis(k.triangles, k.rest);
  EXPECT_LT((axis.from - Vec2(0, 0)).norm(), 1e-12);
  EXPECT_LT((axis.to - Vec2(0, 6)).norm(), 1e-12) << "from one side to the other";
}

TEST(Symmetry, FindsItTurned) {
  for (const double turn : {-70.0, -20.0, 10.0, 37.0, 52.0, 85.0}) {
    Kite k = kite();
    const Eigen::Rotation2D<double> rotation(turn * std::numbers::pi / 180);
    for (Eigen::Index i = 0; i < 4; ++i)
      k.rest.col(i) = rotation * k.rest.col(i).eval() + Vec2(10, -3);
    const MirrorAxis axis = symmetry_axis(k.triangles, k.rest);
    EXPECT_NEAR(degrees_from_upright(axis), turn, 1.5);
    EXPECT_LT(distance(axis, k.rest.col(2)), 0.15) << turn;
    EXPECT_LT(distance(axis, k.rest.col(0)), 0.15) << turn;
  }
}

TEST(Symmetry, OfManyAxesTheUprightOneIsTaken) {
  Kite square = kite();
  square.rest << 0, 1, 1, 0, 0, 0, 1, 1;
  const MirrorAxis axis = symmetry_axis(square.triangles, square.rest);
  EXPECT_EQ(axis.from, Vec2(0.5, 0));
  EXPECT_EQ(axis.to, Vec2(0.5, 1));
}

TEST(Symmetry, ThroughTheMiddleInAnyDirection) {
  Kite square = kite();
  square.rest << 0, 2, 2, 0, 0, 0, 1, 1;
  const MirrorAxis axis = axis_through_middle(square.triangles, square.rest, {5, 0});
  EXPECT_EQ(axis, (MirrorAxis{{0, 0.5}, {2, 0.5}}));
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/map_interpolation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "tests/support/curled_bar.h"

namespace foldless {
namespace {

constexpr double kPi = std::numbers::pi;

MeshPair curled(double angle) {
  const Shape bar = test::flat_bar();
  return {bar.triangles, bar.rest, test::curled(bar.rest, angle)};
}

TEST(MapInterpolation, EndsAtTheMapsThatItLiesBetween) {
  const MeshPair mesh = curled(2);
  const Points to = test::curled(mesh.rest(), -1);
  MapInterpolation between(mesh, test::left_end_held(mesh.rest()), to);
  ASSERT_TRUE(between.is_solvable());
  EXPECT_LT((between.at(0) - mesh.deformed()).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(between.at(1), to) << "bit for bit";
}

TEST(MapInterpolation, HeldVerticesStayWhereTheyAreInBoth) {
  const MeshPair mesh = curled(2);
  MapInterpolation between(mesh, test::left_end_held(mesh.rest()), mesh.rest());
  for (const double t : {0.1, 0.5, 0.9}) {
    const Points points = between.at(t);
    for (const int v : test::left_end_held(mesh.rest()).vertices)
      EXPECT_EQ(points.col(v), mesh.rest().col(v)) << t;
  }
}

TEST(MapInterpolation, HalfOfACurlIsACurlOfHalfTheAngle) {
  for (const double angle : {1.0, 1.5 * kPi, 2.5 * kPi, -3 * kPi}) {
    SCOPED_TRACE(angle);
    const MeshPair mesh = curled(0);
    MapInterpolation between(mesh, test::left_end_held(mesh.rest()),
                             test::curled(mesh.rest(), angle));
    const Points half = between.at(0.5);
    const Points expected = test::curled(mesh.rest(), angle / 2);
    EXPECT_LT((half - expected).colwise().norm().maxCoeff(), 0.02) << "of a bar of length 4";
    EXPECT_TRUE(is_injective(mesh.triangles(), half));
  }
}

TEST(MapInterpolation, AStretchIsAPlainMean) {
  const MeshPair mesh = curled(0);
  Points to = mesh.rest();
  to.row(0) *= 3;
  MapInterpolation between(mesh, test::left_end_held(mesh.rest()), to);
  EXPECT_LT((between.at(0.25) - (0.75 * mesh.rest() + 0.25 * to)).cwiseAbs().maxCoeff(), 1e-10);
}

}  // namespace
}  // namespace foldless

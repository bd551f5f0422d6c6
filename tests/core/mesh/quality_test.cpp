// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/quality.h"

#include <gtest/gtest.h>

#include "tests/support/meshes.h"

namespace foldless {
namespace {

TEST(Quality, OfTheIdentityIsOne) {
  const auto f = test::square_grid(3);
  const Quality q = quality_of(f.triangles, f.rest, f.rest);
  EXPECT_DOUBLE_EQ(q.min_area_ratio, 1);
  EXPECT_DOUBLE_EQ(q.max_conformal_distortion, 1);
  EXPECT_DOUBLE_EQ(q.mean_conformal_distortion, 1);
}

TEST(Quality, MeasuresAStretchOfOneTriangle) {
  const auto f = test::unit_square();
  Points deformed = f.rest;
  deformed.col(1) = Vec2(1, -1);  // triangle (0, 1, 2) only: twice the area
  const Quality q = quality_of(f.triangles, f.rest, deformed);
  EXPECT_DOUBLE_EQ(q.min_area_ratio, 1);
  Mat2 J;
  J << 1, 0, -1, 2;
  const Vec2 s = signed_singular_values(J);
  EXPECT_NEAR(q.max_conformal_distortion, s[0] / s[1], 1e-12);
  EXPECT_NEAR(q.mean_conformal_distortion, (s[0] / s[1] + 1) / 2, 1e-12);
}

TEST(Quality, FoldedTrianglesShowInTheAreaRatioAlone) {
  const test::Fixture f = test::unit_square();
  Points deformed = f.rest;
  deformed.col(3) = Vec2(0.75, 0.25);
  const Quality q = quality_of(f.triangles, f.rest, deformed);
  EXPECT_LT(q.min_area_ratio, 0);
  EXPECT_EQ(q.max_conformal_distortion, 1);
  EXPECT_EQ(q.mean_conformal_distortion, 1);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/threads/team.h"
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

TEST(Quality, OfManyTrianglesIsThatOfEachWithAnyNumberOfThreads) {
  const test::Fixture f = test::square_grid(80);
  Points deformed = f.rest;
  for (auto p : deformed.colwise()) p.x() += 0.1 * p.y() * p.y() / 80;
  Quality expected{std::numeric_limits<double>::infinity(), 1, 0};
  for (const auto& t : f.triangles.colwise()) {
    const double conformal = conformal_distortion(f.rest, deformed, t);
    expected.min_area_ratio =
        std::min(expected.min_area_ratio, signed_area(deformed, t) / signed_area(f.rest, t));
    expected.max_conformal_distortion = std::max(expected.max_conformal_distortion, conformal);
    expected.mean_conformal_distortion += conformal / static_cast<double>(f.triangles.cols());
  }
  const Quality alone = quality_of(f.triangles, f.rest, deformed);
  EXPECT_EQ(alone.min_area_ratio, expected.min_area_ratio);
  EXPECT_EQ(alone.max_conformal_distortion, expected.max_conformal_distortion);
  EXPECT_NEAR(alone.mean_conformal_distortion, expected.mean_conformal_distortion, 1e-12);
  Team team(3);
  const WithTeam with(&team);
  EXPECT_EQ(quality_of(f.triangles, f.rest, deformed).mean_conformal_distortion,
            alone.mean_conformal_distortion);
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

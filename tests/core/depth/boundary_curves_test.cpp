// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/boundary_curves.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/depth/overlaps.h"
#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

BoundaryCurves curves_of(const Fixture& f) {
  return {f.triangles, static_cast<int>(f.rest.cols())};
}

bool say_that_nothing_overlaps(const Fixture& f, const Points& points) {
  const BoundaryCurves curves = curves_of(f);
  return curves.have_open_corners(points) && !curves.meet(points) && !curves.are_nested(points);
}

/// An annulus with radii 1 and 2; `turns` < 1 leaves a gap.
Points wound(const Fixture& strip, double turns, double growth) {
  return along(strip.rest, [&](double x) {
    const double angle = 2 * std::numbers::pi * turns * x;
    return Vec2((2 + growth * x) * Vec2(std::cos(-angle), std::sin(-angle)));
  });
}

TEST(BoundaryCurves, OfMeshesThatDoNotOverlapSaySo) {
  for (const Fixture& f : {unit_square(), square_grid(7), hexagon(), open_fan(200), open_fan(350)})
    EXPECT_TRUE(say_that_nothing_overlaps(f, f.rest));
  const Fixture strip = ribbon(40, 0, 1, 0.3);
  EXPECT_TRUE(say_that_nothing_overlaps(strip, wound(strip, 0.9, 0)));
  EXPECT_TRUE(say_that_nothing_overlaps(strip, wound(strip, 1.7, 1.5))) << "a spiral";
}

TEST(BoundaryCurves, MeetWhereARibbonCrossesItself) {
  const Fixture strip = ribbon(40, -1.6, 1.6, 0.15);
  EXPECT_TRUE(curves_of(strip).meet(along(strip.rest, loop)));
  const Fixture coil = ribbon(40, 0, 1, 0.3);
  EXPECT_TRUE(curves_of(coil).meet(wound(coil, 1.7, 0.2)));
}

TEST(BoundaryCurves, HaveNoOpenCornersWhereAFanGoesRoundMoreThanOnce) {
  for (const double degrees : {370.0, 450.0, 600.0}) {
    const Fixture f = open_fan(degrees, 12);
    EXPECT_FALSE(curves_of(f).have_open_corners(f.rest)) << degrees;
  }
}

TEST(BoundaryCurves, AreNestedWhereAComponentLiesOnAnother) {
  Fixture small = square_grid(3), large = square_grid(4);
  small.rest *= 0.2;
  small.rest.array() += 1.1;
  EXPECT_TRUE(curves_of(both(small, large)).are_nested(both(small, large).rest));
  EXPECT_TRUE(curves_of(both(large, small)).are_nested(both(large, small).rest));
  small.rest.array() += 10;
  EXPECT_FALSE(curves_of(both(small, large)).are_nested(both(small, large).rest));
}

TEST(BoundaryCurves, AreNotNestedWhereAComponentLiesInAHole) {
  const int n = 4;
  Fixture ring = square_grid(n);
  const Eigen::Index cell = 2 * ((n - 1) + 1);  // the cell in the middle of 3 × 3
  Triangles without(3, ring.triangles.cols() - 2);
  without << ring.triangles.leftCols(cell),
      ring.triangles.rightCols(ring.triangles.cols() - cell - 2);
  ring.triangles = without;
  Fixture disk = square_grid(3);
  disk.rest *= 0.2;
  disk.rest.array() += 1.3;
  const Fixture f = both(ring, disk);
  ASSERT_TRUE(overlapping_triangles(f.triangles, f.rest, CommonCorners::may_overlap).empty());
  EXPECT_TRUE(say_that_nothing_overlaps(f, f.rest));
}

TEST(BoundaryCurves, OfNothingOverlapNothing) {
  EXPECT_TRUE(say_that_nothing_overlaps({Triangles(3, 0), Points(2, 0)}, Points(2, 0)));
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/overlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

/// Triangles of random places and sizes, each with corners of its own.
Fixture confetti(int count, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Fixture f;
  f.rest.resize(2, 3 * count);
  f.triangles.resize(3, count);
  for (int t = 0; t < count; ++t) {
    const Vec2 centre(unit(random), unit(random));
    const double angle = 6 * unit(random), radius = size * (0.2 + unit(random));
    for (int k = 0; k < 3; ++k)
      f.rest.col(3 * t + k) =
          centre + radius * Vec2(std::cos(angle + 2.1 * k), std::sin(angle + 2.1 * k));
    f.triangles.col(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  return f;
}

bool cover_a_common_point(const Fixture& f, int a, int b) {
  const auto corner = [&](int t, int k) { return Vec2(f.rest.col(f.triangles(k, t))); };
  const auto is_inside = [&](int t, const Vec2& p) {
    for (int k = 0; k < 3; ++k)
      if (signed_area(corner(t, k), corner(t, (k + 1) % 3), p) < 0) return false;
    return true;
  };
  for (int i = 0; i < 3; ++i) {
    if (is_inside(a, corner(b, i)) || is_inside(b, corner(a, i))) return true;
    for (int j = 0; j < 3; ++j) {
      const Vec2 p = corner(a, i), q = corner(a, (i + 1) % 3);
      const Vec2 r = corner(b, j), s = corner(b, (j + 1) % 3);
      if (signed_area(p, q, r) * signed_area(p, q, s) < 0 &&
          signed_area(r, s, p) * signed_area(r, s, q) < 0)
        return true;
    }
  }
  return false;
}

TEST(Overlaps, AreThosePairsThatCoverACommonPointOnceAndSorted) {
  for (const double size : {0.02, 0.1, 0.7}) {
    const Fixture f = confetti(150, size, 5);
    std::vector<Overlap> expected;
    for (int a = 0; a < 150; ++a)
      for (int b = a + 1; b < 150; ++b)
        if (cover_a_common_point(f, a, b)) expected.push_back({a, b});
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(overlapping_triangles(f.triangles, f.rest, CommonCorners::apart), expected) << size;
  }
}

TEST(Overlaps, OfARibbonThatCrossesItselfAreAllFound) {
  Fixture f = ribbon(60, -1.6, 1.71, 0.2);  // no two edges coincide
  f.rest = along(f.rest, loop);
  std::vector<Overlap> expected;
  for (int a = 0; a < f.triangles.cols(); ++a)
    for (int b = a + 5; b < f.triangles.cols(); ++b)
      if (std::abs(a / 4 - b / 4) > 1 && cover_a_common_point(f, a, b)) expected.push_back({a, b});
  ASSERT_GT(expected.size(), 50U);
  EXPECT_EQ(overlapping_triangles(f.triangles, f.rest, CommonCorners::apart), expected);
}

TEST(Overlaps, AreFoundAmongTrianglesOfVeryDifferentSizes) {
  Fixture f = confetti(200, 0.01, 9);
  f.rest.col(0) = Vec2(-100, -100);
  f.rest.col(1) = Vec2(100, -100);
  f.rest.col(2) = Vec2(0, 200);
  const auto overlaps = overlapping_triangles(f.triangles, f.rest, CommonCorners::apart);
  EXPECT_EQ(std::ranges::count(overlaps, 0, &Overlap::a), 199);
}

TEST(Overlaps, AreNoneOfNeighboursThatOnlyTouch) {
  for (const Fixture& f : {unit_square(), square_grid(12), hexagon(), open_fan(359)})
    EXPECT_TRUE(overlapping_triangles(f.triangles, f.rest, CommonCorners::may_overlap).empty());
}

TEST(Overlaps, OfAMeshOnItselfAreEachTriangleOnItsTwinAndContacts) {
  const Fixture f = both(square_grid(3), square_grid(3));
  int overlapping = 0, touching = 0;
  for (const Overlap& o : overlapping_triangles(f.triangles, f.rest, CommonCorners::may_overlap)) {
    EXPECT_LT(o.a, 8);
    EXPECT_GE(o.b, 8);
    EXPECT_EQ(o.is_contact, o.a + 8 != o.b);
    ++(o.is_contact ? touching : overlapping);
  }
  EXPECT_EQ(overlapping, 8);
  EXPECT_GE(touching, 2 * 8) << "over each of the eight edges inside, both ways";
}

TEST(Overlaps, OfTrianglesWithACommonCornerCountOnRequest) {
  const Fixture f = open_fan(420, 7);  // the last lies on the first
  EXPECT_TRUE(overlapping_triangles(f.triangles, f.rest, CommonCorners::apart).empty());
  EXPECT_EQ(overlapping_triangles(f.triangles, f.rest, CommonCorners::may_overlap),
            (std::vector<Overlap>{{0, 6}}));
}

TEST(Overlaps, OfNothingAreNone) {
  EXPECT_TRUE(
      overlapping_triangles(Triangles(3, 0), Points(2, 0), CommonCorners::may_overlap).empty());
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/outline/loops.h"
#include "tests/support/alpha_maps.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::drawn_map;
using test::error_of;

constexpr RegionOptions kExact{.margin = 0, .simplify = 0, .speck_area = 0};

double total_area(const Regions& regions) {
  double sum = 0;
  for (const Outline& outline : regions.outlines) {
    sum += area_of(outline.boundary);
    for (const Loop& hole : outline.holes) sum += area_of(hole);
  }
  return sum;
}

bool covers(const Regions& regions, const Vec2& point) {
  int inside = 0;
  for (const Outline& outline : regions.outlines) {
    inside += encloses(outline.boundary, point) ? 1 : 0;
    for (const Loop& hole : outline.holes) inside -= encloses(hole, point) ? 1 : 0;
  }
  return inside > 0;
}

TEST(Regions, FindPartsHolesAndPartsInHoles) {
  const AlphaMap map = drawn_map({
      "              ",
      " #######  ### ",
      " #     #  ### ",
      " # ### #      ",
      " # ### #      ",
      " #     #      ",
      " #######      ",
      "              ",
  });
  const Regions regions = regions_of(map, kExact);
  ASSERT_EQ(regions.outlines.size(), 3U);
  std::size_t holes = 0;
  for (const Outline& outline : regions.outlines) {
    holes += outline.holes.size();
    EXPECT_EQ(outline.holes.size(), area_of(outline.boundary) > 20 ? 1U : 0U);
  }
  EXPECT_EQ(holes, 1U);
}

TEST(Regions, AHoleBelongsToTheSmallestPartRoundIt) {
  // Rings in rings: whichever hole is looked at first, larger and smaller parts lie round it.
  const AlphaMap map = test::alpha_map(81, 81, [](double x, double y) {
    const int ring = static_cast<int>(std::max(std::abs(x - 40.5), std::abs(y - 40.5)) / 4);
    return ring % 2 == 1 && ring < 10;
  });
  const Regions regions = regions_of(map, kExact);
  ASSERT_EQ(regions.outlines.size(), 5U);
  for (const Outline& outline : regions.outlines) {
    ASSERT_EQ(outline.holes.size(), 1U);
    const double width = std::sqrt(area_of(outline.boundary)),
                 hole = std::sqrt(-area_of(outline.holes[0]));
    EXPECT_LT(width - hole, 12) << "a wall of 4 pixels on each side, and no part between";
  }
}

TEST(Regions, FollowSoftEdgesMoreCloselyThanAPixel) {
  const double radius = 20.3;
  const AlphaMap map = test::alpha_map(
      50, 50, [&](double x, double y) { return 0.5 + radius - std::hypot(x - 25.2, y - 24.6); });
  const Regions regions =
      regions_of(map, {.threshold = 0.5, .margin = 0, .simplify = 0, .speck_area = 0});
  for (const Vec2& p : regions.outlines.at(0).boundary)
    EXPECT_NEAR((p - Vec2(25.2, 50 - 24.6)).norm(), radius, 0.1);
}

TEST(Regions, KeepTheMarginRoundTheFigure) {
  AlphaMap map = test::alpha_map(60, 60, [](double, double) { return 0; });
  map.values[30 * 60 + 30] = 255;
  const Regions regions = regions_of(map, {.margin = 8, .simplify = 0});
  for (const Vec2& p : regions.outlines.at(0).boundary)
    EXPECT_NEAR((p - Vec2(30.5, 29.5)).norm(), 8.5, 0.1);
}

TEST(Regions, EndWithThePicture) {
  for (const double margin : {0.0, 3.0}) {
    const Regions whole = regions_of(test::opaque_map(17, 9), {.margin = margin});
    ASSERT_EQ(whole.outlines.size(), 1U);
    EXPECT_EQ(whole.outlines[0].boundary.size(), 4U);
    EXPECT_NEAR(total_area(whole), 17 * 9, 1e-9);
  }
}

TEST(Regions, SpecksAreLeftOutAndCounted) {
  AlphaMap map = test::alpha_map(80, 40, [](double x, double y) { return x < 30 && y < 30; });
  for (const std::size_t pixel : {10U * 80U + 60U, 30U * 80U + 70U, 30U * 80U + 71U})
    map.values[pixel] = 255;
  map.values[5U * 80U + 5U] = 0;
  const Regions regions = regions_of(map, {.margin = 0});
  EXPECT_EQ(regions.outlines.size(), 1U);
  EXPECT_EQ(regions.specks, 2);
  EXPECT_EQ(regions.filled_holes, 1);
  EXPECT_EQ(regions_of(map, kExact).outlines.size(), 3U);
}

TEST(Regions, CoverEveryPixelOfTheFigureAtAnyCornerContact) {
  const unsigned seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 60; ++trial) {
    const AlphaMap map =
        test::with_border(test::random_map(random, 3 + trial % 30, 2 + trial % 23), 4);
    const RegionOptions options{.margin = 1.5, .simplify = 1, .speck_area = 0};
    if (std::ranges::none_of(map.values, [](int a) { return a >= 26; })) continue;
    const Regions regions = regions_of(map, options);
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        ASSERT_TRUE(map.at(x, y) < 26 || covers(regions, {x + 0.5, map.height - y - 0.5}))
            << "trial " << trial << ", pixel " << x << ' ' << y;
  }
}

TEST(Regions, OfALargePictureAreThoseOfASmallOneEnlarged) {
  const Regions large = regions_of(test::ring_map(3000), {});
  const Regions small = regions_of(test::ring_map(300), {.margin = 0.2, .simplify = 0.1});
  ASSERT_EQ(large.outlines.size(), small.outlines.size());
  EXPECT_NEAR(total_area(large) / 100, total_area(small), 0.01 * total_area(small));
}

TEST(Regions, RefuseInOneSentence) {
  const AlphaMap clear = test::alpha_map(9, 9, [](double, double) { return 0.05; });
  EXPECT_NE(error_of([&] { regions_of(clear, {}); }).find("transparent everywhere"),
            std::string::npos);
  EXPECT_EQ(error_of([&] { regions_of(clear, {.threshold = 0.04}); }), "");
  EXPECT_NE(error_of([&] { regions_of({}, {}); }), "");
  const AlphaMap full = test::opaque_map(4, 4);
  for (const double bad : {-1.0, 1e9, std::nan("")}) {
    EXPECT_NE(error_of([&] { regions_of(full, {.threshold = bad}); }), "");
    EXPECT_NE(error_of([&] { regions_of(full, {.margin = bad}); }), "");
    EXPECT_NE(error_of([&] { regions_of(full, {.simplify = bad}); }), "");
  }
}

TEST(Regions, RefuseAPictureOfTooManyParts) {
  const AlphaMap dots = test::alpha_map(
      200, 200, [](double x, double y) { return std::fmod(x, 5) < 1 && std::fmod(y, 5) < 1; });
  EXPECT_NE(error_of([&] { regions_of(dots, kExact); }).find("1600 parts and holes"),
            std::string::npos);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ear_clipping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

using Polygon = std::vector<Vec2>;

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// n − 2 triangles, all of the polygon's sense of rotation, whose areas add up to the polygon's:
/// then they cover it once.
void expect_triangulated(const Polygon& polygon) {
  const auto pieces = clip_ears(polygon);
  ASSERT_TRUE(pieces);
  EXPECT_EQ(pieces->size(), polygon.size() - 2);
  const double area = area_of(polygon);
  double sum = 0;
  for (const auto& piece : *pieces) {
    Vec2 p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = polygon[static_cast<std::size_t>(piece[k])];
    EXPECT_EQ(orientation(p[0], p[1], p[2]), area > 0 ? 1 : -1);
    sum += signed_area(p[0], p[1], p[2]);
  }
  EXPECT_NEAR(sum, area, 1e-12 * std::abs(area));
}

void expect_triangulated_both_ways(Polygon polygon) {
  expect_triangulated(polygon);
  std::ranges::reverse(polygon);
  expect_triangulated(polygon);
}

/// Corners at random distances round the origin: simple, seldom convex.
Polygon random_star(int corners, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.05, 1);
  Polygon polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    polygon.push_back(radius(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

TEST(EarClipping, CutsAConvexQuadAlongTheShorterDiagonal) {
  const auto pieces = clip_ears(Polygon{{0, 0}, {3, 0}, {4, 1}, {1, 1}});
  ASSERT_TRUE(pieces);
  for (const auto& piece : *pieces) {
    EXPECT_TRUE(std::ranges::count(piece, 1) == 1 && std::ranges::count(piece, 3) == 1);
  }
}

TEST(EarClipping, CutsANonConvexQuadAtItsReflexCorner) {
  for (int turn = 0; turn < 4; ++turn) {
    Polygon arrow{{0, 0}, {4, 0}, {1, 1}, {0, 4}};
    std::rotate(arrow.begin(), arrow.begin() + turn, arrow.end());
    expect_triangulated_both_ways(arrow);
  }
}

TEST(EarClipping, MakesNoFlatTriangleOfCornersOnALine) {
  expect_triangulated_both_ways({{0, 0}, {1, 0}, {2, 0}, {0, 2}});
  expect_triangulated_both_ways({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 2}, {1, 1}});
  expect_triangulated_both_ways({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
}

TEST(EarClipping, CutsACombOfManyReflexCorners) {
  Polygon comb{{0, 3}, {0, 0}};
  for (int tooth = 0; tooth < 40; ++tooth) {
    comb.emplace_back(tooth + 0.5, 2);
    comb.emplace_back(tooth + 1, 0);
  }
  comb.emplace_back(40, 3);
  expect_triangulated_both_ways(comb);
}

TEST(EarClipping, CutsRandomStars) {
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 400; ++i)
    expect_triangulated_both_ways(random_star(4 + static_cast<int>(random() % 40), random));
}

TEST(EarClipping, RefusesPolygonsThatAreNotSimple) {
  EXPECT_FALSE(clip_ears(Polygon{{0, 0}, {1, 1}, {1, 0}, {0, 1}})) << "crosses itself";
  EXPECT_FALSE(clip_ears(Polygon{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})) << "touches itself";
  EXPECT_FALSE(clip_ears(Polygon{{0, 0}, {2, 0}, {1, 0}, {1, 3}})) << "turns back";
  EXPECT_FALSE(clip_ears(Polygon{{0, 0}, {1, 0}, {2, 0}, {3, 0}})) << "is flat";
  EXPECT_FALSE(clip_ears(Polygon{{0, 0}, {1, 0}, {1, 0}, {0, 1}})) << "visits a point twice";
  EXPECT_FALSE(clip_ears(Polygon{{0, 0}, {1, 0}})) << "has two corners";
  EXPECT_FALSE(clip_ears(Polygon(kMaxPolygonCorners + 1, Vec2(0, 0)))) << "is too long";
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/plane_map.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"

namespace foldless {
namespace {

/// A fine grid over [-1, 1]².
Shape samples() {
  Shape shape = grid({.columns = 400, .rows = 400, .width = 2, .height = 2});
  shape.rest.array() -= 1;
  return shape;
}

void expect_orientation_is_kept(const PlaneMap& map) {
  const Shape fine = samples();
  Points images = fine.rest;
  for (auto p : images.colwise()) p = map(p);
  EXPECT_TRUE(is_injective(fine.triangles, images));
}

TEST(PlaneMap, EveryKindOfMoveKeepsOrientation) {
  expect_orientation_is_kept({{Twist{{0.1, 0.2}, 0.8, 0.3, std::numbers::pi}}});
  expect_orientation_is_kept({{Shear{{0.1, 0.2}, {0.5, 0.3}, 0.6}}});
  expect_orientation_is_kept({{Drag{{0.1, 0.2}, 0.5, {-0.21, 0.21}}}});
}

TEST(PlaneMap, ComposesItsMovesInOrder) {
  const Twist turn{{0, 0}, 2, 1, std::numbers::pi / 2};
  const Drag drag{{0, 0.5}, 0.5, {0.1, 0}};
  const PlaneMap map{{turn, drag}};
  EXPECT_LT((map({0.5, 0}) - Vec2(0.1, 0.5)).norm(), 1e-12);
}

TEST(PlaneMap, ALongDragIsInjectiveAndArrives) {
  PlaneMap map;
  add_long_drag(map, {{-0.6, -0.5}, 0.3, {1.1, 0.9}});
  EXPECT_GT(map.moves.size(), 4u);
  EXPECT_LT((map({-0.6, -0.5}) - Vec2(0.5, 0.4)).norm(), 1e-12);
  expect_orientation_is_kept(map);
}

TEST(PlaneMap, PointsOutOfReachComeBackBitForBit) {
  const Vec2 p(0.123456789, 0.7);
  const PlaneMap map{{Twist{{-0.5, 0}, 0.6, 0.2, 3}, Drag{{-0.5, 0}, 0.6, {0.3, 0}},
                      Shear{{0, -0.5}, {0.3, 0}, 0.9}}};
  EXPECT_EQ(map(p), p);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/paint_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/depth/overlap_pieces.h"
#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<Overlap> overlaps_of(const Fixture& f, const Points& points) {
  return overlapping_triangles(f.triangles, points, CommonCorners::may_overlap);
}

/// x of the middle of a triangle at rest.
double x_of(const Fixture& f, int t) {
  return (f.rest(0, f.triangles(0, t)) + f.rest(0, f.triangles(1, t)) +
          f.rest(0, f.triangles(2, t))) /
         3;
}

PaintKeys no_keys(const Fixture& f) {
  return {Eigen::VectorXd::Zero(f.triangles.cols()), Eigen::VectorXd::Zero(f.triangles.cols())};
}

void expect_separate_layers(const std::vector<Overlap>& overlaps, const std::vector<int>& layers) {
  ASSERT_FALSE(overlaps.empty());
  for (const Overlap& o : overlaps)
    if (!o.is_contact) {
      EXPECT_NE(layers[at(o.a)], layers[at(o.b)]);
    }
}

TEST(PaintLayers, ACrossingIsOnePieceWhoseSheetsAreToldApart) {
  const Fixture f = ribbon(40, -1.6, 1.6, 0.15);
  const auto overlaps = overlaps_of(f, along(f.rest, loop));
  const OverlapPieces pieces = overlap_pieces(f.triangles, overlaps);
  ASSERT_EQ(pieces.count, 1);
  EXPECT_FALSE(pieces.is_one_sided[0]);
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const bool a_is_left = x_of(f, overlaps[i].a) < 0;
    EXPECT_NE(a_is_left, x_of(f, overlaps[i].b) < 0);
    EXPECT_EQ(a_is_left == pieces.is_swapped[i],
              (x_of(f, overlaps[0].a) < 0) == pieces.is_swapped[0]);
  }
}

TEST(PaintLayers, TwoCrossingsAreTwoPieces) {
  const Fixture f =
      both(both(ribbon(30, 0, 10, 0.4), ribbon(8, -1, 1, 0.3)), ribbon(8, -1, 1, 0.3));
  Points points = f.rest;
  for (const auto& [first, x] : {std::pair{93, 2.0}, std::pair{120, 7.0}})
    for (int v = first; v < first + 27; ++v) points.col(v) = Vec2(x - f.rest(1, v), f.rest(0, v));
  EXPECT_EQ(overlap_pieces(f.triangles, overlaps_of(f, points)).count, 2);
}

TEST(PaintLayers, ACrossingIsOrderedAsOneThoughItsKeysAreNot) {
  const Fixture f = ribbon(40, -1.6, 1.6, 0.15);
  const auto overlaps = overlaps_of(f, along(f.rest, loop));
  PaintKeys keys = no_keys(f);
  // Every third triangle of the sheet in front says that it is behind.
  for (int t = 0; t < f.triangles.cols(); ++t)
    keys.depth[t] = x_of(f, t) < 0 ? 0 : t % 3 == 0 ? -1 : 2;
  const std::vector<int> layers = paint_layers(f.triangles, overlaps, keys);
  ASSERT_FALSE(overlaps.empty());
  for (const Overlap& o : overlaps) {
    const int left = x_of(f, o.a) < 0 ? o.a : o.b, right = left == o.a ? o.b : o.a;
    EXPECT_EQ(layers[at(left)], 0);
    EXPECT_EQ(layers[at(right)], 1);
  }
}

TEST(PaintLayers, EqualDepthsLeaveItToTheOrder) {
  const Fixture f = ribbon(40, -1.6, 1.6, 0.15);
  const auto overlaps = overlaps_of(f, along(f.rest, loop));
  for (const double sign : {1.0, -1.0}) {
    PaintKeys keys = no_keys(f);
    for (int t = 0; t < f.triangles.cols(); ++t) {
      keys.depth[t] = 7 - sign * 1e-12 * x_of(f, t) + (x_of(f, t) > 1.5 ? 1 : 0);
      keys.order[t] = sign * x_of(f, t);
    }
    const std::vector<int> layers = paint_layers(f.triangles, overlaps, keys);
    for (const Overlap& o : overlaps)
      EXPECT_EQ(layers[at(o.a)] > layers[at(o.b)], sign * x_of(f, o.a) > sign * x_of(f, o.b));
  }
}

TEST(PaintLayers, ACoilOfManyTurnsLiesTurnOnTurn) {
  const Fixture f = ribbon(200, 0, 5, 0.4);
  const auto overlaps =
      overlaps_of(f, along(f.rest, [](double x) {
                    const double angle = -2 * std::numbers::pi * x;
                    return Vec2((2 + 0.05 * x) * Vec2(std::cos(angle), std::sin(angle)));
                  }));
  PaintKeys keys = no_keys(f);
  for (int t = 0; t < f.triangles.cols(); ++t) keys.depth[t] = x_of(f, t);
  const std::vector<int> layers = paint_layers(f.triangles, overlaps, keys);
  ASSERT_FALSE(overlaps.empty());
  for (const Overlap& o : overlaps)
    EXPECT_EQ(layers[at(o.a)] > layers[at(o.b)], x_of(f, o.a) > x_of(f, o.b));
  EXPECT_LE(*std::ranges::max_element(layers), 5) << "not more layers than turns";
}

TEST(PaintLayers, ARingWoundTwiceOnItselfHasOneSideAndSeparateLayersStill) {
  const int n = 48;
  Fixture f = ribbon(n, 0, 1, 0.2);
  // The last three vertices are the first three again.
  for (int& v : f.triangles.reshaped()) v %= 3 * n;
  Points points(2, 3 * n);
  for (int v = 0; v < 3 * n; ++v) {
    const double angle = -4 * std::numbers::pi * f.rest(0, v);
    points.col(v) = (1 + f.rest(1, v)) * Vec2(std::cos(angle), std::sin(angle));
  }
  const auto overlaps = overlaps_of(f, points);
  const OverlapPieces pieces = overlap_pieces(f.triangles, overlaps);
  ASSERT_EQ(pieces.count, 1);
  EXPECT_TRUE(pieces.is_one_sided[0]);
  PaintKeys keys = no_keys(f);
  for (int t = 0; t < f.triangles.cols(); ++t) keys.order[t] = t;
  expect_separate_layers(overlaps, paint_layers(f.triangles, overlaps, keys));
}

TEST(PaintLayers, PiecesInACircleAreInSeparateLayersStill) {
  // Three sheets of two triangles; 0, 2 and 4 lie over each other. The second triangle of each
  // sheet puts the whole of it in front of the next sheet. 6 waits for 0 though it is farther back.
  Fixture f;
  f.triangles.resize(3, 8);
  for (int sheet = 0; sheet < 4; ++sheet) {
    const int v = 4 * sheet;
    f.triangles.col(2 * sheet) << v, v + 1, v + 2;
    f.triangles.col(2 * sheet + 1) << v + 2, v + 1, v + 3;
  }
  const std::vector<Overlap> overlaps{{0, 2}, {0, 4}, {0, 5}, {0, 6},
                                      {0, 7}, {1, 2}, {2, 4}, {3, 4}};
  PaintKeys keys = no_keys(f);
  for (const int t : {1, 3, 5}) keys.depth[t] = 1;
  keys.depth[6] = -1;
  keys.depth[7] = 3;
  expect_separate_layers(overlaps, paint_layers(f.triangles, overlaps, keys));
}

TEST(PaintLayers, WithoutOverlapsThereIsOne) {
  const Fixture f = square_grid(4);
  EXPECT_EQ(paint_layers(f.triangles, {}, no_keys(f)), std::vector<int>(18, 0));
}

}  // namespace
}  // namespace foldless::test

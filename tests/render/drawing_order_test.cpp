// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/drawing_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/support/meshes.h"

namespace foldless::test {
namespace {

/// A strip of n cells along x, its triangles in random order.
Fixture shuffled_strip(int n, unsigned seed) {
  Fixture f;
  f.rest.resize(2, 2 * (n + 1));
  for (int i = 0; i <= n; ++i) {
    f.rest.col(2 * i) = Vec2(i, 0);
    f.rest.col(2 * i + 1) = Vec2(i, 1);
  }
  std::vector<int> places(static_cast<std::size_t>(2 * n));
  std::iota(places.begin(), places.end(), 0);
  std::mt19937 random(seed);
  std::ranges::shuffle(places, random);
  f.triangles.resize(3, 2 * n);
  for (int i = 0; i < n; ++i) {
    f.triangles.col(places[static_cast<std::size_t>(2 * i)]) << 2 * i, 2 * i + 2, 2 * i + 1;
    f.triangles.col(places[static_cast<std::size_t>(2 * i + 1)]) << 2 * i + 1, 2 * i + 2, 2 * i + 3;
  }
  return f;
}

TEST(DrawingOrder, IsAPermutation) {
  const Fixture f = square_grid(6);
  std::vector<int> order = drawing_order(f.triangles, f.rest);
  std::ranges::sort(order);
  for (std::size_t t = 0; t < order.size(); ++t) EXPECT_EQ(order[t], static_cast<int>(t));
}

TEST(DrawingOrder, OneEndOfAStripLiesOnTheOtherAsAWhole) {
  const Fixture f = shuffled_strip(40, 7);
  const std::vector<int> order = drawing_order(f.triangles, f.rest);
  double before = -1;
  for (const int t : order) {
    const double x = f.rest(0, f.triangles(0, t));
    EXPECT_GE(x, before - 1) << "from one end to the other, whatever the numbers of the triangles";
    before = std::max(before, x);
  }
}

TEST(DrawingOrder, StacksComponents) {
  Fixture f = unit_square();
  Fixture two;
  two.rest.resize(2, 8);
  two.rest << f.rest, f.rest;
  two.triangles.resize(3, 4);
  two.triangles.col(0) = f.triangles.col(0).array() + 4;
  two.triangles.col(1) = f.triangles.col(0);
  two.triangles.col(2) = f.triangles.col(1).array() + 4;
  two.triangles.col(3) = f.triangles.col(1);
  const std::vector<int> order = drawing_order(two.triangles, two.rest);
  EXPECT_EQ(order[0] % 2, order[1] % 2) << "both triangles of one square";
  EXPECT_EQ(order[2] % 2, order[3] % 2) << "then both of the other";
}

TEST(DrawingOrder, OfNothingIsNothing) {
  EXPECT_TRUE(drawing_order(Triangles(3, 0), Points(2, 0)).empty());
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/distance_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace foldless {
namespace {

double nearest_by_looking(const ScalarGrid& cells, int x, int y) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int v = 0; v < cells.height; ++v)
    for (int u = 0; u < cells.width; ++u)
      if (cells.at(u, v) > 0) nearest = std::min(nearest, std::hypot(u - x, v - y));
  return nearest;
}

TEST(DistanceTransform, IsTheDistanceFromTheNearestCell) {
  const unsigned seed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 30; ++trial) {
    ScalarGrid cells(1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 20), -1);
    cells.values[random() % cells.values.size()] = 1;
    for (float& value : cells.values)
      if (random() % 9 == 0) value = 0.5F;
    const ScalarGrid distances = distance_transform(cells);
    for (int y = 0; y < cells.height; ++y)
      for (int x = 0; x < cells.width; ++x)
        ASSERT_NEAR(distances.at(x, y), nearest_by_looking(cells, x, y), 1e-5) << x << ' ' << y;
  }
}

TEST(DistanceTransform, IsHugeWhereThereIsNoCell) {
  for (const float value : distance_transform(ScalarGrid(4, 3, -1)).values) EXPECT_GT(value, 1e6F);
}

}  // namespace
}  // namespace foldless

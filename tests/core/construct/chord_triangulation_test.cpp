// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/chord_triangulation.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <tuple>

#include "tests/support/all_triangulations.h"

namespace foldless {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Costs that are drawn when they are asked for first, one in three infinite.
class RandomCosts {
 public:
  explicit RandomCosts(std::uint64_t seed) : random_(seed) {}
  double operator()(int i, int j, int k) {
    const auto [entry, is_new] = costs_.try_emplace({i, j, k}, 0.0);
    if (is_new) entry->second = random_() % 3 == 0 ? kNever : static_cast<double>(random_() % 1000);
    return entry->second;
  }

 private:
  std::mt19937_64 random_;
  std::map<std::tuple<int, int, int>, double> costs_;
};

TEST(ChordTriangulation, CostsTheLeastOfAllAndIsNothingWhereAllAreForbidden) {
  int found = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int corners = 3 + static_cast<int>(seed % 6);
    RandomCosts costs(seed);
    const auto sum = [&](const Triangles& triangles) {
      double total = 0;
      for (const auto& t : triangles.colwise()) total += costs(t[0], t[1], t[2]);
      return total;
    };
    double least = kNever;
    for (const test::Pieces& pieces : test::all_triangulations(0, corners - 1))
      least = std::min(least, sum(test::as_triangles(pieces)));
    const auto best =
        triangulate_by_chords(corners, [&](int i, int j, int k) { return costs(i, j, k); });
    ASSERT_EQ(best.has_value(), least < kNever);
    (best ? found : none) += 1;
    if (!best) continue;
    EXPECT_EQ(best->cols(), corners - 2);
    EXPECT_EQ(sum(*best), least);
  }
  EXPECT_GT(found, 50) << "the claim would be empty";
  EXPECT_GT(none, 50) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless

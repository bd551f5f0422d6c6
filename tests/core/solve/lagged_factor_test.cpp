// SPDX-License-Identifier: GPL-3.0-or-later
// How long the factor of an earlier Hessian serves.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/energy/densities.h"
#include "core/solve/hessian_factor.h"
#include "tests/core/linear/elastic_grid.h"
#include "tests/core/linear/random_values.h"

namespace foldless {
namespace {

/// Of a grid of n × n cells.
Hessian hessian_of_grid(int n) {
  return {test::elastic_grid(n), {.density = find_density("arap"), .beta = 2, .held = true}};
}

/// Every third node is so much stiffer, by itself: of a large grid these are too many to be solved
/// for apart.
Hessian stiffened(int n, double by) {
  Hessian stiffer = hessian_of_grid(n);
  for (int node = 0; node < stiffer.matrix.nodes; node += 3)
    add_block(stiffer.matrix, node, node, by * Eigen::Matrix2d::Identity());
  return stiffer;
}

/// What solves with a factor of hessian_of_grid(n) that follow each other take.
struct Served {
  int iterations = 0;      ///< of the first, or 0 when it gives up
  bool serves_on = false;  ///< for a second one
};

Served served(int n, const Hessian& now) {
  const Hessian earlier = hessian_of_grid(n);
  HessianFactor factor;
  factor.analyze(earlier.matrix);
  EXPECT_TRUE(factor.factorize(earlier, 0, Precision::full));
  factor.outdate();
  const auto solve = [&] {
    return factor.solve_later(now, test::random_values(now.matrix.size(), 5), 1e-3, {});
  };
  const auto first = solve();
  if (!first) return {};
  EXPECT_EQ(first->end, ConjugateGradientEnd::converged);
  return {first->iterations, solve().has_value()};
}

struct Longest {
  int solve = 0, that_serves_on = 0;
};

/// Of solves with matrices that are farther and farther from the factor's.
Longest longest(int n) {
  Longest longest;
  for (double by = 0.05; by < 100; by *= 1.2) {
    const Served of = served(n, stiffened(n, by));
    longest.solve = std::max(longest.solve, of.iterations);
    if (of.serves_on) longest.that_serves_on = std::max(longest.that_serves_on, of.iterations);
  }
  EXPECT_EQ(served(n, stiffened(n, 1e4)).iterations, 0) << "too far";
  return longest;
}

TEST(LaggedFactor, OfFewUnknownsServesUpToElevenIterationsAndOnAfterSeven) {
  const Longest of = longest(24);
  EXPECT_EQ(of.solve, 11);
  EXPECT_EQ(of.that_serves_on, 7);
}

TEST(LaggedFactor, OfManyUnknownsServesUpToSevenIterationsAndOnAfterFour) {
  const Longest of = longest(48);
  EXPECT_EQ(of.solve, 7);
  EXPECT_EQ(of.that_serves_on, 4);
}

}  // namespace
}  // namespace foldless

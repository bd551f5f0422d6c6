// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/interpolation.h"

#include <gtest/gtest.h>

#include <random>

#include "core/threads/team.h"
#include "tests/core/linear/random_values.h"

namespace foldless {
namespace {

constexpr int kFine = 5000, kCoarse = 1200;

std::vector<Interpolation::Place> random_places(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> node(0, kCoarse - 1);
  std::uniform_real_distribution<double> weight(0, 1);
  std::vector<Interpolation::Place> places(kFine);
  for (Interpolation::Place& place : places)
    for (std::size_t k = 0; k < 3; ++k) {
      place.nodes[k] = node(random);
      place.weights[k] = node(random) % 4 == 0 ? 0 : weight(random);
    }
  return places;
}

TEST(Interpolation, AddsTheValuesOfThreeNodesTimesTheirWeights) {
  const Interpolation p({{{0, 2, 1}, {0.5, 0.25, 0.25}}, {{1, 0, 0}, {1, 0, 0}}, {}}, 3);
  EXPECT_EQ(p.fine_nodes(), 3);
  EXPECT_EQ(p.coarse_nodes(), 3);
  const Eigen::VectorXd coarse{{8, 16, 1, 2, 4, -4}};
  Eigen::VectorXd fine{{100, 100, 0, 0, 7, 9}};
  p.add(coarse, fine);
  EXPECT_EQ(fine, (Eigen::VectorXd{{105.25, 107.5, 1, 2, 7, 9}}));
}

TEST(Interpolation, RestrictsWithTheTransposedMatrix) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(seed);
    const Interpolation p(random_places(seed), kCoarse);
    const Eigen::VectorXd coarse = test::random_values(2 * kCoarse, seed);
    const Eigen::VectorXd fine = test::random_values(2 * kFine, seed + 10);
    Eigen::VectorXd interpolated = Eigen::VectorXd::Zero(2 * kFine);
    p.add(coarse, interpolated);
    const Eigen::VectorXd restricted = p.restricted(fine);
    ASSERT_EQ(restricted.size(), coarse.size());
    EXPECT_NEAR(interpolated.dot(fine), coarse.dot(restricted), 1e-10);
  }
}

TEST(Interpolation, HasTheSameBitsWithAnyNumberOfThreads) {
  const Interpolation p(random_places(3), kCoarse);
  const Eigen::VectorXd coarse = test::random_values(2 * kCoarse, 3);
  Eigen::VectorXd one = test::random_values(2 * kFine, 4), three = one;
  p.add(coarse, one);
  const Eigen::VectorXd restricted = p.restricted(one);
  Team team(3);
  const WithTeam with(&team);
  p.add(coarse, three);
  EXPECT_EQ(three, one);
  EXPECT_EQ(p.restricted(three), restricted);
}

}  // namespace
}  // namespace foldless

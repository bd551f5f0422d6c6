// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cone/second_order_cone.h"

#include <gtest/gtest.h>

#include <random>

namespace foldless {
namespace {

/// A point at least 0.01 deep inside Q.
Cone3 inside(std::mt19937_64& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  Cone3 s(0, value(random), value(random));
  s[0] = s.tail<2>().norm() + 0.01 + std::abs(value(random));
  return s;
}

Cone3 anywhere(std::mt19937_64& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  return {value(random), value(random), value(random)};
}

class SecondOrderCone : public testing::TestWithParam<std::uint64_t> {
 protected:
  std::mt19937_64 random_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Seeds, SecondOrderCone, testing::Range<std::uint64_t>(1, 21));

TEST_P(SecondOrderCone, AQuotientTimesItsDivisorIsTheDividend) {
  const Cone3 u = inside(random_), v = anywhere(random_);
  EXPECT_LT((cone_product(u, cone_quotient(u, v)) - v).norm(), 1e-12);
}

TEST_P(SecondOrderCone, TheLargestStepEndsOnTheBoundary) {
  const Cone3 s = inside(random_), d = anywhere(random_);
  const double t = largest_step(s, d);
  if (std::isinf(t)) {
    EXPECT_GE(depth(s + 1e6 * d), -1e-6);
    return;
  }
  EXPECT_NEAR(depth(s + t * d), 0, 1e-9 * (1 + t));
  for (int k = 1; k < 10; ++k) EXPECT_GT(depth(s + k / 10.0 * t * d), 0);
}

TEST_P(SecondOrderCone, TheScalingTakesBothPointsToTheSameOne) {
  const Cone3 s = inside(random_), z = inside(random_);
  const NesterovTodd scaling(s, z);
  EXPECT_LT((scaling.W * z - scaling.lambda).norm(), 1e-11);
  EXPECT_LT((scaling.W_inv * s - scaling.lambda).norm(), 1e-10);
  EXPECT_LT((scaling.W * scaling.W_inv - Eigen::Matrix3d::Identity()).norm(), 1e-10);
  EXPECT_LT((scaling.W_inv * scaling.W_inv - scaling.W_inv2).norm(), 1e-10 * scaling.W_inv2.norm());
  EXPECT_LT((scaling.W - scaling.W.transpose()).norm(), 1e-12);
}

TEST(SecondOrderConeOnALine, EverythingIsWhatItIsForAHalfLine) {
  const Cone3 s(4, 0, 0), z(9, 0, 0);
  EXPECT_EQ(depth(s), 4);
  EXPECT_DOUBLE_EQ(largest_step(s, Cone3(-8, 0, 0)), 0.5);
  EXPECT_TRUE(std::isinf(largest_step(s, Cone3(1, 0, 0))));
  EXPECT_EQ(cone_quotient(s, z), Cone3(2.25, 0, 0));
  const NesterovTodd scaling(s, z);
  EXPECT_NEAR(scaling.W(0, 0), 2.0 / 3, 1e-15);
  EXPECT_NEAR(scaling.lambda[0], 6, 1e-14);
  EXPECT_EQ(scaling.lambda.tail<2>(), Eigen::Vector2d::Zero());
}

}  // namespace
}  // namespace foldless

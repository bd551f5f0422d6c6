// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/round_ticks.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(RoundTicks, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_step(1), 1);
  EXPECT_DOUBLE_EQ(round_step(1.1), 2);
  EXPECT_DOUBLE_EQ(round_step(30), 50);
  EXPECT_DOUBLE_EQ(round_step(51), 100);
  EXPECT_DOUBLE_EQ(round_step(0.03), 0.05);
}

TEST(RoundTicks, AreTheMultiplesWithinTheEnds) {
  EXPECT_EQ(multiples(5, -6, 10), (std::vector<double>{-5, 0, 5, 10}));
  EXPECT_TRUE(multiples(5, 6, 9).empty());
}

TEST(RoundTicks, AreNoneWhereNumbersCannotBeToldApart) {
  EXPECT_TRUE(multiples(1e-9, 1e9, 1e9 + 1e-7).empty());
}

}  // namespace
}  // namespace foldless

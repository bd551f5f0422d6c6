// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace foldless {
namespace {

TEST(DecadesOf, HoldsEveryPositiveValue) {
  const std::array values{3e-9, 0.2, 41.0};
  const DecadeRange range = decades_of(values);
  EXPECT_EQ(range.low, -9);
  EXPECT_EQ(range.high, 2);
}

TEST(DecadesOf, LeavesOutWhatALogarithmCannotShow) {
  const std::array<double, 5> values{0.0, -1.0, INFINITY, NAN, 5.0};
  const DecadeRange range = decades_of(values);
  EXPECT_EQ(range.low, 0);
  EXPECT_EQ(range.high, 1);
}

TEST(DecadesOf, HasAnExtentWhateverComes) {
  EXPECT_LT(decades_of({}).low, decades_of({}).high);
  const std::array one{1.0, 1.0};
  EXPECT_LT(decades_of(one).low, decades_of(one).high);
}

TEST(PowerOfTen, RaisesTheExponent) {
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(power_of_ten(3), "10³");
}

}  // namespace
}  // namespace foldless

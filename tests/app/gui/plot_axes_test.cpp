// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot_axes.h"

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

PlotAxes axes(double low, double high, bool is_logarithmic) {
  return {{100, 10}, {300, 110}, low, high, 11, is_logarithmic};
}

TEST(PlotAxes, PutsValuesWhereTheyBelong) {
  const PlotAxes linear = axes(0, 50, false);
  EXPECT_FLOAT_EQ(linear.y(0), 110);
  EXPECT_FLOAT_EQ(linear.y(25), 60);
  EXPECT_FLOAT_EQ(linear.x(10), 300);
  const PlotAxes logarithmic = axes(-2, 2, true);
  EXPECT_FLOAT_EQ(logarithmic.y(1), 60);
  EXPECT_FALSE(logarithmic.is_drawable(0));
  EXPECT_TRUE(linear.is_drawable(0));
}

TEST(PlotAxes, ZerosHaveAPlaceAtTheBottomOfALogarithmicAxis) {
  const std::array curves{PlotCurve{"E", {1.0, 0.01, 0.0}, {}}};
  ImFont font;
  font.FontSize = 10;
  const PlotAxes with_zero = axes_of({"id", "title", curves, true, {}, {200, 100}, &font}, {0, 0});
  EXPECT_TRUE(with_zero.is_drawable(0));
  EXPECT_FLOAT_EQ(with_zero.y(0), with_zero.max.y);
  EXPECT_LT(with_zero.y(0.01), with_zero.max.y - 10) << "0 is not 0.01";
  EXPECT_EQ(with_zero.ticks(10).front().label, "0");

  const std::array nothing_but_zeros{PlotCurve{"E", {0.0, 0.0}, {}}};
  const PlotAxes zeros =
      axes_of({"id", "title", nothing_but_zeros, true, {}, {200, 100}, &font}, {0, 0});
  EXPECT_TRUE(zeros.is_drawable(0));
}

TEST(PlotAxes, FindsTheIterationUnderThePointer) {
  const PlotAxes a = axes(0, 1, false);
  for (std::size_t i = 0; i < a.count; ++i) EXPECT_EQ(a.index_at(a.x(i) + 4), i);
  EXPECT_EQ(a.index_at(-1000), 0U);
  EXPECT_EQ(a.index_at(1000), 10U);
}

TEST(PlotAxes, TicksAreRoundNumbersWithRoomBetweenThem) {
  for (const PlotAxes& a : {axes(0, 37, false), axes(-1.5, 0.2, false), axes(-12, 3, true)}) {
    const auto ticks = a.ticks(20);
    ASSERT_GE(ticks.size(), 2U);
    for (std::size_t i = 1; i < ticks.size(); ++i)
      EXPECT_GE(a.y(ticks[i - 1].value) - a.y(ticks[i].value), 19.9F);
  }
  EXPECT_EQ(axes(0, 37, false).ticks(25)[1].label, "10");
  EXPECT_EQ(axes(-12, 3, true).ticks(40).front().label, "10⁻¹²");
}

TEST(PowerOfTen, RaisesTheExponent) {
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(power_of_ten(3), "10³");
}

}  // namespace
}  // namespace foldless

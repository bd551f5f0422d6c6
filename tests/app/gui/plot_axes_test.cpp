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
  PlotAxes a{{100, 10}, {300, 110}, low, high, 11, is_logarithmic};
  a.first = 1;
  a.last = 11;
  return a;
}

TEST(PlotAxes, PutsValuesWhereTheyBelong) {
  const PlotAxes linear = axes(0, 50, false);
  EXPECT_FLOAT_EQ(linear.y(0), 110);
  EXPECT_FLOAT_EQ(linear.y(25), 60);
  EXPECT_FLOAT_EQ(linear.x(11), 300);
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

Plot plot_of(std::span<const PlotCurve> curves, ImFont& font, PlotZoom* zoom = nullptr) {
  font.FontSize = 10;
  Plot plot;
  plot.curves = curves;
  plot.size = {200, 100};
  plot.font = &font;
  plot.zoom = zoom;
  return plot;
}

TEST(PlotAxes, FindsTheIterationUnderThePointer) {
  ImFont font;
  const std::array curves{PlotCurve{"short", {1, 2}, {}}, PlotCurve{"long", {1, 2, 3, 4, 5}, {}}};
  const Plot plot = plot_of(curves, font);
  const PlotAxes a = axes_of(plot, {0, 0});
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(index_near(plot, a.position_at(a.x(static_cast<double>(i) + 1) + 4)), i);
  EXPECT_EQ(index_near(plot, a.position_at(-1000)), 0U);
  EXPECT_EQ(index_near(plot, a.position_at(1000)), 4U);
}

TEST(PlotAxes, ValuesStandAtTheirTimesWhereTheyHaveSome) {
  ImFont font;
  const std::array curves{PlotCurve{"E", {3, 2, 1}, {}, LineStyle::solid, {0.001, 0.002, 0.009}}};
  const Plot plot = plot_of(curves, font);
  const PlotAxes a = axes_of(plot, {0, 0});
  EXPECT_FLOAT_EQ(a.x(0.001), a.min.x);
  EXPECT_FLOAT_EQ(a.x(0.009), a.max.x);
  EXPECT_EQ(index_near(plot, 0.0052), 1U);
  EXPECT_EQ(index_near(plot, 0.006), 2U);
  const auto ticks = a.position_ticks(40);
  ASSERT_GE(ticks.size(), 2U);
  EXPECT_EQ(ticks.back().label, "0.008");
}

TEST(PlotAxes, IterationsHaveWholeNumbers) {
  ImFont font;
  const std::array curves{PlotCurve{"E", {3, 2, 1}, {}}};
  const auto ticks = axes_of(plot_of(curves, font), {0, 0}).position_ticks(10);
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_EQ(ticks.front().label, "1");
  EXPECT_EQ(ticks.back().label, "3");
}

TEST(PlotZoom, KeepsWhatIsUnderThePointerAndEndsAtTheWhole) {
  const PlotZoom closer = zoomed({}, 0.25, 0.5);
  EXPECT_DOUBLE_EQ(closer.last - closer.first, 0.5);
  EXPECT_DOUBLE_EQ(closer.first + 0.25 * (closer.last - closer.first), 0.25);
  EXPECT_TRUE(zoomed(closer, 0.9, 100).is_whole());
  const PlotZoom closest = zoomed({}, 1, 1e-30);
  EXPECT_GT(closest.last, closest.first);
  EXPECT_LE(closest.last, 1);
}

TEST(PlotZoom, ShowsAPartOfTheAxis) {
  ImFont font;
  PlotZoom zoom{0.5, 1};
  const std::array curves{PlotCurve{"E", {5, 4, 3, 2, 1}, {}}};
  const PlotAxes a = axes_of(plot_of(curves, font, &zoom), {0, 0});
  EXPECT_DOUBLE_EQ(a.first, 3);
  EXPECT_DOUBLE_EQ(a.last, 5);
  EXPECT_FALSE(a.is_in_sight(2));
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

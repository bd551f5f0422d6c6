// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/svg_plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "app/export/svg_axis.h"

namespace foldless {
namespace {

int count_of(const std::string& what, const std::string& text) {
  int count = 0;
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + 1)) ++count;
  return count;
}

/// The points of the n-th polyline.
std::vector<std::pair<double, double>> points_of_curve(const std::string& svg, int n) {
  std::size_t begin = 0;
  for (int i = 0; i <= n; ++i) begin = svg.find("<polyline points=\"", begin) + 18;
  std::istringstream text(svg.substr(begin, svg.find('"', begin) - begin));
  std::vector<std::pair<double, double>> points;
  double x, y;
  char comma;
  while (text >> x >> comma >> y) points.emplace_back(x, y);
  return points;
}

TEST(AxisScale, HoldsEveryValueBetweenItsEnds) {
  const AxisScale axis({-3, 7, 2}, false);
  EXPECT_EQ(axis.fraction(-3), 0);
  EXPECT_EQ(axis.fraction(7), 1);
  EXPECT_EQ(axis.fraction(2), 0.5);
}

TEST(AxisScale, LogarithmicAxesSpaceFactorsEvenly) {
  const AxisScale axis({1e-6, 1e2}, true);
  EXPECT_NEAR(axis.fraction(1e-4) - axis.fraction(1e-6), axis.fraction(1) - axis.fraction(1e-2),
              1e-12);
  EXPECT_EQ(axis.ticks().front().exponent, "-6");
  EXPECT_EQ(axis.ticks().back().exponent, "2");
}

TEST(AxisScale, LeavesOutWhatItCannotShow) {
  const AxisScale axis({0, -1, std::numeric_limits<double>::infinity(), 10, 1000}, true);
  EXPECT_FALSE(axis.holds(0));
  EXPECT_FALSE(axis.holds(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(axis.fraction(10), 0);
  EXPECT_EQ(axis.fraction(1000), 1);
}

TEST(AxisScale, ZeroHasNoSign) { EXPECT_EQ(AxisScale({0, 10}, false).ticks().front().text, "0"); }

TEST(AxisScale, HasAFewTicksInsideWhateverTheRange) {
  for (const bool is_logarithmic : {false, true})
    for (const double high : {1.5e-300, 3e-5, 0.9, 1.0, 7.0, 12345.0, 1e300})
      for (const std::vector<double>& values :
           {std::vector<double>{high}, {high / 3, high}, {1e-12 * high, high}}) {
        const AxisScale axis(values, is_logarithmic);
        const std::vector<Tick> ticks = axis.ticks();
        EXPECT_GE(ticks.size(), 2u) << high;
        EXPECT_LE(ticks.size(), 9u) << high;
        for (const Tick& tick : ticks) {
          EXPECT_GE(axis.fraction(tick.value), -1e-6) << high;
          EXPECT_LE(axis.fraction(tick.value), 1 + 1e-6) << high;
        }
      }
}

TEST(SvgPlot, DrawsEveryCurveAndNamesItInTheLegend) {
  const std::string svg = svg_plot({{"with flips", {3, 2, 1}}, {"without", {3, 2.5, 2, 1.5}}},
                                   {.title = "E", .y = {"energy"}});
  EXPECT_EQ(count_of("<polyline", svg), 2);
  EXPECT_NE(svg.find(">with flips</text>"), std::string::npos);
  EXPECT_NE(svg.find(">energy</text>"), std::string::npos);
  EXPECT_EQ(points_of_curve(svg, 1).size(), 4u);
}

TEST(SvgPlot, LargerValuesAreHigherAndFartherRight) {
  const std::string svg = svg_plot({{"", {1e-8, 1e-4, 1}}}, {.y = {"", true}});
  const auto points = points_of_curve(svg, 0);
  ASSERT_EQ(points.size(), 3u);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_GT(points[i].first, points[i - 1].first);
    EXPECT_LT(points[i].second, points[i - 1].second);
  }
  EXPECT_NEAR(points[0].second - points[1].second, points[1].second - points[2].second, 0.2);
}

TEST(SvgPlot, BreaksACurveAtAValueThatTheAxisCannotShow) {
  const std::string svg = svg_plot({{"", {10, 1, 0, 1, 10}}}, {.y = {"", true}});
  EXPECT_EQ(count_of("<polyline", svg), 2);
}

TEST(SvgPlot, TheLegendIsWhereItHidesNothing) {
  std::vector<double> falling, rising;
  for (int i = 0; i <= 100; ++i) {
    falling.push_back(100 - i);
    rising.push_back(i);
  }
  const auto legend_y = [](const std::string& svg) {
    const std::size_t end = svg.find(">curve</text>");
    const std::size_t begin = svg.rfind("y=\"", end) + 3;
    return std::stod(svg.substr(begin));
  };
  EXPECT_LT(legend_y(svg_plot({{"curve", falling}}, {})), 210) << "at the top right";
  EXPECT_GT(legend_y(svg_plot({{"curve", rising}}, {})), 210) << "at the bottom right";
}

TEST(SvgPlot, EscapesNames) {
  const std::string svg = svg_plot({{"a < b & \"c\"", {1, 2}}}, {.title = "<svg>"});
  EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(count_of("<svg", svg), 1);
}

TEST(SvgPlot, NothingToDrawIsAnEmptyFrame) {
  const std::string svg = svg_plot({}, {.title = "nothing"});
  EXPECT_EQ(count_of("<polyline", svg), 0);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace foldless

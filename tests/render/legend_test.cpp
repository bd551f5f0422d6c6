// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/legend.h"

#include <gtest/gtest.h>

#include "render/stroke_font.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

std::vector<std::string> labels_of(const HeatRange& range, int at_most) {
  std::vector<std::string> labels;
  for (const LegendTick& tick : legend_ticks(range, at_most)) labels.push_back(tick.label);
  return labels;
}

TEST(Legend, TicksAreRoundNumbersBetweenTheEnds) {
  EXPECT_EQ(labels_of({.min = 1, .max = 30}, 12),
            (std::vector<std::string>{"1", "2", "5", "10", "20", "30"}));
}

TEST(Legend, AWideScaleKeepsPowersOfTen) {
  EXPECT_EQ(labels_of({.min = 1, .max = 2e4}, 6),
            (std::vector<std::string>{"1", "10", "100", "1000", "10000", "20000"}));
}

TEST(Legend, TicksRiseAndAreNeverMoreThanAsked) {
  for (const double max : {1.01, 1.3, 7.0, 123.0, 4e5, 1e12})
    for (const int at_most : {2, 3, 5, 12}) {
      const auto ticks = legend_ticks({.min = 1, .max = max}, at_most);
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(at_most)) << max;
      for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_GT(ticks[i].t, ticks[i - 1].t) << max;
    }
}

TEST(Legend, BarRunsFromTheFirstColourUpToTheLast) {
  Image image(300, 400);
  ViewOptions style;
  draw_legend(image, {.min = 1, .max = 10}, style);
  const int x = 300 - legend_width(1) + 12;
  double last = -1;
  for (int y = 300; y >= 100; y -= 20) {
    const double place = test::place_on_viridis(image.at(x, y));
    EXPECT_GT(place, last);
    last = place;
  }
}

TEST(Legend, FitsIntoItsWidthAndSparesTheRest) {
  Image image(300, 400);
  draw_legend(image, {.min = 0.00123, .max = 98765}, {});
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 300 - legend_width(1); ++x) ASSERT_EQ(image.at(x, y)[3], 0);
    ASSERT_EQ(image.at(299, y)[3], 0);
  }
}

TEST(StrokeFont, EveryDigitLooksDifferent) {
  std::vector<Image> digits;
  for (char digit = '0'; digit <= '9'; ++digit) {
    Image image(16, 20);
    draw_stroke_text(image, std::string(1, digit), {{3, 16}, 12, {0, 0, 0, 1}});
    for (const Image& other : digits) EXPECT_FALSE(image == other) << digit;
    digits.push_back(image);
  }
}

TEST(StrokeFont, WidthGrowsWithTheHeight) {
  EXPECT_DOUBLE_EQ(stroke_text_width("3.14", 20), 2 * stroke_text_width("3.14", 10));
  EXPECT_DOUBLE_EQ(stroke_text_width("", 20), 0);
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/layout.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace foldless {
namespace {

double area(const Rectangle& r) { return static_cast<double>(r.width) * r.height; }

bool overlap(const Rectangle& a, const Rectangle& b) {
  return area(a) > 0 && area(b) > 0 && a.x < b.x + b.width && b.x < a.x + a.width &&
         a.y < b.y + b.height && b.y < a.y + a.height;
}

class LayoutFor : public testing::TestWithParam<float> {};

TEST_P(LayoutFor, FillsTheWindowWithoutOverlap) {
  for (const Extent size : {Extent{1280, 800}, Extent{2560, 1600}, Extent{500, 360}}) {
    const Layout l = layout_for(size, GetParam(), SidePanels::two);
    const std::array parts{l.menu_bar, l.strip,    l.left,      l.right,
                           l.canvas,   l.timeline, l.status_bar};
    double sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      sum += area(parts[i]);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(overlap(parts[i], parts[j])) << i << " and " << j << " at " << size.width;
    }
    EXPECT_DOUBLE_EQ(sum, static_cast<double>(size.width) * size.height);
  }
}

TEST_P(LayoutFor, LeavesTheCanvasAtLeastAThirdOfTheWidth) {
  const Layout l = layout_for({1280, 800}, GetParam(), SidePanels::two);
  EXPECT_GE(l.canvas.width, 1280 / 3);
}

TEST_P(LayoutFor, GivesPanelsTheirWidthsAsLongAsTheCanvasKeepsAThird) {
  const PanelWidths wide = kWidestPanels;
  for (const int width : {1000, 1280, 2560, 3840}) {
    const Layout l = layout_for({width, 800}, GetParam(), SidePanels::two, wide);
    if (l.left.width > 0) {
      EXPECT_GE(l.canvas.width, width / 3) << width;
      EXPECT_GE(l.left.width, std::round(kNarrowestPanels.left * GetParam())) << width;
    }
  }
  const Layout two = layout_for({8000, 800}, GetParam(), SidePanels::two, wide);
  EXPECT_EQ(two.left.width, std::round(640 * GetParam()));
  EXPECT_EQ(two.right.width, two.left.width);
  const Layout one = layout_for({8000, 800}, GetParam(), SidePanels::one, {200, 400});
  EXPECT_EQ(one.right.width, std::round(400 * GetParam()));
}

TEST_P(LayoutFor, GivesTheWholeWidthToTheCanvasWithoutPanels) {
  EXPECT_EQ(layout_for({1280, 800}, GetParam(), SidePanels::none).canvas.width, 1280);
}

TEST_P(LayoutFor, SplitsTheCanvasInTwoPanesOfOneSize) {
  const Layout whole = layout_for({1281, 800}, GetParam(), SidePanels::two);
  Layout l = whole;
  split_canvas(l, GetParam());
  EXPECT_EQ(l.side.width, l.canvas.width);
  EXPECT_EQ(l.side.height, l.canvas.height);
  EXPECT_EQ(l.side.x, whole.canvas.x);
  EXPECT_EQ(l.canvas.x + l.canvas.width, whole.canvas.x + whole.canvas.width);
  EXPECT_FALSE(overlap(l.side, l.canvas));
}

TEST_P(LayoutFor, RulersTakeAnLFromEachPane) {
  Layout l = layout_for({1280, 800}, GetParam(), SidePanels::two);
  split_canvas(l, GetParam());
  const Layout before = l;
  add_rulers(l, GetParam());
  const auto expect_filled = [](const Rectangle& pane, const Rulers& rulers, const Rectangle& was) {
    EXPECT_GT(area(rulers.left), 0);
    EXPECT_EQ(area(pane) + area(rulers.top) + area(rulers.left), area(was));
    EXPECT_FALSE(overlap(pane, rulers.top) || overlap(pane, rulers.left));
    EXPECT_FALSE(overlap(rulers.top, rulers.left));
  };
  expect_filled(l.canvas, l.rulers, before.canvas);
  expect_filled(l.side, l.side_rulers, before.side);
}

INSTANTIATE_TEST_SUITE_P(Scales, LayoutFor, testing::Values(0.75F, 1.0F, 1.5F, 2.0F, 3.0F));

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/tooltips.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

bool touch(const Rectangle& a, const Rectangle& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(TooltipPlace, IsBesideTheWindowOfTheItemWhereThatIsNearest) {
  const Rectangle display{0, 0, 1000, 600};
  const auto place = [&](const Rectangle& item, const Rectangle& window) {
    const Rectangle tip = tooltip_place({item, window, display}, {200, 40}, 4);
    EXPECT_FALSE(touch(tip, window)) << tip.x << ' ' << tip.y;
    return tip;
  };
  EXPECT_EQ(place({810, 100, 60, 20}, {800, 0, 200, 600}).x, 596) << "left of a panel at the right";
  EXPECT_EQ(place({10, 100, 180, 20}, {0, 0, 200, 600}).x, 204) << "right of one at the left";
  EXPECT_EQ(place({300, 565, 20, 20}, {0, 560, 1000, 40}).y, 516) << "over a bar at the bottom";
  EXPECT_EQ(place({300, 35, 20, 20}, {0, 30, 1000, 40}).y, 74) << "under a bar at the top";
  const Rectangle last = place({950, 5, 40, 20}, {0, 0, 1000, 30});
  EXPECT_EQ(last.x, 800) << "and inside of the display";
}

TEST(TooltipPlace, LeavesTheItemFreeWhereItsWindowFillsTheDisplay) {
  const Rectangle display{0, 0, 300, 100};
  const Rectangle item{10, 70, 50, 20};
  EXPECT_FALSE(touch(tooltip_place({item, display, display}, {200, 40}, 4), item));
}

class TooltipsTest : public testing::Test {
 protected:
  TooltipsTest() {
    headless_.editor().files().open_shape(bar(4, 1, 2), "bar");
    headless_.calm_down();
  }
  /// Of the tooltip that is shown; without width when there is none.
  static Rectangle tip() {
    const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
    if (!window || !window->WasActive || window->Hidden) return {};
    return {window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
  }
  /// About so long, in frames of 1/60 s.
  void rest(double seconds) {
    int frames = static_cast<int>(60 * seconds);
    headless_.wait_until([&frames] { return --frames < 0; });
  }

  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(TooltipsTest, AppearAfterARestAndBesideTheTimeline) {
  const Rectangle bar = headless_.ui().layout().timeline;
  const Vec2 first(bar.x + 20, bar.y + bar.height / 2);
  headless_.move(first);
  rest(0.3);
  EXPECT_EQ(tip().width, 0) << "not at once";
  ASSERT_TRUE(headless_.next_frame());
  EXPECT_LT(*headless_.next_frame(), 0.3);
  rest(0.3);
  ASSERT_GT(tip().width, 0);
  EXPECT_FALSE(touch(tip(), bar));
  EXPECT_FALSE(headless_.next_frame()) << "and costs nothing then";
  headless_.move(first + Vec2(2, 1));
  EXPECT_GT(tip().width, 0) << "stays while the mouse is on the item";
  headless_.move(first + Vec2(30, 0));
  EXPECT_EQ(tip().width, 0) << "the neighbour's waits";
}

TEST_F(TooltipsTest, LeaveThePanelAndItsOtherRowsFree) {
  const Rectangle panel = headless_.ui().layout().right;
  headless_.move({panel.x + 40, panel.y + 102});
  rest(0.6);
  ASSERT_GT(tip().width, 0);
  EXPECT_FALSE(touch(tip(), panel));
}

TEST_F(TooltipsTest, GoWithAClickAndWaitForTheNextMove) {
  const Rectangle bar = headless_.ui().layout().timeline;
  const Vec2 first(bar.x + 20, bar.y + bar.height / 2);
  headless_.move(first);
  rest(0.6);
  ASSERT_GT(tip().width, 0);
  headless_.click(first);
  rest(0.8);
  EXPECT_EQ(tip().width, 0);
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Words and numbers have room: no column is cut, lanes can be told apart at every scale.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cstring>

#include "app/gui/race_layout.h"
#include "app/gui/short_text.h"
#include "tests/app/gui/bent_bar.h"

namespace foldless::test {
namespace {

TEST(ShortNumber, LeavesOutWhatSaysNothing) {
  EXPECT_EQ(short_number(12345, 3), "1.23e4");
  EXPECT_EQ(short_number(2.75e-17, 2), "2.8e-17");
  EXPECT_EQ(short_number(1e-7, 3), "1e-7");
  EXPECT_EQ(short_number(0.174, 3), "0.174");
  EXPECT_EQ(short_number(-1e300, 3), "-1e300");
  EXPECT_EQ(short_number(0, 3), "0");
}

/// The table with so many columns that was drawn in the last frame, or null.
const ImGuiTable* table_of(int columns) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  for (int i = 0; i < context.Tables.GetMapSize(); ++i) {
    const ImGuiTable* table = context.Tables.TryGetMapData(i);
    if (table && table->ColumnsCount == columns && table->LastFrameActive == context.FrameCount)
      return table;
  }
  return nullptr;
}

/// By how many pixels the rows of the table are wider than their columns; headers excepted.
float missing_room(const ImGuiTable& table) {
  float most = 0;
  for (int i = 0; i < table.ColumnsCount; ++i) {
    const ImGuiTableColumn& column = table.Columns[i];
    most = std::max(most, column.ContentMaxXUnfrozen - column.WorkMaxX);
  }
  return most;
}

class TextRoom : public testing::TestWithParam<float> {
 protected:
  /// A bar that was bent by the paper's method: energies of many digits.
  void bend() {
    headless_.set_content_scale(GetParam());
    ASSERT_TRUE(bend_a_bar(headless_));
  }
  void race() {
    headless_.key(Key::m);
    ASSERT_TRUE(editor().race().is_open());
    ASSERT_TRUE(headless_.wait_until([this] { return editor().race().is_finished(); }));
    headless_.calm_down();
  }
  /// At a pixel of the framebuffer.
  void turn_wheel(double notches, const Vec2& pixel) {
    headless_.ui().receive(WheelTurned{notches, pixel / GetParam()});
    headless_.settle();
  }
  Editor& editor() { return headless_.editor(); }

  HeadlessEditor headless_{{1280, 800}};
};

TEST_P(TextRoom, TheColumnsOfIterationsDoNotMeet) {
  bend();
  const Rectangle panel = headless_.ui().layout().right;
  for (int i = 0; i < 100 && !table_of(5); ++i) turn_wheel(-1, {panel.x + 40, panel.y + 50});
  ASSERT_NE(table_of(5), nullptr);
  EXPECT_LE(missing_room(*table_of(5)), 0) << "the last iterations";
  const ImVec2 middle = table_of(5)->OuterRect.GetCenter();
  for (int i = 0; i < 40; ++i) turn_wheel(1, {middle.x, middle.y});
  ASSERT_NE(table_of(5), nullptr);
  EXPECT_LE(missing_room(*table_of(5)), 0) << "the first iterations";
}

TEST_P(TextRoom, TheTableOfARaceCutsNothing) {
  bend();
  race();
  ASSERT_NE(table_of(7), nullptr);
  EXPECT_LE(missing_room(*table_of(7)), 0);
}

TEST_P(TextRoom, TheNamesOfLanesDiffer) {
  bend();
  race();
  const auto lanes =
      race_layout_for(headless_.ui().layout().canvas, editor().race().lanes().size(), GetParam())
          .lanes;
  const Image picture = headless_.picture();
  const float scale = GetParam();
  // Between what is before the name and the button behind it.
  const auto differing = [&](const Rectangle& a, const Rectangle& b) {
    int count = 0;
    for (int y = static_cast<int>(8 * scale); y < static_cast<int>(30 * scale); ++y)
      for (int x = static_cast<int>(48 * scale); x < static_cast<int>(a.width - 84 * scale); ++x)
        count +=
            std::memcmp(picture.at(static_cast<int>(a.x) + x, static_cast<int>(a.y) + y),
                        picture.at(static_cast<int>(b.x) + x, static_cast<int>(b.y) + y), 4) != 0;
    return count;
  };
  for (std::size_t i = 0; i < lanes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(differing(lanes[i].head, lanes[k].head), 30) << "lanes " << k << " and " << i;
}

INSTANTIATE_TEST_SUITE_P(Scales, TextRoom, testing::Values(1.0F, 2.0F));

}  // namespace
}  // namespace foldless::test

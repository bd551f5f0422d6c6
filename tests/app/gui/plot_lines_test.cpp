// SPDX-License-Identifier: GPL-3.0-or-later
// What the pen of the plots puts into a list of triangles.
#include "app/gui/plot_lines.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>

namespace foldless::test {
namespace {

class PlotLines : public testing::Test {
 protected:
  PlotLines() {
    list_._ResetForNewFrame();
    list_.PushClipRectFullScreen();
    list_.PushTextureID(nullptr);
  }
  /// Columns at a distance whose values rise from one to the next.
  void draw_steps(int count, float distance) {
    PlotCurve curve;
    curve.colour = {1, 1, 1, 1};
    CurvePen pen(list_, curve, kThickness);
    for (int i = 0; i < count; ++i) {
      const float x = distance * static_cast<float>(i), y = kStep * static_cast<float>(i);
      pen.go_on({x, y, y + 1, y, y + 1});
    }
  }
  const ImDrawVert& vertex(int index) const { return list_.VtxBuffer[list_.IdxBuffer[index]]; }

  static constexpr float kThickness = 1.5F;
  static constexpr float kStep = 20;
  ImDrawListSharedData shared_;
  ImDrawList list_{&shared_};
};

TEST_F(PlotLines, ColumnsThatFollowEachOtherAreARectangleEachWithoutAGap) {
  constexpr int kCount = 200, kIndices = 6;
  draw_steps(kCount, 1);
  ASSERT_EQ(list_.IdxBuffer.Size, kIndices * kCount);
  for (int i = 1; i < kCount; ++i) {
    const ImVec2 high_before = vertex(kIndices * (i - 1) + 2).pos, low = vertex(kIndices * i).pos;
    EXPECT_GE(high_before.x, low.x) << i;
    EXPECT_GE(high_before.y, low.y) << i;
  }
}

TEST_F(PlotLines, ColumnsApartAreJoinedByLines) {
  draw_steps(2, 30);
  float highest = 0, lowest = kStep;
  for (int i = 0; i < list_.IdxBuffer.Size; i += 3) {
    // Of the triangles that are neither in the first nor in the second column.
    const float middle = (vertex(i).pos.x + vertex(i + 1).pos.x + vertex(i + 2).pos.x) / 3;
    if (middle < 5 || middle > 25) continue;
    for (int k = 0; k < 3; ++k) {
      highest = std::max(highest, vertex(i + k).pos.x);
      lowest = std::min(lowest, vertex(i + k).pos.x);
    }
  }
  EXPECT_LT(lowest, 1);
  EXPECT_GT(highest, 29);
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ui_renderer.h"

#include <glad/gl.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>

#include "render/offscreen.h"

namespace foldless {
namespace {

constexpr int kSide = 128;  // of the picture

struct ImGuiSession {
  ImGuiSession() { ImGui::CreateContext(); }
  ~ImGuiSession() { ImGui::DestroyContext(); }
  ImGuiSession(const ImGuiSession&) = delete;
  ImGuiSession& operator=(const ImGuiSession&) = delete;
};

/// The picture of what is added to one list, over blue.
class UiRendererTest : public testing::Test {
 protected:
  UiRendererTest() {
    ImGui::GetIO().DisplaySize = {kSide, kSide};
    ImGui::GetIO().IniFilename = nullptr;
    renderer_.upload_fonts(*ImGui::GetIO().Fonts);
    ImGui::NewFrame();
  }
  ImDrawList& list() { return *ImGui::GetForegroundDrawList(); }
  Image picture() {
    ImGui::Render();
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer_.draw(*ImGui::GetDrawData());
    return offscreen_.read();
  }

 private:
  ImGuiSession session_;
  Offscreen offscreen_{kSide, kSide, 1};
  UiRenderer renderer_;
};

/// Channel by channel to within one.
testing::AssertionResult is_colour(const Image& image, int x, int y, ImU32 colour) {
  const std::uint8_t* pixel = image.at(x, y);
  bool is_near = true;
  for (int c = 0; c < 4; ++c)
    is_near = is_near && std::abs(pixel[c] - static_cast<int>(colour >> (8 * c) & 255)) <= 1;
  if (is_near) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "pixel " << x << ", " << y << " is " << int{pixel[0]} << ' ' << int{pixel[1]} << ' '
         << int{pixel[2]} << ' ' << int{pixel[3]};
}

TEST_F(UiRendererTest, LargeOpaqueAreasHideWhatIsBelow) {
  list().AddRectFilled({0, 0}, {kSide, kSide}, IM_COL32(200, 100, 50, 255));
  EXPECT_TRUE(is_colour(picture(), 64, 64, IM_COL32(200, 100, 50, 255)));
}

TEST_F(UiRendererTest, LargeTranslucentAreasAreMixedWithWhatIsBelow) {
  list().AddRectFilled({0, 0}, {kSide, kSide}, IM_COL32(255, 0, 0, 255));
  list().AddRectFilled({0, 0}, {kSide, kSide}, IM_COL32(0, 255, 0, 51));
  EXPECT_TRUE(is_colour(picture(), 64, 64, IM_COL32(204, 51, 0, 255)));
}

TEST_F(UiRendererTest, SoftEdgesOfALargeOpaqueAreaAreMixedWithWhatIsBelow) {
  list().AddCircleFilled({64, 64}, 60, IM_COL32(255, 255, 255, 255), 64);
  const Image image = picture();
  EXPECT_TRUE(is_colour(image, 64, 64, IM_COL32(255, 255, 255, 255)));
  EXPECT_TRUE(is_colour(image, 1, 1, IM_COL32(0, 0, 255, 255)));
  int soft = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      soft += image.at(x, y)[0] > 20 && image.at(x, y)[0] < 235 ? 1 : 0;
      ASSERT_EQ(int{image.at(x, y)[2]}, 255) << x << ", " << y;
    }
  }
  EXPECT_GT(soft, 100);
}

TEST_F(UiRendererTest, AColourThatFadesOutIsMixedWithWhatIsBelow) {
  list().AddRectFilledMultiColor({0, 0}, {kSide, kSide}, IM_COL32(255, 0, 0, 255),
                                 IM_COL32(255, 0, 0, 0), IM_COL32(255, 0, 0, 0),
                                 IM_COL32(255, 0, 0, 255));
  EXPECT_TRUE(is_colour(picture(), 127, 64, IM_COL32(1, 0, 254, 255)));
}

TEST_F(UiRendererTest, LettersAreDrawnBetweenLargeAreas) {
  list().AddRectFilled({0, 0}, {kSide, kSide}, IM_COL32(0, 0, 0, 255));
  list().AddText({8, 8}, IM_COL32_WHITE, "MMMM");
  list().AddRectFilled({0, 64}, {kSide, kSide}, IM_COL32(0, 255, 0, 255));
  const Image image = picture();
  int white = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) white += image.at(x, y)[0] > 200 ? 1 : 0;
  EXPECT_GT(white, 40);
  EXPECT_LT(white, 600);
  EXPECT_TRUE(is_colour(image, 64, 100, IM_COL32(0, 255, 0, 255)));
}

}  // namespace
}  // namespace foldless

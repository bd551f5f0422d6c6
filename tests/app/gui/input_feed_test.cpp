// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input_feed.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace foldless {
namespace {

const Vec2 kOne{1, 1};

class InputFeedTest : public testing::Test {
 protected:
  InputFeedTest() { ImGui::CreateContext(); }
  ~InputFeedTest() override { ImGui::DestroyContext(); }

  ImGuiIO& io() { return ImGui::GetIO(); }

  InputFeed feed_;
};

TEST_F(InputFeedTest, ShowsAPressAndItsReleaseInTwoFrames) {
  feed_.push(PointerPressed{Button::left, {5, 6}, {}});
  feed_.push(PointerReleased{Button::left, {5, 6}, {}});
  EXPECT_EQ(feed_.take_frame(io(), kOne).size(), 1U);
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_EQ(feed_.take_frame(io(), kOne).size(), 1U);
  EXPECT_FALSE(io().MouseDown[0]);
  EXPECT_TRUE(feed_.is_empty());
}

TEST_F(InputFeedTest, ShowsTheTapOfAKeyInTwoFrames) {
  feed_.push(KeyPressed{Key::z, {}, false});
  feed_.push(KeyReleased{Key::z});
  feed_.take_frame(io(), kOne);
  EXPECT_TRUE(io().KeysDown[static_cast<int>(Key::z)]);
  feed_.take_frame(io(), kOne);
  EXPECT_FALSE(io().KeysDown[static_cast<int>(Key::z)]);
}

TEST_F(InputFeedTest, HoldsTheModifiersOfAKeyThatIsLetGoAfterThem) {
  feed_.push(ModifiersHeld{{.control = true}});
  feed_.push(KeyPressed{Key::n, {.control = true}, false});
  feed_.push(ModifiersHeld{});
  feed_.push(KeyReleased{Key::n});
  feed_.take_frame(io(), kOne);
  EXPECT_TRUE(io().KeysDown[static_cast<int>(Key::n)]);
  EXPECT_TRUE(io().KeyCtrl);
  feed_.take_frame(io(), kOne);
  EXPECT_FALSE(io().KeyCtrl);
}

TEST_F(InputFeedTest, TakesManyMovesAtOnceButNoneAfterAPress) {
  for (int i = 1; i <= 5; ++i) feed_.push(PointerMoved{Vec2(i, i), {}});
  feed_.push(PointerPressed{Button::left, {5, 5}, {}});
  feed_.push(PointerMoved{{90, 90}, {}});
  EXPECT_EQ(feed_.take_frame(io(), kOne).size(), 6U);
  EXPECT_EQ(io().MousePos.x, 5);
  feed_.take_frame(io(), kOne);
  EXPECT_EQ(io().MousePos.x, 90);
}

TEST_F(InputFeedTest, TurnsWindowCoordinatesIntoPixels) {
  feed_.push(PointerMoved{{10, 20}, {}});
  feed_.take_frame(io(), {2, 3});
  EXPECT_EQ(io().MousePos.x, 20);
  EXPECT_EQ(io().MousePos.y, 60);
}

TEST_F(InputFeedTest, LetsEverythingGoWhenTheWindowLosesTheKeyboard) {
  feed_.push(ModifiersHeld{{.shift = true}});
  feed_.push(KeyPressed{Key::a, {.shift = true}, false});
  feed_.push(PointerPressed{Button::left, {1, 1}, {.shift = true}});
  feed_.push(FocusLost{});
  while (!feed_.is_empty()) feed_.take_frame(io(), kOne);
  EXPECT_FALSE(io().MouseDown[0]);
  EXPECT_FALSE(io().KeysDown[static_cast<int>(Key::a)]);
  EXPECT_EQ(feed_.modifiers(), Modifiers{});
}

}  // namespace
}  // namespace foldless

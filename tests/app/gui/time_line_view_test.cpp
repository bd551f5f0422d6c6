// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the time line is in sight, and how high it is: the whole editor off screen.
#include <gtest/gtest.h>

#include "app/gui/easing_curve.h"
#include "app/gui/proof_badge.h"
#include "app/gui/settings.h"
#include "app/gui/time_line_place.h"
#include "tests/app/gui/animated_bar.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

constexpr Modifiers kAlt{.alt = true};

class TimeLineViews : public testing::Test {
 protected:
  TimeLineViews() { open_animated_bar(headless_); }

  Motion& motion() { return headless_.editor().motion(); }
  const Layout& layout() { return headless_.ui().layout(); }
  TimeLinePlace place() {
    return time_line_place(layout().timeline, 1, motion().animation().cycle, {});
  }
  Vec2 ruler(double frame) { return {place().x_of(frame), place().area.y + 6}; }
  void turn_wheel(const Vec2& at, double notches, Modifiers modifiers) {
    headless_.hold(modifiers);
    headless_.move(at);
    headless_.ui().receive(InputEvent(WheelTurned{notches, at}));
    headless_.settle();
    headless_.hold({});
  }
  int frame_at_ruler(double x) {
    headless_.click({x, place().area.y + 6});
    headless_.settle();
    return motion().play_head().frame();
  }
  void drag(const Vec2& from, const Vec2& to) {
    headless_.press(from);
    headless_.move(from + (to - from) / 2);
    headless_.move(to);
    headless_.release(to);
    headless_.settle();
  }

  TemporaryFolder folder_;
  HeadlessEditor headless_{{1280, 800}, {.state_folder = folder_.path()}};
};

TEST_F(TimeLineViews, WithAltThePlayHeadGoesBetweenFrames) {
  headless_.hold(kAlt);
  headless_.press(ruler(7));
  headless_.move(ruler(7.5));
  headless_.settle();
  headless_.release(ruler(7.5));
  headless_.hold({});
  headless_.settle();
  EXPECT_NEAR(motion().play_head().moment(), 7.5, 0.05);
  EXPECT_NE(motion().play_head().moment(), motion().play_head().frame());
  ASSERT_TRUE(headless_.wait_until([this] { return motion().solved() != nullptr; }));
  headless_.settle();
  EXPECT_EQ(headless_.editor().shown()->deformed, motion().solved()->snapshot->deformed);
  EXPECT_TRUE(headless_.find_words(moment_words(motion().play_head().moment())));
  drag(ruler(7.5), ruler(9.6));
  EXPECT_EQ(motion().play_head().moment(), 10) << "without Alt it snaps";
}

TEST_F(TimeLineViews, StatusAndBadgeSpeakOfTheWholeAnimation) {
  using State = MotionProofStatus::State;
  ASSERT_TRUE(headless_.wait_until([this] { return motion().proof().state == State::proved; }));
  headless_.settle();
  const std::string words = motion_badge_words(motion().proof(), 500);
  EXPECT_EQ(words.find("25 frames and every moment between them injective"), 0U) << words;
  EXPECT_EQ(motion_badge_words(motion().proof(), 1), "every moment injective");
  const std::string status = headless_.editor().status().words;
  EXPECT_NE(status.find("every moment of the animation proved injective"), std::string::npos);
  EXPECT_TRUE(headless_.find_words(status)) << status;
  MotionProofStatus other = motion().proof();
  other.state = State::unproved;
  other.problem = "triangle 12 has no area at frame 3.5";
  EXPECT_EQ(motion_badge_words(other, 500), "Not proved: triangle 12 has no area at frame 3.5");
  other.state = State::running;
  EXPECT_EQ(motion_badge_words(other, 500), "Proving every moment between 25 frames…");
  headless_.key(Key::t);
  headless_.settle();
  EXPECT_FALSE(headless_.find_words(status)) << "of the newest state alone";
}

TEST_F(TimeLineViews, ControlAndTheWheelZoomAboutThePointerAndShiftScrolls) {
  const double x = place().x_of(12);
  for (int i = 0; i < 4; ++i) turn_wheel({x, place().y_of(0)}, 1, kControl);
  EXPECT_EQ(frame_at_ruler(x), 12) << "what is under the pointer stays";
  const double quarter = place().width() / 4;
  const int right = frame_at_ruler(x + quarter);
  EXPECT_LT(right, 12 + 4) << "of the 6 that it was";
  EXPECT_GT(right, 12);
  turn_wheel({x, place().y_of(0)}, -2, {.shift = true});
  EXPECT_GT(frame_at_ruler(x), 12);
  for (int i = 0; i < 9; ++i) turn_wheel({x, place().y_of(0)}, -1, kControl);
  EXPECT_EQ(frame_at_ruler(x), 12) << "all frames are in sight again";
}

TEST_F(TimeLineViews, ThePlayHeadComesIntoSightWhenItIsMovedByKeys) {
  const double x = place().x_of(2);
  for (int i = 0; i < 6; ++i) turn_wheel({x, place().y_of(0)}, 1, kControl);
  headless_.key(Key::period, {.shift = true});
  headless_.settle();
  EXPECT_EQ(motion().play_head().frame(), 24);
  EXPECT_EQ(frame_at_ruler(place().left() + place().width()), 24);
  EXPECT_GT(frame_at_ruler(place().left()), 15);
}

TEST_F(TimeLineViews, KeysAreCaughtWhereTheyAreSeen) {
  const double x = place().x_of(10);
  for (int i = 0; i < 4; ++i) turn_wheel({x, place().y_of(0)}, 1, kControl);
  headless_.click({x, place().y_of(0)});
  headless_.settle();
  ASSERT_EQ(motion().keys().selected().size(), 1U);
  EXPECT_EQ(motion().keys().selected().begin()->frame, 10);
}

TEST_F(TimeLineViews, ItsUpperEdgeIsDraggedAndTheHeightRemembered) {
  const Rectangle before = layout().timeline;
  drag({before.x + 500, before.y - 3}, {before.x + 500, before.y - 63});
  EXPECT_NEAR(layout().timeline.height, before.height + 60, 2);
  EXPECT_NEAR(layout().timeline.y, before.y - 60, 2);
  EXPECT_EQ(headless_.ui().cursor(), CursorShape::resize_height);
  EXPECT_NEAR(headless_.ui().settings().time_line_height, kTimeLineHeight + 60, 2);
  const Rectangle edge = layout().timeline;
  drag({edge.x + 500, edge.y - 3}, {edge.x + 500, edge.y + 1000});
  EXPECT_EQ(headless_.ui().settings().time_line_height, kLowestTimeLine);
  const Rectangle low = layout().timeline;
  for (int i = 0; i < 2; ++i) headless_.click({low.x + 500, low.y - 3});
  headless_.settle();
  EXPECT_EQ(headless_.ui().settings().time_line_height, kTimeLineHeight);
  Settings settings;
  settings.time_line_height = 222;
  save_settings(settings_file(folder_.path()), settings);
  EXPECT_EQ(load_settings(settings_file(folder_.path())).time_line_height, 222);
}

TEST_F(TimeLineViews, TheEndsOfAnEasingCurveArePulledInOneStep) {
  headless_.click({place().x_of(10), place().y_of(0)});
  headless_.settle();
  ASSERT_TRUE(headless_.find_words("Linear"));
  headless_.click(*headless_.find_words("Linear"));
  headless_.settle();
  const auto label = headless_.find_words("Pull the ends of the curve:");
  ASSERT_TRUE(label);
  const std::size_t steps = headless_.editor().draft().history().steps().size();
  const auto easing = [&] { return motion().animation().tracks[0].position[1].easing; };
  const Vec2 lower_left = *label + Vec2(-60, 125);  // nearer to the first end
  headless_.press(lower_left);
  headless_.move(lower_left + Vec2(20, -20));
  EXPECT_EQ(easing(), Easing{}) << "not before the end";
  headless_.release(lower_left + Vec2(20, -20));
  headless_.settle();
  const Easing once = easing();
  EXPECT_GT(once.first.x(), 0.1);
  EXPECT_EQ(once.second, Vec2(1, 1));
  EXPECT_EQ(headless_.editor().draft().history().steps().size(), steps + 1);
  drag(lower_left + Vec2(20, -20), lower_left + Vec2(50, -38));
  EXPECT_NEAR(easing().first.x() - once.first.x(), 30 / kCurveWidth, 1e-5);
  EXPECT_NEAR(easing().first.y() - once.first.y(), 18 / kCurveHeight, 1e-5);
  EXPECT_EQ(headless_.editor().draft().history().steps().size(), steps + 2);
}

}  // namespace
}  // namespace foldless::test

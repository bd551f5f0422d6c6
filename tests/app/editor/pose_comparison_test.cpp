// SPDX-License-Identifier: GPL-3.0-or-later
// Other poses to compare with, by keys.
#include "app/editor/pose_comparison.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

class Comparing : public EditorTest {
 protected:
  Comparing() {
    open_grid(5);
    place(0);
    id_ = place(24);
    settle();
  }
  void pull() {
    drag(pixel_of_handle(id_), pixel_of_handle(id_) + Vec2(-40, 60));
    settle();
  }
  PoseComparison& comparison() { return editor_->comparison(); }

  int id_ = 0;
};

TEST_F(Comparing, ThePoseThatWasKeptIsSeenAsLongAsTheKeyIsHeld) {
  EXPECT_FALSE(comparison().kept()) << "the rest shape, then";
  key(Key::backslash, kShift);
  const auto kept = comparison().kept();
  ASSERT_TRUE(kept);
  const Points before = kept->deformed;
  pull();
  EXPECT_EQ(comparison().kept()->deformed, before);
  EXPECT_NE(editor_->shown()->deformed, before);
  editor_->receive(KeyPressed{Key::backslash, {}, false}, now_);
  EXPECT_TRUE(comparison().is_held());
  editor_->receive(KeyReleased{Key::backslash}, now_);
  EXPECT_FALSE(comparison().is_held());
  EXPECT_TRUE(editor_->run_command("compare.forget"));
  EXPECT_FALSE(comparison().kept());
}

TEST_F(Comparing, IsOverWhenTheWindowLosesTheKeyboard) {
  editor_->receive(KeyPressed{Key::backslash, {}, false}, now_);
  editor_->receive(FocusLost{}, now_);
  EXPECT_FALSE(comparison().is_held());
}

TEST_F(Comparing, OutlinesOfPosesAreAddedAndTakenAway) {
  key(Key::o);
  ASSERT_EQ(comparison().outlines().size(), 1U);
  EXPECT_EQ(comparison().outlines()[0]->size(), 1U) << "one boundary";
  EXPECT_EQ(comparison().outlines()[0]->front().cols(), 16);
  pull();
  key(Key::o);
  ASSERT_EQ(comparison().outlines().size(), 2U);
  key(Key::o);
  EXPECT_EQ(comparison().outlines().size(), 1U) << "that of this pose is gone";
  key(Key::o, kShift);
  EXPECT_FALSE(comparison().has_outlines());
}

TEST_F(Comparing, AllIsForgottenWithTheMesh) {
  key(Key::backslash, kShift);
  key(Key::o);
  open_grid(4);
  EXPECT_FALSE(comparison().kept());
  EXPECT_FALSE(comparison().has_outlines());
  key(Key::o);
  EXPECT_EQ(comparison().outlines().size(), 1U);
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
// What the badge draws of a whole animation: its words, the mark before them, the yellow behind.
#include "app/gui/proof_badge.h"

#include <gtest/gtest.h>

#include "app/gui/theme.h"
#include "tests/app/gui/animated_bar.h"
#include "tests/app/gui/drawing_defects.h"

namespace foldless::test {
namespace {

using State = MotionProofStatus::State;

bool is_drawn_in(const ImVec4& colour) {
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int i = 0; i < drawn.CmdListsCount; ++i)
    for (const ImDrawVert& vertex : drawn.CmdLists[i]->VtxBuffer)
      if (vertex.col == packed(colour)) return true;
  return false;
}

class MotionBadge : public testing::Test {
 protected:
  /// The badge alone, of an animation in that state.
  void draw(State state, const Proof& of_frame = {}) {
    headless_.calm_down();
    MotionProofStatus motion;
    motion.state = state;
    motion.frames = 25;
    motion.vertices = 60;
    motion.deviation = 0.25;
    if (state == State::unproved) motion.problem = "triangle 12 has no area at frame 3.5";
    Look look;
    look.palette = &palette_;
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({20, 20});
    ImGui::SetNextWindowSize({700, 60});
    ImGui::Begin("##tested", nullptr, ImGuiWindowFlags_NoDecoration);
    ImGui::TextUnformatted("Ready");
    draw_proof_badge(of_frame, motion, 600, look);
    ImGui::End();
    ImGui::Render();
    EXPECT_TRUE(drawing_defects().empty()) << drawing_defects().front();
  }
  void expect(const std::string& words, bool is_good, bool is_busy) {
    EXPECT_TRUE(headless_.find_words(words)) << words;
    EXPECT_EQ(is_drawn_in(palette_.good), is_good && !is_busy) << words;
    EXPECT_EQ(is_drawn_in(palette_.busy), is_busy) << words;
    EXPECT_EQ(is_drawn_in(palette_.caution), !is_good) << words;
  }

  HeadlessEditor headless_;
  const Palette& palette_ = dark_palette();
};

TEST_F(MotionBadge, OfAProvedAnimationHasATick) {
  draw(State::proved);
  expect("25 frames and every moment between them injective  ·  60 vertices, 0.25 px off at most",
         true, false);
}

TEST_F(MotionBadge, HasARingWhileItIsBeingProved) {
  draw(State::running);
  expect("Proving every moment between 25 frames…", true, true);
}

TEST_F(MotionBadge, NamesTheMomentThatIsNotProvedOnYellow) {
  draw(State::unproved);
  expect("Not proved: triangle 12 has no area at frame 3.5", false, false);
}

TEST_F(MotionBadge, SpeaksOfAFrameThatFoldsFirst) {
  Proof folded;
  folded.inverted = 3;
  folded.triangles = 40;
  draw(State::proved, folded);
  expect(badge_words(folded, 580), false, false);
}

TEST_F(MotionBadge, IsInTheStatusBarOfTheWholeEditorAsLongAsTheTimeLineIsOpen) {
  open_animated_bar(headless_);
  const Motion& motion = headless_.editor().motion();
  ASSERT_TRUE(headless_.wait_until([&] { return motion.proof().state == State::proved; }));
  headless_.settle();
  const std::string words = motion_badge_words(motion.proof(), 1000);
  EXPECT_TRUE(headless_.find_words(words)) << words;
  EXPECT_EQ(words.find("25 frames and every moment between them injective"), 0U);
  headless_.key(Key::t);
  headless_.calm_down();
  EXPECT_FALSE(headless_.find_words(words));
}

}  // namespace
}  // namespace foldless::test

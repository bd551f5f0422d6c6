// SPDX-License-Identifier: GPL-3.0-or-later
// Which limb is in front, by mouse and keys: state and pixels.
#include <gtest/gtest.h>

#include "core/scene/scene_io.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/ribbon_scene.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// A ribbon that crosses itself, open in the editor.
class Depth : public testing::Test {
 protected:
  Depth() {
    save_scene(crossing_scene(), folder_.path() / "ribbon.json");
    editor().files().open(folder_.path() / "ribbon.json");
    headless_.calm_down();
  }

  Editor& editor() { return headless_.editor(); }
  double depth(std::size_t handle) { return editor().document().handles[handle].depth; }
  void click_handle(std::size_t handle) {
    const int vertex = editor().document().handles[handle].vertex;
    headless_.click(headless_.window_point(headless_.position(vertex)));
  }
  /// The canvas, nothing selected.
  Image picture() {
    headless_.key(Key::escape);
    headless_.calm_down();
    return headless_.canvas_picture();
  }

  TemporaryFolder folder_;
  HeadlessEditor headless_;  // wide enough for both side panels
};

TEST_F(Depth, BracketsBringALimbForwardAndSendItBack) {
  ASSERT_FALSE(editor().document().is_empty());
  const Image right_in_front = picture();
  click_handle(0);
  headless_.key(Key::right_bracket);
  EXPECT_EQ(depth(0), 1);
  const Image left_in_front = picture();
  EXPECT_GT(differing_pixels(right_in_front, left_in_front), 200);
  click_handle(0);
  headless_.key(Key::left_bracket);
  headless_.key(Key::left_bracket);
  EXPECT_EQ(depth(0), -1);
  EXPECT_EQ(differing_pixels(right_in_front, picture()), 0);
}

TEST_F(Depth, UndoShowsTheLimbsAsTheyWere) {
  const Image before = picture();
  click_handle(0);
  headless_.key(Key::right_bracket);
  headless_.key(Key::z, {.control = true});
  EXPECT_EQ(differing_pixels(before, picture()), 0);
}

TEST_F(Depth, OverlaysHiddenOneLimbIsStillWhole) {
  click_handle(0);
  headless_.key(Key::right_bracket);
  headless_.key(Key::escape);
  headless_.calm_down();
  editor().view().hide_overlays(true);
  headless_.settle();
  const Image left_in_front = headless_.canvas_picture();
  editor().view().hide_overlays(false);
  click_handle(0);
  headless_.key(Key::left_bracket);
  headless_.key(Key::left_bracket);
  headless_.key(Key::escape);
  headless_.calm_down();
  editor().view().hide_overlays(true);
  headless_.settle();
  EXPECT_GT(differing_pixels(left_in_front, headless_.canvas_picture()), 100);
}

TEST_F(Depth, TheFieldOfTheSelectedHandlesTakesANumberWithEnter) {
  editor().selection().select({0, 1});
  headless_.settle();
  const auto words = headless_.find_words("Depth");
  ASSERT_TRUE(words);
  headless_.click(*words + Vec2(80, 5));
  headless_.key(Key::a, {.control = true});
  headless_.type("2.5");
  headless_.key(Key::enter);
  EXPECT_EQ(depth(0), 2.5);
  EXPECT_EQ(depth(1), 2.5) << "of all selected handles";
}

TEST_F(Depth, IsInTheSearchOfCommands) {
  click_handle(1);
  headless_.key(Key::k, {.control = true});
  headless_.type("send ba");
  headless_.key(Key::enter);
  EXPECT_EQ(depth(1), -1);
}

}  // namespace
}  // namespace foldless::test

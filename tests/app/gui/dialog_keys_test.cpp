// SPDX-License-Identifier: GPL-3.0-or-later
// One rule for the keys of dialogs, menus and combo boxes: the whole editor off screen.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "app/gui/race_layout.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

constexpr Modifiers kHeldControl{.control = true};

/// A dialog, a menu or a list is open.
bool has_popup() {
  return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool is_shown(const char* name) {
  const ImGuiWindow* window = ImGui::FindWindowByName(name);
  return window && window->WasActive;
}

class DialogKeysTest : public testing::Test {
 protected:
  DialogKeysTest() {
    editor().files().open_shape(bar(4, 1, 2), "bar");
    headless_.calm_down();
  }

  Editor& editor() { return headless_.editor(); }
  void open_race() {
    headless_.click(headless_.window_point({0, 0.5}));
    headless_.key(Key::m);
    ASSERT_TRUE(editor().race().is_open());
    ASSERT_TRUE(headless_.wait_until([this] { return editor().race().is_finished(); }));
  }
  Vec2 first_combo_of_race() {
    const auto layout =
        race_layout_for(headless_.ui().layout().canvas, editor().race().lanes().size(), 1);
    return {layout.setup.x + 40, layout.setup.y + 18};
  }
  /// As a desktop sends it while a key is held: repeats, and time that passes.
  void hold(Key key) {
    for (int i = 0; i < 30; ++i) {
      headless_.ui().receive(KeyPressed{key, {}, true});
      headless_.settle();
    }
  }
  void press(Key key) {
    headless_.ui().receive(KeyPressed{key, {}, false});
    headless_.settle();
  }

  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(DialogKeysTest, WhatIsBehindADialogIsDarkAtOnceAndLightAtOnce) {
  const Image light = headless_.picture();
  headless_.key(Key::f1);
  const Image dark = headless_.picture();
  EXPECT_GT(differing_pixels(light, dark), 400000);
  hold(Key::b);  // many frames
  EXPECT_EQ(differing_pixels(dark, headless_.picture()), 0);
  headless_.key(Key::escape);
  EXPECT_EQ(differing_pixels(light, headless_.picture()), 0);
}

TEST_F(DialogKeysTest, EscapeClosesTheComboBoxThenTheRace) {
  open_race();
  headless_.calm_down();
  const Image before = headless_.picture();
  headless_.click(first_combo_of_race());
  ASSERT_TRUE(has_popup());
  headless_.key(Key::escape);
  EXPECT_FALSE(has_popup());
  EXPECT_TRUE(editor().race().is_open());
  headless_.calm_down();
  EXPECT_EQ(differing_pixels(before, headless_.picture()), 0);
  headless_.key(Key::escape);
  EXPECT_FALSE(editor().race().is_open());
}

TEST_F(DialogKeysTest, EscapeClosesTheListOfCurves) {
  const Rectangle panel = headless_.ui().layout().right;
  for (float y = panel.y + panel.height - 4; y > panel.y && !has_popup(); y -= 8)
    headless_.click({panel.x + 40, y});
  ASSERT_TRUE(has_popup());
  headless_.key(Key::escape);
  EXPECT_FALSE(has_popup());
}

TEST_F(DialogKeysTest, EscapeClosesAMenuWithItsSubmenu) {
  headless_.click({20, 10});
  ASSERT_TRUE(has_popup());
  const Image menu = headless_.picture();
  for (float y = 300; y < 500 && differing_pixels(menu, headless_.picture()) < 3000; y += 8)
    headless_.move({60, y});
  ASSERT_GT(differing_pixels(menu, headless_.picture()), 3000) << "a submenu should have opened";
  headless_.key(Key::escape);
  EXPECT_FALSE(has_popup());
}

TEST_F(DialogKeysTest, EscapeClosesTheSheetOfKeysAndF1OpensItAgain) {
  headless_.key(Key::f1);
  EXPECT_TRUE(has_popup());
  headless_.key(Key::escape);
  EXPECT_FALSE(has_popup());
  headless_.key(Key::f1);
  EXPECT_TRUE(has_popup());
  headless_.key(Key::f1);
  EXPECT_FALSE(has_popup());
}

TEST_F(DialogKeysTest, EscapeInTheDialogOfARaceLeavesTheRaceOpen) {
  open_race();
  editor().run_command("file.export_table");
  headless_.settle();
  ASSERT_TRUE(has_popup());
  headless_.key(Key::escape);
  EXPECT_FALSE(has_popup());
  EXPECT_TRUE(editor().race().is_open());
}

TEST_F(DialogKeysTest, TheEnterThatOpenedADialogAndIsHeldDoesNotTakeIt) {
  headless_.key(Key::k, kHeldControl);
  headless_.type("file: export");
  press(Key::enter);
  ASSERT_TRUE(is_shown("##export"));
  hold(Key::enter);
  EXPECT_TRUE(is_shown("##export"));
  headless_.ui().receive(KeyReleased{Key::enter});
  headless_.key(Key::enter);
  EXPECT_TRUE(is_shown("##file browser"));
}

TEST_F(DialogKeysTest, EscapeTakesOneThingAPress) {
  headless_.click(headless_.window_point({0, 0.5}));
  headless_.key(Key::q, kHeldControl);
  ASSERT_NE(editor().files().question(), nullptr);
  headless_.key(Key::enter);
  ASSERT_TRUE(has_popup()) << "where to save";
  press(Key::escape);
  hold(Key::escape);
  EXPECT_FALSE(has_popup());
  EXPECT_FALSE(editor().selection().ids().empty()) << "the handle is still selected";
  headless_.ui().receive(KeyReleased{Key::escape});
  headless_.key(Key::escape);
  EXPECT_TRUE(editor().selection().ids().empty());
}

TEST_F(DialogKeysTest, PageAndHomeKeysWorkInTheListOfCommands) {
  headless_.key(Key::k, kHeldControl);
  const Image first = headless_.picture();
  headless_.key(Key::page_down);
  EXPECT_GT(differing_pixels(first, headless_.picture()), 1000);
  headless_.key(Key::end);
  headless_.key(Key::home);
  EXPECT_LT(differing_pixels(first, headless_.picture()), 100) << "but for the text cursor";
}

}  // namespace
}  // namespace foldless::test

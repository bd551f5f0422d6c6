// SPDX-License-Identifier: GPL-3.0-or-later
// The list of undo steps, with the mouse.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

TEST(HistoryPanel, AClickOnAStepGoesBackToItAndForward) {
  HeadlessEditor headless;
  Editor& editor = headless.editor();
  editor.files().open_shape(bar(4, 1, 2), "bar");
  headless.calm_down();
  headless.click(headless.window_point({0, 0.5}));
  headless.key(Key::k);
  ASSERT_EQ(editor.document().handles.at(0).kind, HandleKind::pin);
  headless.calm_down();
  const auto click = [&headless](const char* step) {
    headless.click(headless.find_words(step).value());
  };
  click("Place handle");
  EXPECT_EQ(editor.document().handles.at(0).kind, HandleKind::drag);
  click("Open bar");
  EXPECT_TRUE(editor.document().handles.empty());
  click("Pin or drag");
  EXPECT_EQ(editor.document().handles.at(0).kind, HandleKind::pin);
}

/// A harness that watches for words that are cut looks at it meanwhile.
TEST(HistoryPanel, ALongStepIsShortenedAndHasATooltip) {
  const std::string name = "a_name_of_a_drawing_that_is_longer_than_any_panel_has_room_for";
  HeadlessEditor headless;
  headless.editor().files().open_shape(bar(4, 1, 2), name);
  headless.calm_down();
  EXPECT_FALSE(headless.find_words("Open " + name).has_value());
  const auto title = headless.find_words("History");
  ASSERT_TRUE(title.has_value());
  headless.move(*title + Vec2(30, 26));
  EXPECT_TRUE(headless.wait_until([] {
    const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
    return tip && tip->WasActive && !tip->Hidden;
  }));
}

}  // namespace
}  // namespace foldless::test

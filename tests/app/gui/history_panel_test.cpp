// SPDX-License-Identifier: GPL-3.0-or-later
// The list of undo steps, with the mouse.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace foldless::test

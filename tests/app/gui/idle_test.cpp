// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that would be like the one on screen are not drawn.
#include <gtest/gtest.h>
#include <imgui.h>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class Idle : public testing::Test {
 protected:
  Idle() {
    editor().files().open_shape(bar(4, 1, 3), "bar");
    headless_.calm_down();
    headless_.move(kBare);
    headless_.calm_down();
  }
  Editor& editor() { return headless_.editor(); }
  int drawn_by(const std::function<void()>& action) {
    const int before = headless_.drawn_frames();
    action();
    headless_.settle();
    return headless_.drawn_frames() - before;
  }

  static inline const Vec2 kBare{500, 150};  ///< of the canvas, beside the mesh
  HeadlessEditor headless_{{1280, 720}};
};

TEST_F(Idle, APointerOverTheBareCanvasDrawsNothing) {
  EXPECT_EQ(drawn_by([this] {
              for (int i = 1; i < 20; ++i) headless_.move(kBare + Vec2(i, i));
            }),
            0);
}

TEST_F(Idle, AnOpenTextFieldAsksForNoFrames) {
  headless_.key(Key::k, {.control = true});
  headless_.calm_down();
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(headless_.ui().next_frame(editor(), 1000), std::nullopt);
}

TEST_F(Idle, WhateverChangesThePictureIsDrawn) {
  EXPECT_GT(drawn_by([this] { headless_.key(Key::digit_2); }), 0) << "a layer";
  EXPECT_GT(drawn_by([this] { headless_.ui().receive(WheelTurned{1, kBare}); }), 0) << "the zoom";
  EXPECT_GT(drawn_by([this] { headless_.click(headless_.window_point({0, 0})); }), 0) << "a handle";
  EXPECT_GT(drawn_by([this] { headless_.ui().settings().theme = Theme::light; }), 0) << "a theme";
  EXPECT_GT(drawn_by([this] { headless_.move(headless_.window_point({0, 0})); }), 0) << "hovering";
}

}  // namespace
}  // namespace foldless::test

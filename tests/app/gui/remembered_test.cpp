// SPDX-License-Identifier: GPL-3.0-or-later
// What stays as the user left it: from one start to the next, and when the window changes.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "app/editor/parameter_rows.h"
#include "core/data_path.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class Remembered : public testing::Test {
 protected:
  Remembered() { start(); }

  void start() {
    headless_.reset();
    UiOptions options;
    options.state_folder = folder_.path();
    headless_.emplace(Extent{1280, 800}, options);
    open_grid();
  }
  void open_grid(double unit = 1) {
    Fixture grid = square_grid(6);
    editor().files().open_shape(Shape{std::move(grid.triangles), unit * grid.rest}, "grid");
    headless_->calm_down();
  }
  Editor& editor() { return headless_->editor(); }
  const Layers& layers() { return editor().view().options().layers; }

  TemporaryFolder folder_;
  std::optional<HeadlessEditor> headless_;
};

TEST_F(Remembered, LayersAndPace) {
  headless_->key(Key::digit_2);
  headless_->key(Key::digit_4);
  editor().playback().set_pace(20);
  headless_->settle();
  start();
  EXPECT_FALSE(layers().wireframe);
  EXPECT_TRUE(layers().heat);
  EXPECT_EQ(editor().playback().pace(), 20);
}

TEST_F(Remembered, SectionsThatAreClosed) {
  const Rectangle left = headless_->ui().layout().left;
  const Image open = headless_->picture();
  headless_->click({left.x + 60, left.y + 20});
  headless_->calm_down();
  const Image closed = headless_->picture();
  EXPECT_GT(differing_pixels(open, closed), 1000);
  start();
  EXPECT_EQ(differing_pixels(closed, headless_->picture()), 0);
}

TEST_F(Remembered, AViewThatWasFittedIsFittedAgainAndOneThatWasMovedIsNot) {
  const double fitted = editor().canvas().camera.pixels_per_unit;
  headless_->ui().settings().shows_panels = false;
  headless_->settle();
  const Camera wide = editor().canvas().camera;
  editor().view().fit_all();
  EXPECT_EQ(editor().canvas().camera, wide);
  headless_->ui().settings().scale = 1.5;
  headless_->settle();
  EXPECT_LT(editor().canvas().camera.pixels_per_unit, fitted);

  editor().view().zoom(3);
  const Camera moved = editor().canvas().camera;
  headless_->ui().settings().shows_panels = true;
  headless_->settle();
  EXPECT_EQ(editor().canvas().camera, moved);
}

TEST_F(Remembered, AParameterIsResetByItsButton) {
  const ParameterRow* alpha = nullptr;
  for (const ParameterRow& row : parameter_rows())
    if (row.name == "inner_iterations") alpha = &row;
  ASSERT_NE(alpha, nullptr);
  editor().edits().set_method("paper-flip");
  const double before = alpha->get(editor().document().parameters, *editor().document().energy);
  const auto value = [&] {
    return alpha->get(editor().document().parameters, *editor().document().energy);
  };
  editor().edits().set_parameter(*alpha, 7);
  headless_->settle();
  // Nothing but reset buttons is that far to the right.
  const Rectangle right = headless_->ui().layout().right;
  for (float y = right.y + 80; y < right.y + 400 && value() == 7; y += 11)
    headless_->click({right.x + right.width - 18, y});
  EXPECT_EQ(value(), before);
}

TEST_F(Remembered, ASentenceThatWasClosedStaysClosed) {
  editor().files().open_sample(data_path("assets/scenes/welcome.json"));
  headless_->calm_down();
  ASSERT_FALSE(editor().document().description.empty());
  const Image with_sentence = headless_->canvas_picture();
  const Rectangle canvas = headless_->ui().layout().canvas;
  const std::size_t handles = editor().document().handles.size();
  // Its cross is at the right end; what is beyond is the canvas, where a click does nothing here.
  const float middle = canvas.x + canvas.width / 2;
  for (float x = middle + 310; x > middle + 100; x -= 7) headless_->click({x, canvas.y + 20});
  EXPECT_EQ(editor().document().handles.size(), handles);
  headless_->calm_down();
  EXPECT_GT(differing_pixels(with_sentence, headless_->canvas_picture()), 200);
}

TEST_F(Remembered, TheUnitOfLengthDoesNotShow) {
  headless_->ui().settings().shows_panels = false;
  headless_->settle();
  const Image one = headless_->canvas_picture();
  for (const double unit : {1e-60, 1e-9, 1e9, 1e60}) {
    open_grid(unit);
    EXPECT_LT(differing_pixels(one, headless_->canvas_picture()), 300) << unit;
  }
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Lost work is offered and taken, by mouse and keys: state and pixels.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/gui/preview.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/meshes.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class RecoveryDialog : public testing::Test {
 protected:
  EditorOptions options() const { return {.state_folder = folder_.path(), .wake = {}}; }
  /// Work of a program that has ended without being asked to.
  void lose(int size, const std::string& name, const std::filesystem::path& texture = {}) {
    Editor editor(options());
    editor.view().resize(400, 400, 1);
    Fixture grid = square_grid(size);
    editor.files().open_shape(Shape{std::move(grid.triangles), std::move(grid.rest)}, name);
    if (!texture.empty()) editor.files().set_texture(texture);
    const Vec2 at = editor.canvas().to_pixel(editor.shown()->deformed.col(0));
    editor.receive(PointerPressed{Button::left, at, {}}, 0);
    editor.receive(PointerReleased{Button::left, at, {}}, 0);
    editor.files().rescue();
  }
  void start() {
    headless_.emplace(Extent{1000, 640}, UiOptions{}, options());
    headless_->editor().files().recovery().find();
    ASSERT_TRUE(recovery().is_open());
    wait_until_read();
  }
  void wait_until_read() {
    ASSERT_TRUE(headless_->wait_until([this] { return recovery().work() != nullptr; }));
  }
  Editor& editor() { return headless_->editor(); }
  const Recovery& recovery() { return editor().files().recovery(); }

  TemporaryFolder folder_;
  std::optional<HeadlessEditor> headless_;
};

TEST_F(RecoveryDialog, ShowsTheWorkOnTheCanvasAndEnterTakesIt) {
  lose(5, "grid");
  headless_.emplace(Extent{1000, 640}, UiOptions{}, options());
  const Image before = headless_->canvas_picture();
  editor().files().recovery().find();
  wait_until_read();
  EXPECT_GT(differing_pixels(before, headless_->canvas_picture()), 20000);
  EXPECT_TRUE(editor().document().is_empty());
  headless_->key(Key::enter);
  EXPECT_FALSE(recovery().is_open());
  EXPECT_EQ(editor().document().handles.size(), 1U);
  EXPECT_TRUE(editor().files().is_dirty());
}

TEST_F(RecoveryDialog, OfADrawingThePictureAloneIsSeen) {
  write_ring(folder_ / "ring.png", 60);
  lose(5, "drawing", folder_ / "ring.png");
  start();
  EXPECT_FALSE(preview_of(editor())->layers.boundary);
  EXPECT_FALSE(preview_of(editor())->layers.wireframe);
}

TEST_F(RecoveryDialog, ArrowKeysChooseAmongSeveral) {
  lose(5, "older");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  lose(3, "newer");
  start();
  ASSERT_EQ(recovery().count(), 2U);
  EXPECT_EQ(recovery().origin(0).name, "newer");
  const Image newer = headless_->canvas_picture();
  headless_->key(Key::down);
  wait_until_read();
  EXPECT_GT(differing_pixels(newer, headless_->canvas_picture()), 1000);
  headless_->key(Key::enter);
  EXPECT_EQ(editor().document().name, "older");
}

TEST_F(RecoveryDialog, EscapeLeavesItForLater) {
  lose(5, "grid");
  start();
  headless_->key(Key::escape);
  EXPECT_FALSE(recovery().is_open());
  headless_->calm_down();
  editor().run_command("file.recover");
  EXPECT_TRUE(recovery().is_open());
}

TEST_F(RecoveryDialog, DiscardAsksFirst) {
  lose(5, "grid");
  start();
  const Vec2 discard{830, 594};
  headless_->click(discard);
  headless_->key(Key::escape);
  EXPECT_TRUE(recovery().is_open()) << "the question was left, not the dialog";
  headless_->click(discard);
  headless_->key(Key::enter);
  EXPECT_TRUE(recovery().is_open()) << "Enter keeps it";
}

TEST_F(RecoveryDialog, TheMouseDoesNotReachTheDocumentBehindIt) {
  lose(5, "grid");
  start();
  headless_->click({300, 300});
  EXPECT_TRUE(editor().document().handles.empty());
  EXPECT_TRUE(recovery().is_open());
}

}  // namespace
}  // namespace foldless::test

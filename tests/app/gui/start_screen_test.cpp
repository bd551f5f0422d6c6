// SPDX-License-Identifier: GPL-3.0-or-later
// What there is while nothing is open: cards of recent files and samples.
#include "app/gui/start_screen.h"

#include <gtest/gtest.h>

#include "app/gui/samples.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

// Of the first card, in design pixels: see the pictures of the interface.
const Vec2 kFirstCard(210, 280);

class StartScreen : public testing::Test {
 protected:
  explicit StartScreen() : headless_({1280, 800}, {}, {.state_folder = state_.path()}) {}

  Editor& editor() { return headless_.editor(); }
  bool wait_for_pictures() {
    return headless_.wait_until([this] { return !headless_.next_frame(); });
  }

  TemporaryFolder state_;
  HeadlessEditor headless_;
};

TEST_F(StartScreen, OpensASampleWithAClickOnItsCard) {
  headless_.click(kFirstCard);
  EXPECT_EQ(editor().document().name, "welcome");
  EXPECT_TRUE(editor().files().path().empty()) << "a copy";
}

TEST_F(StartScreen, ShowsPicturesOfTheSamples) {
  const Image without = headless_.picture();
  ASSERT_TRUE(wait_for_pictures());
  EXPECT_GT(differing_pixels(without, headless_.picture()), 20000);
}

TEST_F(StartScreen, OffersRecentFilesBeforeTheSamples) {
  const Shape shape = disk({});
  const TemporaryFolder folder;
  write_mesh(folder / "mine.obj", shape.triangles, shape.rest);
  editor().files().open(folder / "mine.obj");
  headless_.key(Key::n, kControl);
  ASSERT_TRUE(editor().document().is_empty());
  ASSERT_TRUE(wait_for_pictures());
  const Image disk_shown = headless_.picture();
  const Shape other = bar(4, 1, 3);
  write_mesh(folder / "mine.obj", other.triangles, other.rest);
  headless_.move({5, 5});
  ASSERT_TRUE(wait_for_pictures());
  EXPECT_GT(differing_pixels(disk_shown, headless_.picture()), 1000) << "the file has changed";
  headless_.click(kFirstCard);
  EXPECT_EQ(editor().document().name, "mine");
}

TEST_F(StartScreen, AFileThatCannotBeReadHasACardWithoutAPicture) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "scene.json", "{}");
  editor().files().open(folder / "scene.json");
  const Shape shape = disk({});
  write_mesh(folder / "mine.obj", shape.triangles, shape.rest);
  editor().files().open(folder / "mine.obj");
  write_file_atomically(folder / "mine.obj", "no mesh");
  headless_.key(Key::n, kControl);
  EXPECT_TRUE(wait_for_pictures());
  headless_.click(kFirstCard);
  EXPECT_TRUE(editor().document().is_empty());
  EXPECT_FALSE(editor().messages().toasts().empty()) << "whoever opens it is told why";
}

/// What the first window shows is there to be played with, not to be dressed.
TEST_F(StartScreen, ADrawingDroppedOnAnUntouchedSampleIsADocumentOfItsOwn) {
  const TemporaryFolder folder;
  write_ring(folder / "ring.png", 60);
  editor().files().open_sample(welcome_scene());
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  headless_.ui().receive(FilesDropped{{folder / "ring.png"}});
  ASSERT_TRUE(headless_.wait_until([&] { return editor().files().image_import().is_ready(); }));
  headless_.key(Key::enter);
  EXPECT_EQ(editor().document().name, "ring");
}

TEST_F(StartScreen, ADrawingDroppedOnASampleInWorkBecomesItsTexture) {
  const TemporaryFolder folder;
  write_ring(folder / "ring.png", 60);
  editor().files().open_sample(welcome_scene());
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  editor().selection().select({editor().document().handles.front().id});
  headless_.key(Key::del);
  headless_.ui().receive(FilesDropped{{folder / "ring.png"}});
  headless_.settle();
  EXPECT_EQ(editor().document().name, "welcome");
  EXPECT_EQ(editor().document().texture, folder / "ring.png");
}

TEST_F(StartScreen, GoesAwayWithTheDocument) {
  editor().files().open_shape(bar(4, 1, 3), "bar");
  headless_.calm_down();
  headless_.click(kFirstCard);
  EXPECT_EQ(editor().document().name, "bar");
  EXPECT_FALSE(headless_.next_frame()) << "nobody waits for pictures";
}

}  // namespace
}  // namespace foldless::test

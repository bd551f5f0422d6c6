// SPDX-License-Identifier: GPL-3.0-or-later
// The question before what another program saved is replaced.
#include <gtest/gtest.h>

#include "core/files/atomic_file.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// A scene that was changed here, and written by another program.
class Overwriting : public testing::Test {
 protected:
  Overwriting() {
    editor().files().open_shape(bar(4, 1, 5), "bar");
    EXPECT_TRUE(editor().files().save_as(file_));
    headless_.calm_down();
    headless_.click(headless_.window_point({0, 0.5}));
    EXPECT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
    headless_.calm_down();
    before_ = headless_.picture();
    folder_.write("bar.json", "theirs");
    headless_.key(Key::s, kControl);
  }
  Editor& editor() { return headless_.editor(); }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "bar.json";
  HeadlessEditor headless_{{1000, 640}};
  Image before_;
};

TEST_F(Overwriting, IsAskedAboutAndEscLeavesBothAsTheyAre) {
  EXPECT_GT(differing_pixels(before_, headless_.picture()), 10000) << "the question";
  EXPECT_EQ(read_file(file_), "theirs");
  headless_.key(Key::escape);
  headless_.calm_down();
  EXPECT_EQ(differing_pixels(before_, headless_.picture()), 0);
  EXPECT_EQ(read_file(file_), "theirs");
  EXPECT_TRUE(editor().files().is_dirty());
}

TEST_F(Overwriting, EnterSavesUnderAnotherName) {
  headless_.key(Key::enter);
  headless_.key(Key::a, kControl);
  headless_.type((folder_ / "mine.json").string());
  headless_.key(Key::enter);
  EXPECT_EQ(read_file(file_), "theirs");
  EXPECT_EQ(editor().files().path(), folder_ / "mine.json");
  EXPECT_FALSE(editor().files().is_dirty());
}

TEST_F(Overwriting, OReplacesIt) {
  headless_.key(Key::o);
  EXPECT_NE(read_file(file_), "theirs");
  EXPECT_FALSE(editor().files().is_dirty());
}

}  // namespace
}  // namespace foldless::test

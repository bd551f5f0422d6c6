// SPDX-License-Identifier: GPL-3.0-or-later
// The iterations as numbered pictures, from the export dialog.
#include "app/gui/sequence_export.h"

#include <gtest/gtest.h>

#include "app/gui/samples.h"
#include "core/error.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class Sequences : public testing::Test {
 protected:
  Sequences() {
    editor().files().open_sample(welcome_scene());
    headless_.calm_down();
    const Handle& handle = editor().document().handles.front();
    const Vec2 from = headless_.window_point(headless_.position(handle.vertex));
    headless_.press(from);
    headless_.move(from + Vec2(30, -40));
    headless_.release(from + Vec2(30, -40));
    headless_.wait_until([this] { return editor().playback().can_scrub(); });
    headless_.calm_down();
  }

  Editor& editor() { return headless_.editor(); }
  PictureOptions options() { return {.layers = exported_layers(editor())}; }
  std::size_t iterations() { return editor().playback().iterations().size(); }
  std::size_t files_in(const std::filesystem::path& folder) {
    using Files = std::filesystem::directory_iterator;
    return static_cast<std::size_t>(std::distance(Files(folder), Files()));
  }
  /// Goes on until `sequence` has ended.
  bool finish(SequenceExport& sequence) {
    return headless_.wait_until([&] {
      sequence.update(editor(), ++time_);
      return !sequence.is_busy();
    });
  }

  HeadlessEditor headless_;
  TemporaryFolder folder_;
  double time_ = 0;
};

TEST_F(Sequences, EveryIterationIsWrittenFromTheDialogWhileTheWindowLives) {
  ASSERT_GT(iterations(), 1U);
  headless_.key(Key::e, kControl);
  ASSERT_TRUE(headless_.find_words("PNG sequence"));
  headless_.click(*headless_.find_words("PNG sequence"));
  headless_.key(Key::enter);
  headless_.key(Key::a, kControl);
  headless_.type((folder_ / "film").string());
  headless_.key(Key::enter);
  EXPECT_TRUE(headless_.ui().is_exporting());
  ASSERT_TRUE(headless_.wait_until([this] { return !headless_.ui().is_exporting(); }));
  EXPECT_EQ(files_in(folder_ / "film"), iterations());
  const Image first = load_image(folder_ / "film" / "000001.png");
  EXPECT_EQ(first.width, editor().canvas().width);
  headless_.calm_down();
  std::array<char, 16> last{};
  std::snprintf(last.data(), last.size(), "%06zu.png", iterations());
  const Image newest = load_image(folder_ / "film" / last.data());
  EXPECT_GT(differing_pixels(first, newest), 100);
  EXPECT_EQ(read_png_texts(folder_ / "film" / "000001.png")["Iteration"], "1");
}

TEST_F(Sequences, OnePictureSaysTheNumberOfItsIterationThatIsOnScreen) {
  editor().playback().scrub(iterations() / 2);
  headless_.calm_down();
  const std::string number = std::to_string(iterations() / 2 + 1);
  EXPECT_TRUE(headless_.find_words("Iteration " + number + " of " + std::to_string(iterations())));
  headless_.key(Key::e, kControl);
  headless_.key(Key::enter);
  headless_.key(Key::a, kControl);
  headless_.type((folder_ / "one.png").string());
  headless_.key(Key::enter);
  EXPECT_EQ(read_png_texts(folder_ / "one.png")["Iteration"], number);
}

TEST_F(Sequences, CancelledNothingIsLeft) {
  SequenceExport sequence;
  sequence.start(folder_ / "film", editor(), options());
  ASSERT_TRUE(headless_.wait_until([&] {
    sequence.update(editor(), ++time_);
    return sequence.written() > 0;
  }));
  EXPECT_GT(files_in(folder_ / "film"), 0U);
  sequence.cancel();
  ASSERT_TRUE(finish(sequence));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "film"));
}

TEST_F(Sequences, NothingIsLeftWhereTheProgramEnds) {
  {
    SequenceExport sequence;
    sequence.start(folder_ / "film", editor(), options());
    ASSERT_TRUE(headless_.wait_until([&] {
      sequence.update(editor(), ++time_);
      return sequence.written() > 0;
    }));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "film"));
}

TEST_F(Sequences, KeepTheViewThatTheyBeganWith) {
  SequenceExport sequence;
  sequence.start(folder_ / "film", editor(), options());
  headless_.key(Key::home);
  editor().files().open_sample(welcome_scene());
  const std::size_t count = sequence.count();
  EXPECT_FALSE(sequence.seconds_left());
  ASSERT_TRUE(finish(sequence));
  EXPECT_EQ(files_in(folder_ / "film"), count);
}

TEST_F(Sequences, OnlyGoIntoANewFolderAndOneAtATime) {
  folder_.write("there", "");
  SequenceExport sequence;
  EXPECT_THROW(sequence.start(folder_ / "there", editor(), options()), Error);
  EXPECT_THROW(sequence.start(folder_ / "none" / "film", editor(), options()), Error);
  EXPECT_FALSE(sequence.is_busy());
  sequence.start(folder_ / "film", editor(), options());
  EXPECT_THROW(sequence.start(folder_ / "other", editor(), options()), Error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other"));
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Animations written from the export dialog, in the background.
#include "app/gui/animation_export.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/scene/baked_io.h"
#include "tests/app/gui/animated_bar.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/troubled_disk.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

const AnimationFormat& format_of(const fs::path& path) { return *find_animation_format(path); }

/// Files and folders in a folder, hidden ones too.
std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

class AnimationExports : public testing::Test {
 protected:
  AnimationExports() {
    headless_.ui().settings().theme = Theme::light;  // that of the command line
    open_animated_bar(headless_);
  }

  Editor& editor() { return headless_.editor(); }
  AnimationChoice choice(const fs::path& path) {
    AnimationChoice choice;
    choice.format = format_of(path);
    choice.size = PictureSize{64, 48};
    return choice;
  }
  void start(const fs::path& path) { writing_->start(path, editor(), choice(path)); }
  bool update() {
    writing_->update(editor(), ++time_);
    return !writing_->is_busy();
  }
  bool finish() {
    return headless_.wait_until([this] { return update(); });
  }
  std::string said() { return editor().messages().log().back().text; }
  /// Ctrl+E, Enter, a name, Enter.
  void export_by_keys(const fs::path& path) {
    headless_.key(Key::e, kControl);
    headless_.key(Key::enter);
    headless_.key(Key::a, kControl);
    headless_.type(path.string());
    headless_.key(Key::enter);
  }

  HeadlessEditor headless_;
  TemporaryFolder folder_;
  std::optional<AnimationExport> writing_{std::in_place};
  double time_ = 0;
};

TEST_F(AnimationExports, AreAskedForByTheKeyOfTheDialogWhileTheTimeLineIsOpen) {
  editor().motion().keys().set_cycle(
      {4, false});  // Pictures as large as a dialog offers take long.
  export_by_keys(folder_ / "bar.webp");
  EXPECT_TRUE(headless_.ui().is_exporting());
  ASSERT_TRUE(headless_.wait_until([this] { return !headless_.ui().is_exporting(); }));
  EXPECT_EQ(names_in(folder_.path()), std::set<std::string>{"bar.webp"});
  EXPECT_EQ(read_file(folder_ / "bar.webp").substr(8, 4), "WEBP");
  EXPECT_EQ(said(), "Wrote " + (folder_ / "bar.webp").string() + ": 4 frames");
}

TEST_F(AnimationExports, HaveTheBytesThatTheCommandLineWrites) {
  ASSERT_TRUE(editor().files().save_as(folder_ / "bar.json"));
  for (const char* ending : {".png", ".gif", ".webp", ".foldless", ".glb"}) {
    const std::string own = folder_ / (std::string("own") + ending);
    const std::string other = folder_ / (std::string("other") + ending);
    start(own);
    ASSERT_TRUE(finish()) << ending;
    const std::string command = std::string(FOLDLESS_PROGRAM) + " animate --quiet --size 64x48 " +
                                (folder_ / "bar.json").string() + " -o " + other;
    ASSERT_EQ(std::system(command.c_str()), 0) << ending;
    EXPECT_EQ(read_file(own), read_file(other)) << ending;
  }
}

TEST_F(AnimationExports, OfEveryFormatAreWritten) {
  for (const AnimationFormat& format : animation_formats()) {
    if (format.kind == AnimationFormat::Kind::video) continue;  // by ffmpeg, which may not be there
    const std::string name = "bar" + std::string(format.ending);
    start(folder_ / name);
    ASSERT_TRUE(finish()) << name;
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
    EXPECT_EQ(said().find("Wrote "), 0U) << said();
  }
  EXPECT_EQ(names_in(folder_ / "bar").size(), 25U);
}

TEST_F(AnimationExports, SayThatABakedOneIsProved) {
  start(folder_ / "bar.foldless");
  ASSERT_TRUE(finish());
  EXPECT_NE(said().find("every moment of the animation proved injective"), std::string::npos)
      << said();
  EXPECT_TRUE(failures_of(read_baked(folder_ / "bar.foldless")).empty());
}

TEST_F(AnimationExports, WithMoreFramesASecondAreSolvedAnew) {
  AnimationChoice more = choice("bar");
  more.fps = 2 * editor().motion().animation().fps;
  writing_->start(folder_ / "bar", editor(), more);
  ASSERT_TRUE(finish());
  EXPECT_EQ(names_in(folder_ / "bar").size(), 49U);
}

TEST_F(AnimationExports, OfSomeFramesAndOnASheetWithSidesOfPowersOfTwo) {
  AnimationChoice some = choice("bar.json");
  some.range = std::array{3, 9};
  some.power_of_two = true;
  writing_->start(folder_ / "bar.json", editor(), some);
  ASSERT_TRUE(finish());
  EXPECT_EQ(said(), "Wrote " + (folder_ / "bar.json").string() + ": 7 frames");
  const Image sheet = load_image(folder_ / "bar.png");
  EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(sheet.width)));
  EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(sheet.height)));
  some.range = std::array{3, 25};
  writing_->start(folder_ / "other.json", editor(), some);
  ASSERT_TRUE(finish());
  EXPECT_EQ(said(), "The frames to be written end with 25, but the last is 24; choose them anew.");
}

TEST_F(AnimationExports, AreOfTheFramesThatAreTypedInTheDialog) {
  headless_.key(Key::e, kControl);
  headless_.settle();
  const auto frames = headless_.find_words("Some of the frames");
  ASSERT_TRUE(frames);
  headless_.click(*frames);
  headless_.settle();
  EXPECT_FALSE(headless_.find_words("Sides that are powers of two")) << "of sheets alone";
  headless_.click(*frames + Vec2(85, 0));
  headless_.key(Key::a, kControl);
  headless_.type("20");
  headless_.key(Key::tab);
  headless_.settle();
  headless_.click(headless_.find_words("Choose a file…").value());
  headless_.settle();
  headless_.key(Key::a, kControl);
  headless_.type((folder_ / "some.webp").string());
  headless_.key(Key::enter);
  ASSERT_TRUE(headless_.wait_until([this] { return !headless_.ui().is_exporting(); }));
  EXPECT_EQ(said(), "Wrote " + (folder_ / "some.webp").string() + ": 5 frames");
}

TEST_F(AnimationExports, KeepWhatTheyBeganWith) {
  start(folder_ / "bar");
  editor().files().new_document();
  editor().files().open_shape(bar(2, 1, 2), "other");
  ASSERT_TRUE(finish());
  EXPECT_EQ(names_in(folder_ / "bar").size(), 25U);
}

TEST_F(AnimationExports, CancelledLeaveNothing) {
  for (const AnimationFormat& format : animation_formats()) {
    if (format.kind == AnimationFormat::Kind::video) continue;
    const fs::path path = folder_ / ("bar" + std::string(format.ending));
    AnimationChoice many_frames = choice(path);
    many_frames.fps = 20 * editor().motion().animation().fps;
    writing_->start(path, editor(), many_frames);
    const auto has_begun = [&] {
      update();
      return writing_->share().value_or(0) > 0.3F;
    };
    // Nobody waits for a bake, which might be done then.
    ASSERT_TRUE(format.is_baked() || headless_.wait_until(has_begun)) << format.ending;
    ASSERT_TRUE(writing_->is_busy()) << format.ending;
    writing_->cancel();
    ASSERT_TRUE(finish()) << format.ending;
    EXPECT_EQ(said(), "The animation was cancelled; nothing was kept.");
    EXPECT_TRUE(names_in(folder_.path()).empty()) << format.ending;
  }
}

TEST_F(AnimationExports, AreCancelledByTheirButton) {
  editor().motion().keys().set_cycle({400, false});
  export_by_keys(folder_ / "bar");
  ASSERT_TRUE(headless_.wait_until(
      [this] { return headless_.find_words("Writing the animation").has_value(); }));
  ASSERT_TRUE(headless_.find_words("Cancel"));
  headless_.click(*headless_.find_words("Cancel"));
  ASSERT_TRUE(headless_.wait_until([this] { return !headless_.ui().is_exporting(); }));
  EXPECT_TRUE(names_in(folder_.path()).empty());
}

TEST_F(AnimationExports, LeaveNothingWhereTheProgramEnds) {
  start(folder_ / "bar");
  ASSERT_TRUE(headless_.wait_until([this] {
    update();
    return writing_->share().value_or(0) > 0.2F;
  }));
  EXPECT_EQ(names_in(folder_.path()).size(), 1U) << "the hidden folder";
  writing_.reset();
  EXPECT_TRUE(names_in(folder_.path()).empty());
}

TEST_F(AnimationExports, OnAFullDiskSayOneSentenceAndLeaveNothing) {
  TroubledDisk disk;
  const auto before = names_in(disk.path());
  for (const char* name : {"a.png", "a.gif", "a.webp", "a.foldless", "a.glb", "a"}) {
    disk.fill();
    start(disk / name);
    ASSERT_TRUE(finish()) << name;
    EXPECT_NE(said().find((disk / name).string()), std::string::npos) << said();
    EXPECT_NE(said().find("cannot be written"), std::string::npos) << said();
    disk.end();
    EXPECT_EQ(names_in(disk.path()), before) << name;
  }
}

TEST_F(AnimationExports, NeverReplaceWhatTheyAreMadeOf) {
  ASSERT_TRUE(editor().files().save_as(folder_ / "bar.json"));
  const std::string scene = read_file(folder_ / "bar.json");
  const std::string problem = error_of([&] { start(folder_ / "bar.json"); });
  EXPECT_NE(problem.find("the animation is made of it"), std::string::npos) << problem;
  EXPECT_FALSE(writing_->is_busy());
  EXPECT_EQ(read_file(folder_ / "bar.json"), scene);
}

TEST_F(AnimationExports, NeedKeysAndAreOneAtATime) {
  start(folder_ / "bar");
  EXPECT_THROW(start(folder_ / "other"), Error);
  writing_->cancel();
  ASSERT_TRUE(finish());
  editor().motion().keys().select(keys_of(editor().motion().animation()));
  editor().motion().keys().delete_selected();
  EXPECT_THROW(start(folder_ / "bar"), Error);
}

TEST_F(AnimationExports, VideosAreGreyWithTheirReasonWithoutFfmpeg) {
  const char* const path = std::getenv("PATH");
  const std::string before = path ? path : "";
  setenv("PATH", folder_.path().c_str(), 1);
  headless_.key(Key::e, kControl);
  headless_.settle();
  ASSERT_TRUE(headless_.find_words("Animated WebP (.webp)"));
  headless_.click(*headless_.find_words("Animated WebP (.webp)"));
  headless_.settle();
  const auto video = headless_.find_words("MP4 video (.mp4): needs ffmpeg, which is not installed");
  setenv("PATH", before.c_str(), 1);
  ASSERT_TRUE(video);
  headless_.click(*video);
  headless_.settle();
  EXPECT_FALSE(headless_.find_words("MP4 video (.mp4)")) << "it cannot be chosen";
  if (!headless_.find_words("Animated GIF (.gif)"))
    headless_.click(headless_.find_words("Animated WebP (.webp)").value());
  headless_.click(headless_.find_words("Animated GIF (.gif)").value());
  headless_.settle();
  EXPECT_TRUE(headless_.find_words("Animated GIF (.gif)"));
  EXPECT_FALSE(headless_.find_words("Animated WebP (.webp)"));
}

}  // namespace
}  // namespace foldless::test

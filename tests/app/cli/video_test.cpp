// SPDX-License-Identifier: GPL-3.0-or-later
// Videos, with programs that stand for ffmpeg, and with ffmpeg where it is there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/data_path.h"
#include "core/files/atomic_file.h"
#include "render/image.h"
#include "tests/app/cli/command.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::TemporaryFolder;

class Video : public testing::Test {
 protected:
  Video() : path_(std::getenv("PATH")) {}
  ~Video() override { setenv("PATH", path_.c_str(), 1); }

  /// From now on ffmpeg is this script.
  void replace_ffmpeg(const std::string& script) {
    const fs::path program = programs_ / "ffmpeg";
    write_file_atomically(program, "#!/bin/sh\n" + script);
    fs::permissions(program, fs::perms(0755));
    setenv("PATH", (programs_.path().string() + ":" + path_).c_str(), 1);
  }
  Ended animate(const std::string& output, const std::string& size = "48x32") const {
    return test::run(
        {"animate", data_path("assets/scenes/snap.json").string(), "-o", output, "--size", size});
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  TemporaryFolder folder_, programs_;

 private:
  std::string path_;
};

TEST_F(Video, FfmpegIsGivenEveryPicture) {
  replace_ffmpeg(
      "for last; do :; done\necho \"$@\" > \"$(dirname \"$0\")/arguments\"\ncat > \"$last\"\n");
  const Ended ended = animate(folder_ / "a b;c.mp4");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string bytes = read_file(folder_ / "a b;c.mp4");
  constexpr std::size_t kPicture = 4 * 48 * 32;
  ASSERT_EQ(bytes.size(), 36 * kPicture);
  EXPECT_EQ(entries(), 1U);
  ASSERT_EQ(animate(folder_ / "pictures").status, 0);
  for (const std::size_t i : {0U, 17U, 35U}) {
    std::string name = std::to_string(i);
    name.insert(0, 6 - name.size(), '0');
    const Image picture = load_image(fs::path(folder_ / "pictures") / (name + ".png"));
    EXPECT_EQ(bytes.substr(i * kPicture, kPicture),
              std::string(picture.pixels.begin(), picture.pixels.end()))
        << i;
  }
  const std::string arguments = read_file(programs_ / "arguments");
  EXPECT_NE(arguments.find("-s 48x32 -r 24 -i pipe:0"), arguments.npos) << arguments;
  EXPECT_NE(arguments.find("-f mp4"), arguments.npos);
  EXPECT_NE(arguments.find("-xerror"), arguments.npos) << "it goes on after errors otherwise";
}

TEST_F(Video, WhatFfmpegSaysLastIsTold) {
  replace_ffmpeg("echo one >&2\necho 'Unknown encoder' >&2\nexit 1\n");
  const Ended ended = animate(folder_ / "a.mp4", "480x320");
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "foldless: " + folder_ / "a.mp4" + ": ffmpeg failed: Unknown encoder\n");
  EXPECT_EQ(entries(), 0U);
}

/// ffmpeg's status is 0 for WebM on a full disk, and 1 for MP4.
TEST_F(Video, AFullDiskIsToldAsOfOtherFilesWhateverTheStatus) {
  for (const char* const status : {"0", "1"}) {
    replace_ffmpeg(
        "cat > /dev/null\nfor last; do :; done\n"
        "echo \"Error writing trailer of $last: No space left on device\" >&2\n"
        "echo 'Conversion failed!' >&2\nexit " +
        std::string(status) + "\n");
    const Ended ended = animate(folder_ / "a.webm");
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "foldless: " + folder_ / "a.webm" +
                             ": cannot be written: No space left on device; make room there, or "
                             "choose another folder\n");
    EXPECT_EQ(entries(), 0U);
  }
}

TEST_F(Video, WhatFfmpegComplainsOfIsAFailureAndNamesTheFileThatWasAskedFor) {
  replace_ffmpeg("cat > /dev/null\nfor last; do :; done\necho \"$last: Input/output error\" >&2\n");
  const Ended ended = animate(folder_ / "a.webm");
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "foldless: " + folder_ / "a.webm" +
                           ": ffmpeg failed: " + folder_ / "a.webm" + ": Input/output error\n");
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Video, AnFfmpegThatEndsEarlyWithoutAWordHasFailed) {
  replace_ffmpeg("exit 0\n");
  const Ended ended = animate(folder_ / "a.mp4", "480x320");
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err,
            "foldless: " + folder_ / "a.mp4" + ": ffmpeg ended before it had all pictures\n");
}

TEST_F(Video, AnEarlierFileStaysWhereItFails) {
  write_file_atomically(folder_ / "a.webm", "earlier");
  replace_ffmpeg("cat > /dev/null\nexit 3\n");
  EXPECT_EQ(animate(folder_ / "a.webm").status, 2);
  EXPECT_EQ(read_file(folder_ / "a.webm"), "earlier");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Video, WithoutFfmpegOneIsTold) {
  setenv("PATH", programs_.path().c_str(), 1);
  const Ended ended = animate(folder_ / "a.mp4");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("videos are made by ffmpeg, which is not there"), std::string::npos)
      << ended.err;
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Video, FfprobeFindsItsFramesAndItsRate) {
  if (std::system("command -v ffmpeg ffprobe > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "there is no ffmpeg";
  for (const char* const name : {"a.mp4", "a.webm"}) {
    const Ended ended = animate(folder_ / name, "47x31");
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::string said = folder_ / "said";
    ASSERT_EQ(std::system(("ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                           "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 " +
                           folder_ / name + " > " + said)
                              .c_str()),
              0);
    EXPECT_EQ(read_file(said).substr(0, 14), "48,32,24/1,36\n") << name;
  }
}

}  // namespace
}  // namespace foldless

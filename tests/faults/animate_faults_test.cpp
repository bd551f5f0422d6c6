// SPDX-License-Identifier: GPL-3.0-or-later
// The same of animations: an export is the old one, the new one, or, of files that belong together,
// on its way, and the next export of its name leaves nothing hidden.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>
#include <set>

#include "core/files/atomic_file.h"
#include "tests/faults/operation.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

/// A square of which a corner moves.
constexpr const char* kMovingSquare = R"({"version": 1, "energy": "arap",
 "mesh": {"vertices": [[0,0],[1,0],[1,1],[0,1],[0.5,0.5]],
          "triangles": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]},
 "handles": [{"vertex": 0, "target": [0,0], "id": 1}, {"vertex": 2, "target": [1,1], "id": 2}],
 "animation": {"fps": 10, "frames": 3, "tracks": [
  {"handle": 2, "position": [{"frame": 0, "value": [1,1]}, {"frame": 2, "value": [1.5,1.2]}]}]}})";

bool is_visible(const std::string& path) {
  return !path.starts_with('.') && path.find("/.") == path.npos;
}

/// An export of an animation under one name, over an earlier one.
class Export {
 public:
  explicit Export(std::string main) : main_(std::move(main)) {
    notes_.write("scene.json", kMovingSquare);
    fs::create_directory(out());
    if (has_earlier()) {
      EXPECT_EQ(run("", {"--range", "0-1"}).status, 0);
    }
    earlier_ = files_in(out());
    const Faulted ended = run("");
    EXPECT_EQ(ended.status, 0) << ended.err;
    newer_ = files_in(out());
    EXPECT_NE(newer_, earlier_);
    EXPECT_FALSE(newer_.empty());
  }

  /// Every call of a kind that writes fails, and is the last.
  void bears(const std::string& kind, FaultCounts& counts) {
    int calls = 0;
    for (; fails_well(kind + ':' + std::to_string(calls + 1)); ++calls) counts.failed(kind);
    for (int n = 1; n <= calls; ++n, counts.last(kind))
      EXPECT_TRUE(dies_well(kind + ':' + std::to_string(n) + ":kill")) << "as many calls as before";
  }
  void bears_little_memory(FaultCounts& counts) {
    for (long n = 1; fails_well(memory_fault(n)); ++n) counts.failed("new");
  }

  void is_killed_after(std::chrono::microseconds time) {
    SCOPED_TRACE(time.count());
    begin();
    run_and_kill(arguments(), time);
    const Files files = files_in(out());
    expect_whole(files);
    if (left_.insert(files).second) expect_done_by_the_next();
  }

  std::string fault_of_full_disk() {
    begin();
    const Faulted ended = run("write:1");
    EXPECT_TRUE(ended.has_happened);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(files_in(out()), earlier_);
    return ended.err;
  }

 private:
  /// A folder of pictures has to be a new one.
  bool has_earlier() const { return main_.find('.') != main_.npos; }
  fs::path out() const { return notes_ / "out"; }
  std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> result{
        "animate", notes_ / "scene.json", "-o", out() / main_, "--size", "24x24", "--quiet"};
    result.insert(result.end(), more.begin(), more.end());
    return result;
  }
  Faulted run(const std::string& fault, const std::vector<std::string>& more = {}) const {
    return run_with_fault(arguments(more), fault, out());
  }
  void begin() const { write_files(out(), earlier_); }

  bool fails_well(const std::string& fault) {
    SCOPED_TRACE(main_ + " " + fault);
    begin();
    const Faulted ended = run(fault);
    if (!ended.has_happened) return false;
    const Files files = files_in(out());
    expect_whole(files);
    if (ended.status == 0) {
      EXPECT_FALSE(fault.starts_with("fsync:")) << "what it wrote may not be on the disk";
      EXPECT_EQ(visible(files), newer_) << "it says that it has done it";
      return true;
    }
    EXPECT_EQ(ended.status, 2) << ended.err;
    EXPECT_TRUE(ended.err.starts_with("foldless: ")) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_EQ(ended.err.find(".foldless-"), ended.err.npos) << ended.err;
    for (const auto& [name, bytes] : files)
      EXPECT_TRUE(is_visible(name) || name.starts_with(committed()) || fault.starts_with("unlink"))
          << name << " is left";
    return true;
  }

  bool dies_well(const std::string& fault) {
    SCOPED_TRACE(main_ + " " + fault);
    begin();
    if (!run(fault).has_happened) return false;
    const Files files = files_in(out());
    expect_whole(files);
    if (left_.insert(files).second) expect_done_by_the_next();
    return true;
  }

  void expect_done_by_the_next() {
    // A folder of pictures that is whole must not be there.
    if (!has_earlier() && visible(files_in(out())) == newer_) fs::remove_all(out() / main_);
    const Faulted again = run("");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(files_in(out()), newer_) << "nothing hidden either";
  }

  static Files visible(Files files) {
    std::erase_if(files, [](const auto& file) { return !is_visible(file.first); });
    return files;
  }
  std::string committed() const { return '.' + main_ + ".foldless-committed/"; }

  /// One result as a whole; or, where it has not taken all its names yet, no main file but its own.
  void expect_whole(const Files& files) const {
    Files seen = visible(files);
    if (seen == earlier_ || seen == newer_) return;
    EXPECT_TRUE(!seen.contains(main_) || seen[main_] == newer_.at(main_));
    for (const auto& [name, bytes] : files)
      if (name.starts_with(committed())) seen[name.substr(committed().size())] = bytes;
    EXPECT_EQ(seen, newer_);
  }

  TemporaryFolder notes_;
  std::string main_;
  Files earlier_, newer_;
  std::set<Files> left_;  ///< by exports that were killed
};

using KindsOfCalls = std::vector<const char*>;
const KindsOfCalls kAllKinds{"open", "write", "fsync", "syncfolder", "close", "rename", "unlink"};

void expect_it_bears(const KindsOfCalls& kinds, const std::string& main) {
  Export result(main);
  FaultCounts counts;
  for (const char* kind : kinds) result.bears(kind, counts);
  if (wants_all_faults()) result.bears_little_memory(counts);
  std::cout << main << ":\n";
  const int least = std::min(4, static_cast<int>(kinds.size()));
  EXPECT_GE(counts.all_failed(), least);
  EXPECT_GE(counts.all_last(), least);
}
void expect_it_bears_everything(const std::string& main) { expect_it_bears(kAllKinds, main); }

// What is around the writing of one file is the same of all: by default of the first only.
TEST(AnimateFaults, PicturesInOneFile) {
  const KindsOfCalls of_others = wants_all_faults() ? kAllKinds : KindsOfCalls{"write", "rename"};
  expect_it_bears_everything("a.gif");
  for (const char* main : {"a.png", "a.webp"}) expect_it_bears(of_others, main);
}

TEST(AnimateFaults, BakedFiles) {
  for (const char* main : {"a.foldless", "a.glb"}) expect_it_bears_everything(main);
}

TEST(AnimateFaults, ASpriteSheetWithItsPicture) { expect_it_bears_everything("a.json"); }

TEST(AnimateFaults, ASkeletonWithItsAtlasAndItsPicture) {
  expect_it_bears_everything("a.spine.json");
}

TEST(AnimateFaults, ASceneWithItsPicture) { expect_it_bears_everything("a.tscn"); }

TEST(AnimateFaults, AFolderOfPictures) { expect_it_bears_everything("pictures"); }

/// A program that stands for ffmpeg.
class AnimateFaultsOfVideos : public testing::Test {
 protected:
  AnimateFaultsOfVideos() : path_(std::getenv("PATH")) {
    const fs::path program =
        programs_.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\nexec cat > \"$last\"\n");
    fs::permissions(program, fs::perms(0755));
    setenv("PATH", (programs_.path().string() + ":" + path_).c_str(), 1);
  }
  ~AnimateFaultsOfVideos() override { setenv("PATH", path_.c_str(), 1); }

 private:
  TemporaryFolder programs_;
  std::string path_;
};

TEST_F(AnimateFaultsOfVideos, AVideo) {
  Export result("a.mp4");
  for (const char* kind : {"rename", "fsync"}) {
    FaultCounts counts;
    result.bears(kind, counts);
    EXPECT_GE(counts.all_failed(), 1) << kind;
    EXPECT_GE(counts.all_last(), 1) << kind;
  }
  for (int i = 1; i < 8; ++i) result.is_killed_after(std::chrono::milliseconds(20 * i));
}

TEST(AnimateFaults, KilledAtAnyMoment) {
  std::mt19937 random(7);
  for (const char* main :
       {"a.gif", "a.webp", "a.json", "a.glb", "a.spine.json", "a.tscn", "a.foldless", "pictures"}) {
    Export result(main);
    for (int i = 0; i < 6; ++i)
      result.is_killed_after(std::chrono::microseconds(random() % 150'000));
  }
}

TEST(AnimateFaults, AFullDiskIsOneSentence) {
  for (const char* main : {"a.gif", "a.png", "a.webp", "a.foldless", "a.glb", "a.json",
                           "a.spine.json", "a.tscn", "pictures"}) {
    const std::string said = Export(main).fault_of_full_disk();
    EXPECT_NE(said.find("No space left on device; make room there"), said.npos) << said;
    EXPECT_NE(said.find("out/"), said.npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  }
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/autosave_folder.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

void write_copy(const AutosaveFolder& folder) { std::ofstream(folder.next_copy()) << "{}"; }

class AutosaveFolderTest : public testing::Test {
 protected:
  fs::path root() const { return folder_ / "state/autosave"; }
  std::size_t lost() const { return find_lost_work(root()).folders.size(); }

  TemporaryFolder folder_;
};

TEST_F(AutosaveFolderTest, OneThatIsInUseIsNobodyElses) {
  std::optional<AutosaveFolder> folder = AutosaveFolder::create(root());
  write_copy(*folder);
  EXPECT_FALSE(AutosaveFolder::take(folder->path()));
  EXPECT_EQ(lost(), 0U);
  const fs::path path = folder->path();
  folder.reset();
  EXPECT_TRUE(AutosaveFolder::take(path));
  EXPECT_EQ(lost(), 1U);
}

TEST_F(AutosaveFolderTest, TheNewestFiveCopiesStay) {
  AutosaveFolder folder = AutosaveFolder::create(root());
  for (int i = 0; i < 12; ++i) {
    write_copy(folder);
    folder.trim();
  }
  const auto copies = folder.copies();
  ASSERT_EQ(copies.size(), 5U);
  EXPECT_EQ(copies.front().filename(), "000012.json");
  EXPECT_EQ(copies.back().filename(), "000008.json");
}

TEST_F(AutosaveFolderTest, RemembersWhatTheCopiesAreOf) {
  AutosaveFolder folder = AutosaveFolder::create(root());
  EXPECT_EQ(folder.origin(), Origin{});
  const Origin origin{"/home/a b/scene.json", "„Bär“"};
  folder.set_origin(origin);
  EXPECT_EQ(folder.origin(), origin);
  std::ofstream(folder.path() / "origin.json") << "[]";
  EXPECT_EQ(folder.origin(), Origin{});
  std::ofstream(folder.path() / "origin.json")
      << R"({"path": "a", "name": "b"})" << std::string(2 << 20, ' ');
  EXPECT_EQ(folder.origin(), Origin{}) << "nothing of that size is read";
}

TEST_F(AutosaveFolderTest, IsRemovedWithLeftoversButNotWithTheFilesOfOthers) {
  AutosaveFolder folder = AutosaveFolder::create(root());
  const fs::path path = folder.path();
  write_copy(folder);
  folder.set_origin({"", "x"});
  std::ofstream(path / ".000002.json.Ab3dEf") << "cut off";
  folder.remove();
  EXPECT_FALSE(fs::exists(path));

  AutosaveFolder other = AutosaveFolder::create(root());
  std::ofstream(other.path() / "notes.txt") << "mine";
  other.remove();
  EXPECT_TRUE(fs::exists(other.path() / "notes.txt"));
  EXPECT_EQ(std::distance(fs::directory_iterator(other.path()), {}), 1);
}

TEST_F(AutosaveFolderTest, WhatCannotBeRemovedIsLeftWithAllThatIsNewer) {
  AutosaveFolder folder = AutosaveFolder::create(root());
  for (int i = 0; i < 3; ++i) write_copy(folder);
  const fs::path second = folder.copies()[1];
  fs::remove(second);
  fs::create_directory(second);
  std::ofstream(second / "full") << "a folder that is not empty cannot be removed";
  folder.remove();
  ASSERT_EQ(lost(), 1U);
  const auto left = find_lost_work(root()).folders.front().copies();
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left.front().filename(), "000003.json") << "it is what is offered";
}

TEST_F(AutosaveFolderTest, FoldersWithoutCopiesAreNoLostWork) {
  const fs::path empty = AutosaveFolder::create(root()).path();
  fs::create_directory(root() / "something");
  fs::create_directory(root() / ".new-Ab3dEf");
  EXPECT_EQ(lost(), 0U);
  EXPECT_FALSE(fs::exists(empty));
  EXPECT_TRUE(fs::exists(root() / "something")) << "no folder of ours: it has no lock";
}

TEST_F(AutosaveFolderTest, WhatWasLeftWhileAFolderWasMadeIsRemovedWhenItIsOld) {
  const auto make = [&](const char* name, bool has_lock, std::chrono::minutes age) {
    const fs::path path = root() / name;
    fs::create_directories(path);
    if (has_lock) std::ofstream(path / "lock").flush();
    fs::last_write_time(path, fs::file_time_type::clock::now() - age);
    return path;
  };
  using std::chrono::minutes;
  const fs::path empty = make(".new-Ab3dEf", false, minutes(70)),
                 unlocked = make(".new-Bb3dEf", true, minutes(70)),
                 young = make(".new-Cb3dEf", true, minutes(50)),
                 of_others = make(".newer", false, minutes(70));
  const fs::path filled = root() / ".new-Db3dEf";
  fs::create_directory(filled);
  std::ofstream(filled / "drawing.svg").flush();
  fs::last_write_time(filled, fs::file_time_type::clock::now() - minutes(70));
  const fs::path file = root() / ".new-notes";
  std::ofstream(file) << "of somebody else";
  fs::last_write_time(file, fs::file_time_type::clock::now() - minutes(70));
  EXPECT_EQ(lost(), 0U);
  EXPECT_TRUE(fs::exists(file));
  EXPECT_FALSE(fs::exists(empty));
  EXPECT_FALSE(fs::exists(unlocked));
  EXPECT_TRUE(fs::exists(young));
  EXPECT_TRUE(fs::exists(of_others));
  EXPECT_TRUE(fs::exists(filled / "drawing.svg"));
}

TEST_F(AutosaveFolderTest, WhereItCannotBeMadeThatIsSaid) {
  folder_.write("state", "a file");
  try {
    AutosaveFolder::create(root());
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((folder_ / "state").string()), std::string::npos);
  }
}

TEST_F(AutosaveFolderTest, TimesAreInWords) {
  const auto now = fs::file_time_type::clock::now();
  EXPECT_TRUE(time_words(now).starts_with("today ")) << time_words(now);
  EXPECT_TRUE(time_words(now - std::chrono::hours(24)).starts_with("yesterday "));
  const std::string old = time_words(now - std::chrono::hours(24 * 40));
  EXPECT_NE(old.find(':'), std::string::npos) << old;
  EXPECT_EQ(old.find("day"), std::string::npos) << old;
}

}  // namespace
}  // namespace foldless::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/directory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace foldless {
namespace {

/// A folder of its own for each test, removed at its end.
class Directory : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "foldless-dir-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void touch(const std::string& name) { std::ofstream(folder_ / name) << "text"; }
  std::vector<std::string> names(std::span<const std::string> extensions) {
    std::vector<std::string> found;
    for (const auto& entry : list_directory(folder_, extensions).entries)
      found.push_back(entry.name);
    return found;
  }

  std::filesystem::path folder_;
};

TEST_F(Directory, ListsFoldersFirstThenFilesByNameWhateverTheCase) {
  touch("b.json");
  touch("A.json");
  std::filesystem::create_directory(folder_ / "zebra");
  EXPECT_EQ(names({}), (std::vector<std::string>{"zebra", "A.json", "b.json"}));
}

TEST_F(Directory, KeepsFilesOfTheWantedKindsOnly) {
  touch("scene.JSON");
  touch("mesh.obj");
  touch("notes.txt");
  touch(".hidden.json");
  const std::vector<std::string> wanted{".json", ".obj"};
  EXPECT_EQ(names(wanted), (std::vector<std::string>{"mesh.obj", "scene.JSON"}));
}

TEST_F(Directory, MakesAFolderOrSaysWhyNot) {
  EXPECT_EQ(make_folder(folder_, "poses"), "");
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "poses"));
  EXPECT_EQ(make_folder(folder_, "poses"), "“poses” is there already.");
  EXPECT_EQ(make_folder(folder_, ""), "A folder needs a name.");
  EXPECT_EQ(make_folder(folder_, ".."), "A folder cannot be called “..”.");
  EXPECT_EQ(make_folder(folder_, "a/b"), "A folder cannot be called “a/b”.");
  EXPECT_EQ(make_folder(folder_ / "none", "x"),
            "“x” cannot be made here: No such file or directory.");
}

TEST_F(Directory, SaysWhyAFolderCannotBeRead) {
  const auto listing = list_directory(folder_ / "missing", {});
  EXPECT_TRUE(listing.entries.empty());
  EXPECT_FALSE(listing.error.empty());
}

TEST(MatchesFilter, TakesLettersInOrder) {
  EXPECT_TRUE(matches_filter("Gingerbread.json", "gbr"));
  EXPECT_TRUE(matches_filter("anything", ""));
  EXPECT_FALSE(matches_filter("Gingerbread.json", "rbg"));
}

TEST(TypedPath, StartsAtTheFolderHomeOrTheRoot) {
  setenv("HOME", "/home/someone", 1);
  EXPECT_EQ(typed_path("a/../b.obj", "/data"), "/data/b.obj");
  EXPECT_EQ(typed_path("~/b.obj", "/data"), "/home/someone/b.obj");
  EXPECT_EQ(typed_path("/b.obj", "/data"), "/b.obj");
}

TEST(WordsForBytes, UsesDecimalUnits) {
  EXPECT_EQ(words_for_bytes(0), "0 B");
  EXPECT_EQ(words_for_bytes(4200), "4.2 kB");
  EXPECT_EQ(words_for_bytes(17'000'000), "17 MB");
}

}  // namespace
}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/result_folder.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/app/cli/result_reader.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::expect_no_leftovers;
using test::Files;
using test::names_in;
using test::read_text;
using test::result_in;
using test::TemporaryFolder;
using test::write_text;

/// Replaces what is in a folder by these files.
void write_result(const fs::path& folder, const Files& files) {
  ResultFolder result(folder);
  for (const auto& [name, text] : files) {
    fs::create_directories((result.staged() / name).parent_path());
    write_text(result.staged() / name, text);
  }
  result.commit();
}

const Files kOld{{"rest.obj", "old rest"},
                 {"deformed.obj", "old"},
                 {"report.json", "{}"},
                 {"deformed.png", "old picture"},
                 {"frames/000000.obj", "the first"},
                 {"frames/000001.obj", "old"},
                 {"frames/000002.obj", "old"}};
const Files kNew{{"rest.obj", "new rest"},
                 {"deformed.obj", "new"},
                 {"report.json", "{}"},
                 {"frames/000000.obj", "the first"},
                 {"frames/000001.obj", "new"}};

TEST(ResultFolder, HasTheNewFilesAndNoneOfTheOldOnes) {
  const TemporaryFolder folder;
  write_result(folder.path() / "out", kOld);
  EXPECT_EQ(result_in(folder / "out"), kOld);
  write_result(folder.path() / "out", kNew);
  EXPECT_EQ(result_in(folder / "out"), kNew);
  EXPECT_EQ(names_in(folder / "out"), (std::vector<std::string>{"deformed.obj", "frames", kManifest,
                                                                "report.json", "rest.obj"}));
  EXPECT_EQ(names_in(folder / "out/frames"),
            (std::vector<std::string>{"000000.obj", "000001.obj"}));
}

TEST(ResultFolder, GoesOnFromEveryMomentOfASwap) {
  for (std::size_t moved = 0; moved <= kNew.size() + 1; ++moved) {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const fs::path committed = out / ".foldless-committed";
    write_result(out, kOld);
    write_result(folder / "new", kNew);
    fs::rename(folder / "new", committed);
    std::size_t count = 0;
    for (const auto& [name, text] : kNew)
      if (count++ < moved) fs::rename(committed / name, out / name);
    if (moved > kNew.size()) {  // the manifest is the last, after what is not needed any more
      for (const char* name : {"deformed.png", "frames/000002.obj"}) fs::remove(out / name);
      fs::rename(committed / kManifest, out / kManifest);
    }
    EXPECT_EQ(result_in(out), kNew) << moved << " files have their names";
    EXPECT_EQ(read_text(newest_of_result(out / "deformed.obj")), "new");
    { const ResultFolder next(out); }
    EXPECT_EQ(result_in(out), kNew) << moved << " files had their names";
    EXPECT_EQ(names_in(out / "frames").size(), 2U);
    EXPECT_FALSE(fs::exists(out / "deformed.png"));
    expect_no_leftovers(out);
  }
}

TEST(ResultFolder, GoesOnBetweenTheFramesOfTwoResults) {
  const TemporaryFolder folder;
  const fs::path out = folder / "out";
  const fs::path committed = out / ".foldless-committed";
  write_result(out, kOld);
  write_result(folder / "new", kNew);
  fs::rename(folder / "new", committed);
  fs::create_directory(committed / "earlier");
  fs::rename(out / "frames", committed / "earlier/frames");
  EXPECT_EQ(result_in(out), kNew);
  { const ResultFolder next(out); }
  EXPECT_EQ(result_in(out), kNew);
  expect_no_leftovers(out);
}

TEST(ResultFolder, KeepsWhatIsNotItsOwnAmongTheFrames) {
  const TemporaryFolder folder;
  const fs::path frames = folder / "out/frames";
  write_result(folder / "out", kOld);
  write_text(frames / "notes.txt", "mine");
  write_result(folder / "out", kNew);
  EXPECT_EQ(result_in(folder / "out"), kNew);
  EXPECT_EQ(names_in(frames), (std::vector<std::string>{"000000.obj", "000001.obj", "notes.txt"}));
  write_text(frames / "000001.obj", "mine now");
  write_result(folder / "out", {{"rest.obj", "newer rest"}});
  EXPECT_EQ(names_in(frames), (std::vector<std::string>{"000001.obj", "notes.txt"}));
  EXPECT_EQ(read_text(frames / "000001.obj"), "mine now");
}

TEST(ResultFolder, RemovesWhatAKilledRunStagedAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path staged = folder.path() / ".foldless-staged";
  fs::create_directories(staged / "frames");
  for (const char* name : {"rest.obj", ".rest.obj.aB3xYz", "frames/.000004.png.Qw12er"})
    write_text(staged / name, "left");
  { const ResultFolder next(folder.path()); }
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{});
  fs::create_directories(staged);
  write_text(staged / "notes.txt", "mine");
  const std::string error = error_of([&] { const ResultFolder next(folder.path()); });
  EXPECT_NE(error.find("solve did not write"), std::string::npos) << error;
  EXPECT_EQ(read_text(staged / "notes.txt"), "mine");
}

TEST(ResultFolder, IsForOneRunAtATime) {
  const TemporaryFolder folder;
  const ResultFolder one(folder.path());
  const std::string error = error_of([&] { const ResultFolder other(folder.path()); });
  EXPECT_NE(error.find("another run"), std::string::npos) << error;
}

TEST(ResultFolder, LeavesNoFolderThatItMadeForNothing) {
  const TemporaryFolder folder;
  { const ResultFolder nothing(folder.path() / "out"); }
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{});
}

TEST(ResultFolder, AManifestCannotNameFilesElsewhere) {
  const TemporaryFolder folder;
  write_text(folder / "precious.obj", "mine");
  for (const std::string name : {"../precious.obj", "frames/../../precious.obj", "notes.txt"}) {
    fs::create_directories(folder / "out");
    write_text(folder / "out/manifest.json", R"({"foldless_result": 1, "files": [{"name": ")" +
                                                 name + R"(", "bytes": 4, "crc32": "00000000"}]})");
    const std::string error = error_of([&] { const ResultFolder next(folder / "out"); });
    EXPECT_NE(error.find("manifest.json:1: files[0].name"), std::string::npos) << error;
  }
  EXPECT_EQ(read_text(folder / "precious.obj"), "mine");
}

TEST(ResultFolder, AManifestHasSizesThatFilesCanHave) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "out");
  for (const std::string size : {"-1", "1.5", "299999999999999999822"}) {
    write_text(folder / "out/manifest.json",
               R"({"foldless_result": 1, "files": [{"name": "rest.obj", "bytes": )" + size +
                   R"(, "crc32": "00000000"}]})");
    const std::string error = error_of([&] { const ResultFolder next(folder / "out"); });
    EXPECT_NE(error.find("manifest.json:1: files[0].bytes"), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace foldless
